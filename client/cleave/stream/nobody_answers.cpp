// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/nobody_answers.hpp"

#include <spdlog/fmt/fmt.h>

#include <chrono>

#include "cleave/stream/live_options.hpp"
#include "libcleave/discovery.hpp"

namespace cleave::client {
namespace {

constexpr std::chrono::milliseconds listen(300);

}  // namespace

std::string nobody_answers(Stream& stream) {
  std::string other = other_contract(discover(stream, listen));
  if (!other.empty()) return other;
  return fmt::format(
      "no grabber or segmenter answers on domain {}; start them, or ./service/demo, or {}",
      stream.options().domain, elsewhere);
}

}  // namespace cleave::client
