// SPDX-License-Identifier: BSD-3-Clause
// How far a long job is, for someone who watches a terminal; silent everywhere else.
#pragma once

#include <cstddef>
#include <ostream>

#include "console/live_line.hpp"

namespace cleave {

class ProgressBar {
 public:
  // `columns` is the terminal's width; 0 = not a terminal: nothing is drawn.
  ProgressBar(std::ostream& out, std::size_t columns) : line_(out, columns), columns_(columns) {}
  ~ProgressBar() { line_.erase(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done, std::size_t all);

 private:
  LiveLine line_;
  std::size_t columns_;
};

}  // namespace cleave
