// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with a file: all of it is counted, and the first of it is kept as text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace cleave::recording {

class Problems {
 public:
  void add(std::string text) {
    ++count_;
    keep(std::move(text));
  }
  void add(const Problems& others) {
    count_ += others.count_;
    for (const std::string& text : others.texts_) keep(text);
  }

  [[nodiscard]] bool empty() const { return count_ == 0; }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }
  // Those of another, and then these.
  [[nodiscard]] std::vector<std::string> texts_after(std::vector<std::string> others) const {
    others.insert(others.end(), texts_.begin(), texts_.end());
    return others;
  }

 private:
  // A file that is damaged all over must not fill the memory with it.
  static constexpr std::size_t most_texts = 1000;
  void keep(std::string text) {
    if (texts_.size() < most_texts) texts_.push_back(std::move(text));
  }

  std::uint64_t count_ = 0;
  std::vector<std::string> texts_;
};

}  // namespace cleave::recording
