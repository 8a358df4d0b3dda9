// SPDX-License-Identifier: BSD-3-Clause
#include "recording/pcd/input.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace cleave::recording {
namespace {

// Room for 64 kB of values of one byte as text.
constexpr std::size_t longest_line_bytes = std::size_t{1} << 20U;
constexpr std::streamsize beginning_bytes = 4096;

constexpr std::string_view utf8_mark = "\xEF\xBB\xBF";
constexpr std::string_view blanks = " \t\r\n\v\f";

}  // namespace

PcdInput::PcdInput(std::filesystem::path file)
    : file_(std::move(file)), line_(std::make_unique_for_overwrite<char[]>(longest_line_bytes)) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file_, error)) {
    refuse(PcdCause::unreadable, error ? "cannot be read: " + error.message() + "; name a PCD file"
                                       : "is no regular file; name a PCD file");
  }
  size_ = std::filesystem::file_size(file_, error);
  stream_.open(file_, std::ios::binary);
  if (error || !stream_) {
    refuse(PcdCause::unreadable, std::string("cannot be read: ") + std::strerror(errno) +
                                     "; let this user read it, or name another");
  }
  look_at_beginning();
}

void PcdInput::look_at_beginning() {
  stream_.read(line_.get(), beginning_bytes);
  const std::string_view head(line_.get(), static_cast<std::size_t>(stream_.gcount()));
  if (head.starts_with("\xFF\xFE") || head.starts_with("\xFE\xFF")) {
    refuse(PcdCause::not_pcd, "is text in UTF-16; save it as ASCII or UTF-8");
  }
  const std::size_t end = head.find_first_of("\r\n");
  const bool is_cr_alone =
      end != std::string_view::npos && head[end] == '\r' && head.substr(end, 2) != "\r\n";
  line_end_ = is_cr_alone ? '\r' : '\n';
  stream_.clear();  // a short file was read to its end
  stream_.seekg(head.starts_with(utf8_mark) ? utf8_mark.size() : 0);
}

bool PcdInput::next_line(std::string_view& line) {
  stream_.getline(line_.get(), std::streamsize{longest_line_bytes}, line_end_);
  const auto taken = static_cast<std::size_t>(stream_.gcount());
  if (taken == 0) return false;
  ++line_number_;
  const bool has_end = stream_.good();  // which was taken, too
  line = {line_.get(), taken - (has_end ? 1 : 0)};
  if (!stream_.eof()) stream_.clear();  // after a piece of a line
  return true;
}

bool PcdInput::read(std::span<std::uint8_t> bytes) {
  const auto size = static_cast<std::streamsize>(bytes.size());
  return stream_.read(reinterpret_cast<char*>(bytes.data()), size) && stream_.gcount() == size;
}

std::uint64_t PcdInput::bytes_left() {
  const std::streamoff at = stream_.tellg();
  return at < 0 || static_cast<std::uint64_t>(at) > size_ ? 0
                                                          : size_ - static_cast<std::uint64_t>(at);
}

void PcdInput::refuse(PcdCause cause, const std::string& why) const {
  throw PcdError(file_, cause, why);
}

void PcdInput::refuse_line(PcdCause cause, const std::string& why) const {
  refuse(cause, "line " + std::to_string(line_number_) + ": " + why);
}

std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(blanks));
  line.remove_prefix(word.size());
  return word;
}

}  // namespace cleave::recording
