// What is left of a number that was written as text.
#pragma once

namespace cleave::recording {

// The float nearest to the decimal number of 7 significant digits nearest to `x`: what reading
// back "%.7g" yields, but for ties. 0, tiny and huge numbers, and what is not finite are returned
// as they are.
[[nodiscard]] float round_to_7_digits(float x);

}  // namespace cleave::recording
