// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <random>

#include "stored_scene.hpp"
#include "tests/unit/segmentation/support/depth_scene.hpp"
#include "tests/unit/segmentation/support/segmented.hpp"

namespace cleave::segmentation {
namespace {

Scene boxes() {
  const DepthScene scene(1);
  return scene_of(scene.width, scene.height, scene.xyz);
}

Eigen::Isometry3d pose_at(const Eigen::Vector3d& position_m, const Eigen::Matrix3d& axes) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(position_m);
  pose.rotate(axes);
  return pose;
}

Eigen::Matrix3d looking_forward() {
  Eigen::Matrix3d axes;
  axes << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return axes;
}

// Camera tilted down and turned, as on a robot that has driven somewhere.
Eigen::Matrix3d somewhere() {
  return Eigen::AngleAxisd(2.1, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitY()) * looking_forward();
}

SensorPose sensor_pose(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond q(pose.rotation());
  const Eigen::Vector3d& p = pose.translation();
  return {{p.x(), p.y(), p.z()}, {q.w(), q.x(), q.y(), q.z()}};
}

TEST(SceneFrame, OfAnImageMayBeAny) {
  Eigen::Matrix3d z_backward = Eigen::Vector3d(1, -1, -1).asDiagonal();
  const Scene scene = boxes();
  const Segmented own = segmented(scene.view());
  for (const Eigen::Isometry3d& pose :
       {pose_at({0, 0, 0}, z_backward), pose_at({0.2, 0.1, 1.1}, looking_forward()),
        pose_at({0.2, 0.1, 1.1}, somewhere()), pose_at({100, 200, 1}, somewhere()),
        pose_at({0.03, 0, 0}, Eigen::Matrix3d::Identity())}) {
    const Scene other = moved(scene, pose);
    EXPECT_GE(agreement(own.labels, other, segmented(other.view()).labels), 0.99);
  }
}

TEST(SceneFrame, MayBeAThousandKilometresOffInDoubles) {
  const Scene scene = boxes();
  const Scene other = moved(scene, pose_at({3, 4, 1}, somewhere()));
  CloudView view = other.view();
  view.origin_m = {1e6, 2e6, 0};

  EXPECT_GE(agreement(segmented(scene.view()).labels, other, segmented(view).labels), 0.99);
}

TEST(SceneFrame, IsThatOfTheSegments) {
  const Scene scene = boxes();
  const Eigen::Isometry3d pose = pose_at({0.2, 0.1, 1.1}, somewhere());
  const auto own = segmented(scene.view()).segmentation.segments;
  const auto other = segmented(moved(scene, pose).view()).segmentation.segments;

  ASSERT_EQ(own.size(), other.size());
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Eigen::Vector3d centroid = pose * own[i].centroid.cast<double>();
    const Eigen::Vector3d normal = pose.rotation() * own[i].mean_normal.cast<double>();
    EXPECT_LT((other[i].centroid.cast<double>() - centroid).norm(), 0.002);
    EXPECT_GT(other[i].mean_normal.cast<double>().dot(normal), 0.999);
    EXPECT_LT((other[i].box.extent - own[i].box.extent).norm(), 0.01);
    EXPECT_LT((other[i].box.centre.cast<double>() - pose * own[i].box.centre.cast<double>()).norm(),
              0.01);
  }
}

TEST(SceneFrame, OfAnUnorganisedCloudMayBeAnyIfThePoseIsKnown) {
  const Scene scene = boxes();
  const CloudView flat{scene.xyz.data(), 3, scene.width * scene.height, 1};
  const Segmented own = segmented(flat);
  const Eigen::Isometry3d pose = pose_at({100, 200, 1}, somewhere());
  const Scene other = moved(scene, pose);
  CloudView view{other.xyz.data(), 3, scene.width * scene.height, 1};
  view.pose = sensor_pose(pose);

  EXPECT_GE(agreement(own.labels, other, segmented(view).labels), 0.99);

  view.pose->orientation = {1, 0, 0, 0};  // as if not known
  EXPECT_GE(agreement(own.labels, other, segmented(view).labels), 0.98);
}

TEST(SceneFrame, OfAPlaneMayBeAny) {
  const Scene scene = tilted_plane();
  for (const StorageOrder& order : all_storage_orders()) {
    const Scene other = stored(moved(scene, pose_at({0.2, 0.1, 1.1}, somewhere())), order);
    EXPECT_EQ(segmented(other.view()).segmentation.segments.size(), 1U);
  }
}

TEST(SceneFrame, OfAVoxelFilteredCloudInARobotsFrameIsNotTakenForTheSensors) {
  // A table 0.8 m up with a box on it, a point a centimetre.
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-0.002F, 0.002F);
  std::vector<float> xyz;
  for (int i = 0; i < 100; ++i) {
    for (int j = 0; j < 100; ++j) {
      const bool box = i > 40 && i < 60 && j > 40 && j < 60;
      const float height = box ? 0.95F : 0.8F;
      xyz.insert(xyz.end(),
                 {0.3F + 0.01F * static_cast<float>(i) + uniform(random),
                  0.01F * static_cast<float>(j - 50) + uniform(random), height + uniform(random)});
    }
  }
  Options options;
  options.voxel.size_m = 0.016F;
  options.supervoxel.seed_spacing_m = 0.06F;
  const CloudView view{xyz.data(), 3, static_cast<std::uint32_t>(xyz.size() / 3), 1};

  EXPECT_EQ(segmented(view, options).segmentation.segments.size(), 2U);
}

}  // namespace
}  // namespace cleave::segmentation
