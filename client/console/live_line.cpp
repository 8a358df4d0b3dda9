// SPDX-License-Identifier: BSD-3-Clause
#include "console/live_line.hpp"

namespace cleave {
namespace {

constexpr const char* line_start = "\r";
constexpr const char* erase_to_end_of_line = "\x1b[K";

}  // namespace

void LiveLine::show(const std::string& text) {
  if (columns_ == 0) {
    out_ << text << '\n' << std::flush;
    return;
  }
  out_ << line_start << text.substr(0, columns_ - 1) << erase_to_end_of_line << std::flush;
  unfinished_ = true;
}

void LiveLine::finish() {
  if (!unfinished_) return;
  out_ << '\n' << std::flush;
  unfinished_ = false;
}

void LiveLine::erase() {
  if (!unfinished_) return;
  out_ << line_start << erase_to_end_of_line << std::flush;
  unfinished_ = false;
}

}  // namespace cleave
