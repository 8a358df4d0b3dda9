// SPDX-License-Identifier: BSD-3-Clause
// What is left of a number that was written as text.
#pragma once

namespace cleave::recording {

// The float nearest to the decimal number of 7 significant digits nearest to `x`: what reading
// back "%.7g" yields, but for ties. 0, tiny and huge numbers, and what is not finite only lose
// what a float cannot hold.
[[nodiscard]] float round_to_7_digits(double x);

}  // namespace cleave::recording
