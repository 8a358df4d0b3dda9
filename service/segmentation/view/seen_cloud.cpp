// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/seen_cloud.hpp"

#include <limits>

#include "segmentation/points/point_set.hpp"
#include "segmentation/view/measured.hpp"

namespace cleave::segmentation {
namespace {

void copy_point(const float* from, const View& view, float* to) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  if (!is_measured(from)) {
    to[0] = to[1] = to[2] = nan;
    return;
  }
  Eigen::Map<Eigen::Vector3f> point(to);
  point = Eigen::Map<const Eigen::Vector3f>(from);
  if (!view.moved) return;
  const Eigen::Vector3d seen = view.axes * (point.cast<double>() - view.centre);
  constexpr double far_m = max_coordinate_m;
  point = seen.cwiseMax(-far_m).cwiseMin(far_m).cast<float>();
}

}  // namespace

void SeenCloud::take(const CloudView& cloud, const View& view) {
  view_ = view;
  upright_ = UprightImage(view.order, cloud.width, cloud.height);
  seen_ = cloud;
  if (view.changes_nothing()) return;
  seen_.width = upright_.width();
  seen_.height = upright_.height();
  seen_.stride = 3;
  xyz_.resize(3 * cloud.size());
  float* to = xyz_.data();
  for (std::uint32_t row = 0; row < seen_.height; ++row) {
    for (std::uint32_t column = 0; column < seen_.width; ++column, to += 3) {
      copy_point(cloud.point(upright_.index(column, row)), view, to);
    }
  }
  seen_.xyz = xyz_.data();
}

bool SeenCloud::look_at_image(const CloudView& cloud) {
  const std::optional<View> view = image_finder_.find(cloud);
  if (view) take(cloud, *view);
  return view.has_value();
}

void SeenCloud::look_at_points(const CloudView& cloud, Viewpoint viewpoint) {
  take(cloud, point_finder_.find(cloud, viewpoint));
}

std::size_t SeenCloud::stored_index(std::size_t seen) const {
  if (view_.order.upright()) return seen;
  return upright_.index(static_cast<std::uint32_t>(seen % seen_.width),
                        static_cast<std::uint32_t>(seen / seen_.width));
}

std::span<std::uint16_t> SeenCloud::labels(std::span<std::uint16_t> own) {
  if (view_.order.upright()) return own;
  labels_.assign(own.size(), 0);
  return labels_;
}

void SeenCloud::give_back(std::span<std::uint16_t> own, Segmentation& result) const {
  if (!view_.order.upright()) {
    std::size_t from = 0;
    for (std::uint32_t row = 0; row < seen_.height; ++row) {
      for (std::uint32_t column = 0; column < seen_.width; ++column, ++from) {
        own[upright_.index(column, row)] = labels_[from];
      }
    }
    for (Segment& segment : result.segments) {
      segment.rectangle = upright_.stored(segment.rectangle);
    }
  }
  if (!view_.moved) return;
  const Eigen::Matrix3d back = view_.axes.transpose();
  const Eigen::Quaterniond turn(back);
  const auto placed = [&](const Eigen::Vector3f& point) -> Eigen::Vector3f {
    return (back * point.cast<double>() + view_.centre).cast<float>();
  };
  for (Segment& segment : result.segments) {
    segment.centroid = placed(segment.centroid);
    segment.mean_normal = (back * segment.mean_normal.cast<double>()).cast<float>();
    segment.box.centre = placed(segment.box.centre);
    segment.box.orientation =
        (turn * segment.box.orientation.cast<double>()).normalized().cast<float>();
  }
}

}  // namespace cleave::segmentation
