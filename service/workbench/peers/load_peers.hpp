// SPDX-License-Identifier: BSD-3-Clause
// PCL's methods, brought in when they are asked for: linked to the program, PCL's 70 MB of
// libraries would make each start of it wait for a second.
#pragma once

#include <memory>

#include "segmentation/options.hpp"
#include "workbench/peers/peer.hpp"

namespace cleave::peers {

// PCL's SupervoxelClustering and LCCPSegmentation.
[[nodiscard]] std::unique_ptr<Peer> make_pcl_lccp(const LccpParameters& parameters = {});

// The same with CPCSegmentation.
[[nodiscard]] std::unique_ptr<Peer> make_pcl_cpc(const CpcParameters& parameters = {});

// PCL's supervoxels, their normals by PCA as in section 4.1.2.1, with our graph, partition and
// clean-up, for which `options` holds.
[[nodiscard]] std::unique_ptr<Peer> make_pcl_ssc(const segmentation::Options& options,
                                                 const SupervoxelParameters& supervoxels = {});

// All throw std::runtime_error when libcleave_peers.so, which comes with the program
// (libcleave/process/companion.hpp), cannot be loaded.

}  // namespace cleave::peers
