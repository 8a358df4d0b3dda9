// SPDX-License-Identifier: BSD-3-Clause
// JSON on stdout: one object a line, keys in the order in which they were set.
#pragma once

#include <nlohmann/json.hpp>

#include "console/percentiles.hpp"

namespace cleave {

using Json = nlohmann::ordered_json;

// {"median": .., "p90": .., "p99": ..}
[[nodiscard]] Json json_of(const Percentiles& percentiles);

// The number whose decimal text is as short as the float's own: 0.3, not 0.30000001192092896.
[[nodiscard]] double decimal(float value);

// Text that is not UTF-8 has the offending bytes replaced; a number that is not finite is null.
[[nodiscard]] std::string one_line(const Json& object);

}  // namespace cleave
