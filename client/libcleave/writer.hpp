// SPDX-License-Identifier: BSD-3-Clause
// Typed writers. Bulk types are loaned, filled in place and published without a copy.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "libcleave/internal/raw_writer.hpp"
#include "libcleave/internal/topic.hpp"
#include "libcleave/stream.hpp"
#include "libcleave/types.hpp"

namespace cleave {

// Memory for one sample: a chunk of shared memory, or of the heap when the network carries it.
// Goes back unused unless it is published. Must not outlive its writer. Contents start undefined.
template <class T>
class Loan {
 public:
  Loan(RawWriter* writer, void* memory) : writer_(writer), memory_(memory) {}
  Loan(Loan&& other) noexcept
      : writer_(other.writer_), memory_(std::exchange(other.memory_, nullptr)) {}
  Loan& operator=(Loan&& other) noexcept {
    if (this != &other) {
      give_back();
      writer_ = other.writer_;
      memory_ = std::exchange(other.memory_, nullptr);
    }
    return *this;
  }
  ~Loan() { give_back(); }

  T& operator*() const { return *static_cast<T*>(memory_); }
  T* operator->() const { return static_cast<T*>(memory_); }

 private:
  template <class U>
  friend class Writer;
  void give_back() {
    if (memory_ != nullptr) writer_->give_back(memory_);
  }
  RawWriter* writer_;
  void* memory_;
};

// Safe to use from several threads.
template <class T>
class Writer {
 public:
  // `sensor` names the topic (topic.hpp); it is ignored for NodeStatus. Throws std::runtime_error.
  Writer(Stream& stream, std::string_view sensor)
      : raw_(stream, topic_of<T>(sensor), WriterDepth{topic_of<T>(sensor).history_depth}) {}
  Writer(Stream& stream, std::string_view sensor, WriterDepth depth)
      : raw_(stream, topic_of<T>(sensor), depth) {}

  // Empty when the pool is exhausted, because readers hoard: drop the frame and count it.
  [[nodiscard]] std::optional<Loan<T>> loan() {
    void* memory = raw_.loan();
    if (memory == nullptr) return std::nullopt;
    return Loan<T>(&raw_, memory);
  }
  // False when DDS refused the sample (it is lost): said in the log, once a second at most.
  [[nodiscard]] bool publish(Loan<T>&& loan) {
    return raw_.publish_loan(std::exchange(loan.memory_, nullptr));
  }
  // Copies (serialises) the sample: for the small types of the public domain.
  [[nodiscard]] bool publish(const T& sample) { return raw_.publish(&sample); }

  // Readers that get what is published now; see RawWriter.
  [[nodiscard]] unsigned matched_readers() const { return raw_.matched_readers(); }
  // Whether loans are chunks of shared memory.
  [[nodiscard]] bool zero_copy() const { return raw_.zero_copy(); }

 private:
  RawWriter raw_;
};

}  // namespace cleave
