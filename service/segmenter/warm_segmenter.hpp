// SPDX-License-Identifier: BSD-3-Clause
// Segmenters that have their memory and their code pages already.
#pragma once

#include <cstddef>
#include <vector>

#include "segmentation/options.hpp"
#include "segmenter/pipeline/frame_pipeline.hpp"

namespace cleave::service {

// `count` segmenters that have each segmented a synthetic cloud of full size: the first frame of a
// process would be slower than all others. Throws std::invalid_argument for a wrong option.
[[nodiscard]] std::vector<SegmentFunction> warm_segmenters(const segmentation::Options& options,
                                                           std::size_t count);

}  // namespace cleave::service
