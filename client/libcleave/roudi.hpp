// SPDX-License-Identifier: BSD-3-Clause
// Is iceoryx's RouDi there, is it still the one that this process joined?
#pragma once

#include <cstdint>

namespace cleave {

// Asks RouDi's socket; never blocks. Creating a shared-memory participant without RouDi blocks for
// a minute and then aborts the process, so ask first.
[[nodiscard]] bool roudi_answers();

enum class RouDiState {
  present,  // the one that was there when the watch began
  gone,     // what is connected keeps flowing; nobody new can join
  replaced  // another one runs: this process is cut off from all that joined it, and must restart
};

// Remembers the RouDi of its construction.
class RouDiWatch {
 public:
  RouDiWatch();
  [[nodiscard]] RouDiState check();

 private:
  std::uint64_t identity_;  // of RouDi's socket file
};

}  // namespace cleave
