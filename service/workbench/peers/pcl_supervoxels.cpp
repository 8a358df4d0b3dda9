// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/peers/pcl_supervoxels.hpp"

#include <pcl/console/print.h>

#include <memory>

namespace cleave::peers {

void silence_pcl() {
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
}

PclCloud::Ptr to_pcl(const segmentation::CloudView& cloud) {
  // Not `new`: PCL's library would give it back by another `delete` than this standard's.
  auto result = std::make_shared<PclCloud>(cloud.width, cloud.height);
  result->is_dense = false;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const float* p = cloud.point(i);
    (*result)[i].x = p[0];
    (*result)[i].y = p[1];
    (*result)[i].z = p[2];
  }
  return result;
}

PclSupervoxels cluster(const PclCloud::Ptr& cloud, const SupervoxelParameters& parameters) {
  // An object of its own for each cloud: PCL's asserts when it is used a second time.
  pcl::SupervoxelClustering<PclPoint> clustering(parameters.voxel_m, parameters.seed_m);
  clustering.setUseSingleCameraTransform(parameters.single_camera_transform);
  clustering.setInputCloud(cloud);
  clustering.setColorImportance(0);
  clustering.setSpatialImportance(parameters.spatial_weight);
  clustering.setNormalImportance(parameters.normal_weight);
  PclSupervoxels result;
  clustering.extract(result.clusters);
  clustering.getSupervoxelAdjacency(result.adjacency);
  result.labelled = clustering.getLabeledCloud();
  return result;
}

}  // namespace cleave::peers
