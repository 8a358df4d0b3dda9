// SPDX-License-Identifier: BSD-3-Clause
// Points that a method leaves without a label.
#pragma once

#include <cstdint>
#include <span>

#include "segmentation/cloud_view.hpp"

namespace cleave::evaluation {

// Every measured point with label 0 takes the label of the nearest point that had one, ties by the
// lowest point: how section 5.2 counts them. One label a point. Nothing changes where no measured
// point has a label.
void label_unlabelled(const segmentation::CloudView& cloud, std::span<std::uint16_t> labels);

}  // namespace cleave::evaluation
