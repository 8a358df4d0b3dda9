// SPDX-License-Identifier: BSD-3-Clause
// Messages that lie: an error or some cloud, and no more memory than the message justifies.
#include <gtest/gtest.h>

#include <random>

#include "recording/ros/camera.hpp"
#include "recording/ros/depth_image.hpp"
#include "recording/ros/point_cloud.hpp"
#include "tests/unit/recording/ros/ros_bytes.hpp"

namespace cleave::recording::ros {
namespace {

constexpr int mutations = 1000;
constexpr Format formats[] = {Format::cdr_le, Format::cdr_be, Format::ros1};

// Some bytes of the head changed, small numbers more often than any; sometimes the end cut off.
Bytes mutated(Bytes message, std::mt19937& random) {
  const std::size_t head = std::min<std::size_t>(message.size(), 200);
  for (std::size_t changes = 1 + random() % 4; changes > 0; --changes) {
    const auto value = random() % 2 == 0 ? random() % 10 : random();
    message[random() % head] = static_cast<std::byte>(value);
  }
  if (random() % 8 == 0) message.resize(random() % message.size());
  return message;
}

template <class Decode>
void check(Bytes (*write)(Format), const Decode& decode) {
  std::mt19937 random(11);
  int decoded = 0;
  for (const Format format : formats) {
    const Wire wire = format == Format::ros1 ? Wire::ros1 : Wire::cdr;
    const Bytes whole = write(format);
    for (int i = 0; i < mutations; ++i) {
      const Bytes message = mutated(whole, random);
      try {
        EXPECT_LE(decode(message, wire), message.size());
        ++decoded;
      } catch (const DataError& error) {
        EXPECT_STRNE(error.what(), "");
      }
    }
  }
  EXPECT_GT(decoded, 0) << "most changes are of no consequence";
}

TEST(MutatedMessages, OfPointCloud2AreRefusedOrGiveNoMorePointsThanBytes) {
  const auto write = +[](Format format) {
    return bytes_of_cloud(cloud_of(std::vector<float>(3 * 24, 1), 6, 4), format);
  };
  check(write, [](const Bytes& message, Wire wire) {
    return points_of(read_point_cloud2(reader_of(message, wire))).size() / 3;
  });
}

TEST(MutatedMessages, OfImagesAreRefusedOrGiveNoMorePixelsThanBytes) {
  for (const char* const encoding : {"16UC1", "32FC1"}) {
    static const char* name;
    name = encoding;
    const auto write = +[](Format format) {
      ImageSpec image;
      image.encoding = name;
      image.step = 12;
      image.data.resize(24);
      return bytes_of_image(image, format);
    };
    check(write, [](const Bytes& message, Wire wire) {
      return depth_of(read_image(reader_of(message, wire))).size();
    });
  }
}

TEST(MutatedMessages, OfCameraInfoAreRefusedOrGiveACamera) {
  const auto write = +[](Format format) { return bytes_of_camera(CameraSpec{}, format); };
  check(write, [](const Bytes& message, Wire wire) {
    const CameraInfo info = read_camera_info(reader_of(message, wire));
    (void)camera_of(info, ImageKind::raw, 3, 2);
    return info.d.size();
  });
}

}  // namespace
}  // namespace cleave::recording::ros
