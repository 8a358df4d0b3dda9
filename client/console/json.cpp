// SPDX-License-Identifier: BSD-3-Clause
#include "console/json.hpp"

#include <spdlog/fmt/fmt.h>

#include <cstdlib>

namespace cleave {

Json json_of(const Percentiles& percentiles) {
  return {{"median", percentiles.median}, {"p90", percentiles.p90}, {"p99", percentiles.p99}};
}

double decimal(float value) {
  return std::strtod(fmt::format("{}", value).c_str(), nullptr);
}

std::string one_line(const Json& object) {
  return object.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace cleave
