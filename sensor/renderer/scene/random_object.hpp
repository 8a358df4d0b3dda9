// SPDX-License-Identifier: BSD-3-Clause
// Objects of the sizes and shares of the real table-top scenes.
#pragma once

#include "sensor/renderer/scene/object.hpp"
#include "sensor/renderer/scene/random.hpp"

namespace cleave::render {

// Shares: boxes .45, books .09, cylinders .20, lying cylinders .10, spheres .06, bowls .05, mugs
// .05. `scale` multiplies every size but a wall's. Its place is the origin, its yaw random.
[[nodiscard]] Object random_object(Random& random, double scale);

}  // namespace cleave::render
