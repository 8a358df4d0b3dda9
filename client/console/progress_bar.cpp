// SPDX-License-Identifier: BSD-3-Clause
#include "console/progress_bar.hpp"

#include <algorithm>
#include <string>

namespace cleave {

void ProgressBar::show(std::size_t done, std::size_t all) {
  if (columns_ == 0 || all == 0) return;
  const std::string figures = " " + std::to_string(done) + "/" + std::to_string(all);
  constexpr std::size_t widest_bar = 40;
  const std::size_t frame = figures.size() + 3;  // the brackets, and the column kept free
  const std::size_t bar = columns_ > frame ? std::min(widest_bar, columns_ - frame) : 0;
  const std::size_t filled = bar * std::min(done, all) / all;
  line_.show("[" + std::string(filled, '#') + std::string(bar - filled, '.') + "]" + figures);
}

}  // namespace cleave
