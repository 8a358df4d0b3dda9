// SPDX-License-Identifier: BSD-3-Clause
// The output: a label a point, and what is known of every segment, in the frame of the cloud and
// relative to its origin_m.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

namespace cleave::segmentation {

// Half-open rectangle of columns and rows as stored; all 0 for an unorganised cloud.
struct ImageRectangle {
  std::uint32_t left = 0, top = 0, right = 0, bottom = 0;
};

// Box around a segment's points. `orientation` turns box axes into the cloud's frame.
struct OrientedBox {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  Eigen::Vector3f extent = Eigen::Vector3f::Zero();  // full edge lengths, metres, largest first
};

struct Segment {
  std::uint16_t label = 0;
  std::uint32_t point_count = 0;
  Eigen::Vector3f centroid = Eigen::Vector3f::Zero();
  Eigen::Vector3f mean_normal = Eigen::Vector3f::Zero();  // unit length, towards the sensor
  OrientedBox box;
  ImageRectangle rectangle;
  float planarity = 0;  // share of points within DescribeOptions::plane_distance_m of the plane
};

enum class BorderKind { concave, convex };

// Two segments that touch; first < second.
struct Border {
  std::uint16_t first = 0;
  std::uint16_t second = 0;
  BorderKind kind = BorderKind::concave;
};

// segments[i].label == i + 1; label 1 has most points, ties by lowest point index; in an image by
// the first point of the upright image, whatever order it is stored in.
struct Segmentation {
  std::vector<Segment> segments;
  std::vector<Border> borders;        // sorted by (first, second)
  std::uint32_t measured_points = 0;  // that count: is_measured, and not behind the sensor
};

// too_many_segments: more than max_labels, which is all that a label can tell apart.
enum class Outcome { segmented, bad_size, no_finite_point, too_many_segments };

}  // namespace cleave::segmentation
