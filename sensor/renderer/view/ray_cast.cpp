// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/renderer/view/ray_cast.hpp"

#include <cmath>

#include "sensor/renderer/view/object_view.hpp"
#include "sensor/renderer/view/shadow.hpp"

namespace cleave::render {
namespace {

struct CameraRays {
  Eigen::Isometry3d table_from_camera;
  CameraModel camera;
};

// The table is the plane z = 0; whether a point of it is kept is the crop's business.
void cast_at_table(const CameraRays& rays, const Crop& crop, RayCast& image,
                   std::vector<Eigen::Vector3f>& normals) {
  const Eigen::Vector3d& origin = rays.table_from_camera.translation();
  const Eigen::Vector3f up = rays.table_from_camera.linear().row(2).transpose().cast<float>();
  std::size_t i = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x, ++i) {
      const Eigen::Vector3d in_camera = pixel_direction(x, y, rays.camera.intrinsics);
      const Eigen::Vector3d direction = rays.table_from_camera.linear() * in_camera;
      if (direction.z() >= 0) continue;
      const double depth_m = -origin.z() / direction.z();
      const Eigen::Vector3d point = origin + depth_m * direction;
      image.depth_m[i] = static_cast<float>(depth_m);
      image.cosine[i] = static_cast<float>(-direction.z() / direction.norm());
      image.surface[i] = table_surface;
      image.measurable[i] =
          point.x() >= crop.x_min_m && point.x() <= crop.x_max_m && point.y() <= crop.y_max_m;
      normals[i] = up;
    }
  }
}

void cast_at_object(const CameraRays& rays, const Scene& scene, std::size_t object, RayCast& image,
                    std::vector<Eigen::Vector3f>& normals) {
  const Shape& shape = scene.objects[object].shape;
  const ObjectView view(scene.objects[object], rays.table_from_camera, rays.camera.intrinsics);
  const PixelRectangle pixels = pixels_within(view.bounds, rays.camera);
  const Eigen::Vector3d origin = view.object_from_camera.translation();
  const Eigen::Matrix3d camera_from_object = view.object_from_camera.linear().transpose();
  for (std::uint32_t y = pixels.y_begin; y < pixels.y_end; ++y) {
    for (std::uint32_t x = pixels.x_begin; x < pixels.x_end; ++x) {
      const std::size_t i = std::size_t{y} * image.width + x;
      const Eigen::Vector3d in_camera = pixel_direction(x, y, rays.camera.intrinsics);
      const Eigen::Vector3d direction = view.object_from_camera.linear() * in_camera;
      Hit hit;
      hit.t = image.depth_m[i];
      const double nearest_so_far_m = hit.t;
      intersect(shape, {origin, direction}, hit);
      if (!(hit.t < nearest_so_far_m)) continue;
      image.depth_m[i] = static_cast<float>(hit.t);
      image.cosine[i] = static_cast<float>(std::abs(hit.normal.dot(direction)) / direction.norm());
      image.surface[i] = object_surface(object, hit.part);
      image.measurable[i] = 1;
      normals[i] = (camera_from_object * hit.normal).cast<float>();
    }
  }
}

void blank_cropped_columns(const Crop& crop, RayCast& image) {
  const std::uint32_t kept = crop.columns * image.width / CameraModel{}.width;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = kept; x < image.width; ++x) {
      image.measurable[std::size_t{y} * image.width + x] = 0;
    }
  }
}

}  // namespace

RayCast cast_rays(const Scene& scene, const CameraPose& pose, const CameraModel& camera) {
  const std::size_t size = std::size_t{camera.width} * camera.height;
  RayCast image{.width = camera.width,
                .height = camera.height,
                .depth_m = std::vector<float>(size, std::numeric_limits<float>::infinity()),
                .cosine = std::vector<float>(size),
                .surface = std::vector<std::uint16_t>(size, no_surface),
                .measurable = std::vector<std::uint8_t>(size)};
  std::vector<Eigen::Vector3f> normals(size, Eigen::Vector3f::Zero());  // optical frame

  const CameraRays rays{table_from_camera(pose), camera};
  cast_at_table(rays, scene.crop, image, normals);
  for (std::size_t k = 0; k < scene.objects.size(); ++k) {
    cast_at_object(rays, scene, k, image, normals);
  }
  blank_cropped_columns(scene.crop, image);
  remove_shadows(scene, rays.table_from_camera, camera, normals, image);
  return image;
}

}  // namespace cleave::render
