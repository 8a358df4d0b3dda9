// SPDX-License-Identifier: BSD-3-Clause
// What libcleave_peers.so offers. Program and module are built together, so C++ types pass; the
// caller owns what it gets.
#pragma once

#include "segmentation/options.hpp"
#include "workbench/peers/peer.hpp"

extern "C" {
[[nodiscard]] cleave::peers::Peer* cleave_new_pcl_lccp(
    const cleave::peers::LccpParameters& parameters);
[[nodiscard]] cleave::peers::Peer* cleave_new_pcl_cpc(
    const cleave::peers::CpcParameters& parameters);
[[nodiscard]] cleave::peers::Peer* cleave_new_pcl_ssc(
    const cleave::segmentation::Options& options,
    const cleave::peers::SupervoxelParameters& supervoxels);
}
