// SPDX-License-Identifier: BSD-3-Clause
// A PCD file while it is read: lines first, and then, perhaps, bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "recording/pcd/error.hpp"

namespace cleave::recording {

class PcdInput {
 public:
  // Opens the file and passes over a byte order mark. Throws PcdError when it cannot be read.
  explicit PcdInput(std::filesystem::path file);

  // The next line without its end: LF, CR LF, or CR where the file's first line ends so; after CR
  // LF the CR is still there, as a blank. A line longer than any point's comes in pieces of 1 MB.
  // False at the end of the file. `line` is good until the next call.
  [[nodiscard]] bool next_line(std::string_view& line);
  // Of the line that was read last, from 1.
  [[nodiscard]] std::size_t line_number() const { return line_number_; }

  // The bytes that follow; false if there are not as many.
  [[nodiscard]] bool read(std::span<std::uint8_t> bytes);
  // How many follow.
  [[nodiscard]] std::uint64_t bytes_left();

  [[noreturn]] void refuse(PcdCause cause, const std::string& why) const;
  // The same, with the number of the line that was read last.
  [[noreturn]] void refuse_line(PcdCause cause, const std::string& why) const;

 private:
  void look_at_beginning();

  std::filesystem::path file_;
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  char line_end_ = '\n';
  std::unique_ptr<char[]> line_;  // room for one
  std::size_t line_number_ = 0;
};

// The words of a line, which blanks, tabs and the CR of CR LF keep apart; taken off its front one
// by one, empty = there are no more.
[[nodiscard]] std::string_view take_word(std::string_view& line);

}  // namespace cleave::recording
