#include "segmentation/segment_shapes.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>

#include "segmentation/oriented_box.hpp"
#include "segmentation/plane_fit.hpp"

namespace cleave::segmentation {
namespace {

// So many voxels, evenly picked, tell how a segment's box is turned.
constexpr std::uint32_t max_sample = 512;

Eigen::Vector3f point_at(const PointSet& points, std::size_t i) {
  return {points.x[i], points.y[i], points.z[i]};
}

using Label = std::uint16_t;

// Neighbouring points mostly have one label. Calls work(label, first, end) for each such run in
// [begin, end): what it sums up can stay in registers.
template <typename Work>
void for_label_runs(const std::vector<Label>& label_of_point, std::size_t begin, std::size_t end,
                    Work&& work) {
  while (begin < end) {
    const Label label = label_of_point[begin];
    std::size_t next = begin + 1;
    while (next < end && label_of_point[next] == label) ++next;
    work(label, begin, next);
    begin = next;
  }
}

Eigen::Matrix3f principal_axes(const Moments& moments) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments.covariance());
  return solver.eigenvectors().cast<float>();
}

}  // namespace

void ShapeDescriber::sum_up(const PointSet& points, const VoxelGrid& grid,
                            const std::vector<Surfel>& voxels,
                            const std::vector<std::uint16_t>& label_of_point) {
  const std::size_t labels = *std::max_element(label_of_point.begin(), label_of_point.end());
  shapes_.assign(labels, Shape{});
  for_label_runs(label_of_point, 0, points.size(),
                 [&](Label label, std::size_t i, std::size_t end) {
                   Moments sum;
                   for (; i < end; ++i) sum.add_point(points.x[i], points.y[i], points.z[i]);
                   shapes_[label - 1U].moments += sum;
                 });
  for (std::size_t run = 0; run < grid.runs(); ++run) {
    const Eigen::Vector3f& normal = voxels[grid.run_voxel[run]].normal;
    for_label_runs(label_of_point, grid.run_begin[run], grid.run_begin[run + 1],
                   [&](Label label, std::size_t begin, std::size_t end) {
                     shapes_[label - 1U].normal_sum += normal * static_cast<float>(end - begin);
                   });
  }
}

void ShapeDescriber::find_rectangles(const CloudView& cloud, const PointSet& points,
                                     const std::vector<std::uint16_t>& label_of_point) {
  std::size_t begin = 0;
  for (std::uint32_t row = 0; row < cloud.height; ++row) {
    const std::uint32_t row_begin = row * cloud.width;
    std::size_t end = begin;
    while (end < points.size() && points.index[end] - row_begin < cloud.width) ++end;
    for_label_runs(label_of_point, begin, end,
                   [&](Label label, std::size_t first, std::size_t next) {
                     Shape& shape = shapes_[label - 1U];
                     shape.left = std::min(shape.left, points.index[first] - row_begin);
                     shape.right = std::max(shape.right, points.index[next - 1] - row_begin);
                     shape.top = std::min(shape.top, row);
                     shape.bottom = row;
                   });
    begin = end;
  }
}

void ShapeDescriber::group_voxels(const VoxelGrid& grid,
                                  const std::vector<std::uint16_t>& label_of_point) {
  label_of_voxel_.resize(grid.size());
  for (std::size_t run = 0; run < grid.runs(); ++run) {
    label_of_voxel_[grid.run_voxel[run]] = label_of_point[grid.run_begin[run]];
  }
  voxel_begin_.assign(shapes_.size() + 1, 0);
  for (const std::uint16_t label : label_of_voxel_) ++voxel_begin_[label - 1U];
  std::uint32_t end = 0;
  for (std::uint32_t& row : voxel_begin_) row = end += row;
  voxel_.resize(end);
  for (auto v = static_cast<std::uint32_t>(grid.size()); v-- > 0;) {
    voxel_[--voxel_begin_[label_of_voxel_[v] - 1U]] = v;
  }
}

void ShapeDescriber::choose_axes(const std::vector<Surfel>& voxels) {
  for (std::size_t s = 0; s < shapes_.size(); ++s) {
    Shape& shape = shapes_[s];
    const Eigen::Matrix3f principal = principal_axes(shape.moments);
    shape.centroid = shape.moments.mean().cast<float>();
    shape.plane_normal = fit_normal(shape.moments);

    const std::uint32_t count = voxel_begin_[s + 1] - voxel_begin_[s];
    const std::uint32_t step = count / max_sample + 1;
    sample_.clear();
    for (std::uint32_t i = voxel_begin_[s]; i < voxel_begin_[s + 1]; i += step) {
      sample_.push_back(voxels[voxel_[i]]);
    }
    const std::array<Eigen::Vector3f, 4> candidates = {principal.col(0), principal.col(1),
                                                       principal.col(2), dominant_normal(sample_)};
    shape.box_axes = box_axes(sample_, candidates);
    shape.low = Eigen::Vector3f::Constant(std::numeric_limits<float>::infinity());
    shape.high = -shape.low;
  }
}

void ShapeDescriber::measure(const PointSet& points,
                             const std::vector<std::uint16_t>& label_of_point,
                             float plane_distance_m) {
  for_label_runs(label_of_point, 0, points.size(),
                 [&](Label label, std::size_t i, std::size_t end) {
                   Shape shape = shapes_[label - 1U];
                   for (; i < end; ++i) {
                     const Eigen::Vector3f p = point_at(points, i);
                     const Eigen::Vector3f along = shape.box_axes.transpose() * p;
                     shape.low = shape.low.cwiseMin(along);
                     shape.high = shape.high.cwiseMax(along);
                     const float distance_m = std::abs(shape.plane_normal.dot(p - shape.centroid));
                     shape.points_on_plane += distance_m <= plane_distance_m ? 1 : 0;
                   }
                   shapes_[label - 1U] = shape;
                 });
}

void ShapeDescriber::describe(const CloudView& cloud, const PointSet& points, const VoxelGrid& grid,
                              const std::vector<Surfel>& voxels,
                              const std::vector<std::uint16_t>& label_of_point,
                              const DescribeOptions& options, std::vector<Segment>& segments) {
  sum_up(points, grid, voxels, label_of_point);
  if (cloud.organised()) find_rectangles(cloud, points, label_of_point);
  group_voxels(grid, label_of_point);
  choose_axes(voxels);
  measure(points, label_of_point, options.plane_distance_m);

  segments.resize(shapes_.size());
  for (std::size_t s = 0; s < shapes_.size(); ++s) {
    const Shape& shape = shapes_[s];
    Segment& segment = segments[s];
    segment.label = static_cast<std::uint16_t>(s + 1);
    segment.point_count = static_cast<std::uint32_t>(shape.moments.n);
    segment.centroid = shape.centroid;
    segment.mean_normal = unit_or_towards_sensor(shape.normal_sum, shape.centroid);
    segment.box = make_box(shape.box_axes, shape.low, shape.high);
    segment.rectangle = {};
    if (cloud.organised()) {
      segment.rectangle = {shape.left, shape.top, shape.right + 1, shape.bottom + 1};
    }
    segment.planarity =
        static_cast<float>(shape.points_on_plane) / static_cast<float>(segment.point_count);
  }
}

}  // namespace cleave::segmentation
