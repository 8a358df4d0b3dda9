// SPDX-License-Identifier: BSD-3-Clause
// How many eigenvectors a scene needs: the experiment of section 5.3.2 and Figure 5.10.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segmentation/cloud_view.hpp"
#include "segmentation/options.hpp"
#include "segmentation/partition/guided_cut.hpp"

namespace cleave::segmentation {

struct GuidedSegmentation {
  std::vector<GuidedCut> cuts;  // in the order in which they were made
  std::uint32_t objects = 0;    // of the truth that own a supervoxel
};

// Spectral Supervoxel Clustering with the truth at hand: at each cut the first eigenvector is taken
// that induces one which agrees with it (guided_cut.hpp says what agrees); parts without one are
// decomposed anew and left whole if that does not help. `truth`: an object a point, 0 = none; a
// supervoxel belongs to the object with most of its points. Of the options, those up to the graph,
// partition.eigenvectors, decomposition and laplacian count; supervoxels are not joined before.
// Nothing is found in a cloud without a finite point. Throws std::invalid_argument for an option
// out of its range, and if truth and cloud are not of one size. Deterministic; allocates.
[[nodiscard]] GuidedSegmentation segment_guided(const CloudView& cloud,
                                                std::span<const std::uint32_t> truth,
                                                const Options& options);

}  // namespace cleave::segmentation
