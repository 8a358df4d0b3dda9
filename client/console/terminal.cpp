// SPDX-License-Identifier: BSD-3-Clause
#include "console/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

namespace cleave {

bool is_terminal(int file_descriptor) {
  return isatty(file_descriptor) == 1;
}

std::size_t terminal_columns(int file_descriptor) {
  winsize size{};
  if (ioctl(file_descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

std::size_t live_columns(int file_descriptor) {
  return is_terminal(file_descriptor) ? terminal_columns(file_descriptor) : 0;
}

}  // namespace cleave
