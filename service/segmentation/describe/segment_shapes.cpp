// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/describe/segment_shapes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>

#include "segmentation/describe/oriented_box.hpp"
#include "segmentation/math/plane_fit.hpp"

namespace cleave::segmentation {
namespace {

// So many patches, evenly picked, tell how a segment's box is turned.
constexpr std::uint32_t max_sample = 128;

PointRange range_of(const SegmentedPoints& points, const PointRun& run) {
  return {points.x + run.begin, points.y + run.begin, points.z + run.begin, run.end - run.begin};
}

// Not by computeDirect, which asks the C library for an arc tangent, a sine and a cosine.
Eigen::Matrix3f principal_axes(const Moments& moments) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments.covariance());
  return solver.eigenvectors().cast<float>();
}

}  // namespace

void ShapeDescriber::sum_up(const SegmentedPoints& points,
                            const std::vector<std::uint16_t>& label_of_segment) {
  const std::size_t labels = *std::max_element(label_of_segment.begin(), label_of_segment.end());
  shapes_.assign(labels, Shape{});
  for (const PointRun& run : *points.runs) {
    const std::uint16_t label = label_of_segment[run.segment];
    if (label == 0) continue;
    Shape& shape = shapes_[label - 1U];
    shape.sums.add(range_of(points, run));
    shape.left = std::min(shape.left, run.left);
    shape.right = std::max(shape.right, run.right);
    shape.top = std::min(shape.top, run.row);
    shape.bottom = run.row + 1;
  }
}

void ShapeDescriber::group_surface(const Surface& surface,
                                   const std::vector<std::uint16_t>& label_of_segment) {
  // Label 0: the refinement has left the segment no point, or too few.
  patch_begin_.assign(shapes_.size() + 1, 0);
  for (std::size_t i = 0; i < surface.segment.size(); ++i) {
    const std::uint16_t label = label_of_segment[surface.segment[i]];
    if (label == 0) continue;
    ++patch_begin_[label - 1U];
    shapes_[label - 1U].normal_sum += surface.points[i] * surface.surfel[i].normal;
  }
  std::uint32_t end = 0;
  for (std::uint32_t& row : patch_begin_) row = end += row;
  patch_.resize(end);
  for (auto i = static_cast<std::uint32_t>(surface.segment.size()); i-- > 0;) {
    const std::uint16_t label = label_of_segment[surface.segment[i]];
    if (label != 0) patch_[--patch_begin_[label - 1U]] = i;
  }
}

void ShapeDescriber::aim(const Surface& surface, float plane_distance_m) {
  for (std::size_t s = 0; s < shapes_.size(); ++s) {
    Shape& shape = shapes_[s];
    shape.moments = shape.sums.total();
    shape.centroid = shape.moments.mean().cast<float>();
    shape.box_axes = principal_axes(shape.moments);
    const std::uint32_t step = (patch_begin_[s + 1] - patch_begin_[s]) / max_sample + 1;
    sample_.clear();
    for (std::uint32_t i = patch_begin_[s]; i < patch_begin_[s + 1]; i += step) {
      sample_.push_back(surface.surfel[patch_[i]]);
    }
    if (!sample_.empty()) {
      const std::array<Eigen::Vector3f, 4> candidates = {
          shape.box_axes.col(0), shape.box_axes.col(1), shape.box_axes.col(2),
          dominant_normal(sample_)};
      shape.box_axes = box_axes(sample_, candidates);
    }
    shape.extent.aim(shape.box_axes, fit_normal(shape.moments), shape.centroid, plane_distance_m);
  }
}

void ShapeDescriber::measure(const SegmentedPoints& points,
                             const std::vector<std::uint16_t>& label_of_segment) {
  for (const PointRun& run : *points.runs) {
    const std::uint16_t label = label_of_segment[run.segment];
    if (label != 0) shapes_[label - 1U].extent.add(range_of(points, run));
  }
}

void ShapeDescriber::describe(const SegmentedPoints& points, const Surface& surface, bool organised,
                              const std::vector<std::uint16_t>& label_of_segment,
                              const DescribeOptions& options, std::vector<Segment>& segments) {
  sum_up(points, label_of_segment);
  group_surface(surface, label_of_segment);
  aim(surface, options.plane_distance_m);
  measure(points, label_of_segment);

  segments.resize(shapes_.size());
  for (std::size_t s = 0; s < shapes_.size(); ++s) {
    const Shape& shape = shapes_[s];
    Segment& segment = segments[s];
    segment.label = static_cast<std::uint16_t>(s + 1);
    segment.point_count = static_cast<std::uint32_t>(shape.moments.n);
    segment.centroid = shape.centroid;
    segment.mean_normal = unit_or_towards_sensor(shape.normal_sum, shape.centroid);
    segment.box = make_box(shape.box_axes, shape.extent.low(), shape.extent.high());
    segment.rectangle = {};
    if (organised) segment.rectangle = {shape.left, shape.top, shape.right, shape.bottom};
    segment.planarity = static_cast<float>(shape.extent.points_on_plane()) /
                        static_cast<float>(segment.point_count);
  }
}

}  // namespace cleave::segmentation
