// SPDX-License-Identifier: BSD-3-Clause
// One line that is kept up to date: rewritten in place on a terminal, printed anew elsewhere.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>

namespace cleave {

class LiveLine {
 public:
  // `columns` is the terminal's width; 0 = not a terminal.
  LiveLine(std::ostream& out, std::size_t columns) : out_(out), columns_(columns) {}
  ~LiveLine() { finish(); }
  LiveLine(const LiveLine&) = delete;
  LiveLine& operator=(const LiveLine&) = delete;

  // On a terminal, text that is wider than the window is cut: a wrapped line cannot be rewritten.
  void show(const std::string& text);
  // Leaves the last text standing and begins a new line. May be called more than once.
  void finish();
  // Takes the last text away again; does nothing where it was printed for good.
  void erase();

 private:
  std::ostream& out_;
  std::size_t columns_;
  bool unfinished_ = false;
};

}  // namespace cleave
