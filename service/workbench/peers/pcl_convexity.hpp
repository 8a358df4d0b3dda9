// SPDX-License-Identifier: BSD-3-Clause
// What LCCP and CPC, which builds on it, have in common.
#pragma once

#include <pcl/segmentation/lccp_segmentation.h>

#include <map>
#include <span>

#include "workbench/peers/pcl_supervoxels.hpp"

namespace cleave::peers {

inline void set_up(pcl::LCCPSegmentation<PclPoint>& method, const LccpParameters& parameters,
                   const PclSupervoxels& supervoxels) {
  method.setConcavityToleranceThreshold(parameters.concavity_tolerance_deg);
  method.setSanityCheck(parameters.sanity_check);
  method.setSmoothnessCheck(false, 0, 0);
  method.setKFactor(parameters.k_factor);
  method.setMinSegmentSize(parameters.min_segment_supervoxels);
  method.setInputSupervoxels(supervoxels.clusters, supervoxels.adjacency);
}

inline void take_labels(pcl::LCCPSegmentation<PclPoint>& method, const PclSupervoxels& supervoxels,
                        std::span<std::uint16_t> labels) {
  std::map<std::uint32_t, std::uint32_t> segment_of;  // numbered from 1
  method.getSupervoxelToSegmentMap(segment_of);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const auto found = segment_of.find((*supervoxels.labelled)[i].label);
    labels[i] = found == segment_of.end() ? 0 : static_cast<std::uint16_t>(found->second);
  }
}

}  // namespace cleave::peers
