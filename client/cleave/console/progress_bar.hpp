// How far a long job is, for someone who watches a terminal; silent everywhere else.
#pragma once

#include <cstddef>
#include <ostream>

#include "cleave/console/live_line.hpp"

namespace cleave::client {

class ProgressBar {
 public:
  // `columns` is the terminal's width; 0 = not a terminal: nothing is drawn.
  ProgressBar(std::ostream& out, std::size_t columns, std::size_t total)
      : line_(out, columns), columns_(columns), total_(total) {}
  ~ProgressBar() { line_.erase(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done);

 private:
  LiveLine line_;
  std::size_t columns_;
  std::size_t total_;
};

}  // namespace cleave::client
