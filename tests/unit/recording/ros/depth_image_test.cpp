// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ros/depth_image.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "recording/ros/camera.hpp"
#include "recording/ros/camera_book.hpp"
#include "recording/ros/unusable.hpp"
#include "tests/unit/recording/ros/ros_bytes.hpp"

namespace cleave::recording::ros {
namespace {

std::vector<float> depth(const ImageSpec& image, Format format = Format::cdr_le) {
  const Bytes message = bytes_of_image(image, format);
  return depth_of(read_image(reader_of(message, format == Format::ros1 ? Wire::ros1 : Wire::cdr)));
}

template <class Pixel>
ImageSpec image_of(const std::vector<Pixel>& pixels, const char* encoding, bool big_endian,
                   std::uint32_t padding) {
  ImageSpec image;
  image.encoding = encoding;
  image.big_endian = big_endian;
  image.step = image.width * static_cast<std::uint32_t>(sizeof(Pixel)) + padding;
  image.data.clear();
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    append(image.data, bytes_of_number(pixels[i], big_endian));
    if (i % image.width == image.width - 1) append(image.data, Bytes(padding, std::byte{0xA5}));
  }
  return image;
}

TEST(DepthImage, TakesMillimetresOf16BitsInEveryLayout) {
  const std::vector<std::uint16_t> pixels = {1, 1000, 65535, 0, 256, 7};
  for (const char* const encoding : {"16UC1", "mono16"}) {
    for (const bool big_endian : {false, true}) {
      for (const std::uint32_t padding : {0U, 3U}) {
        for (const Format format : {Format::cdr_le, Format::cdr_be, Format::ros1}) {
          const auto metres = depth(image_of(pixels, encoding, big_endian, padding), format);
          ASSERT_EQ(metres.size(), 6U);
          EXPECT_EQ(metres[1], 1000 * 0.001F);
          EXPECT_EQ(metres[2], 65535 * 0.001F);
          EXPECT_TRUE(std::isnan(metres[3]));
          EXPECT_EQ(metres[4], 256 * 0.001F);
        }
      }
    }
  }
}

TEST(DepthImage, TakesMetresOf32BitsAndAllThatIsNoDistanceAsNoMeasurement) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  const std::vector<float> pixels = {1.25F, NAN, inf, -inf, 0, -2};
  for (const bool big_endian : {false, true}) {
    const auto metres = depth(image_of(pixels, "32FC1", big_endian, 5));
    EXPECT_EQ(metres[0], 1.25F);
    for (std::size_t i = 1; i < 6; ++i) EXPECT_TRUE(std::isnan(metres[i])) << i;
  }
}

TEST(DepthImage, NeedsNoPaddingBehindTheLastRow) {
  ImageSpec image = image_of(std::vector<std::uint16_t>(6, 9), "16UC1", false, 4);
  image.data.resize(image.data.size() - 4);
  EXPECT_EQ(depth(image).size(), 6U);
  image.data.pop_back();
  EXPECT_THROW((void)depth(image), Unusable);
}

TEST(DepthImage, RefusesPicturesAndSizesThatCannotBe) {
  ImageSpec image;
  image.encoding = "rgb8";
  EXPECT_THROW((void)depth(image), Unusable);
  image = {};
  image.step = 5;
  EXPECT_THROW((void)depth(image), Unusable);
  image = {};
  image.width = 0;
  EXPECT_THROW((void)depth(image), Unusable);
  image.width = image.height = image.step = 0xFFFFFFFF;
  EXPECT_THROW((void)depth(image), Unusable);
}

CameraInfo info_of(const CameraSpec& camera, Format format = Format::cdr_le) {
  const Bytes message = bytes_of_camera(camera, format);
  return read_camera_info(reader_of(message, format == Format::ros1 ? Wire::ros1 : Wire::cdr));
}

TEST(Camera, IsKOfARawAndPOfARectifiedImage) {
  CameraSpec spec;
  spec.p = {70, 0, 2, 0, 0, 60, 1.5, 0, 0, 0, 1, 0};
  for (const Format format : {Format::cdr_le, Format::cdr_be, Format::ros1}) {
    const CameraInfo info = info_of(spec, format);
    EXPECT_EQ(camera_of(info, ImageKind::raw, 3, 2).intrinsics, (Intrinsics{50, 40, 1, 0.5F}));
    EXPECT_EQ(camera_of(info, ImageKind::rectified, 3, 2).intrinsics,
              (Intrinsics{70, 60, 2, 1.5F}));
  }
  EXPECT_EQ(kind_of("/camera/depth/image_rect_raw"), ImageKind::rectified);
  EXPECT_EQ(kind_of("/rectangle/depth/image_raw"), ImageKind::raw);
}

TEST(Camera, IsTheOtherMatrixWhereOneIsNotSet) {
  CameraSpec spec;
  spec.p.assign(12, 0);
  EXPECT_EQ(camera_of(info_of(spec), ImageKind::rectified, 3, 2).intrinsics.fx, 50);
  spec.k.assign(9, 0);
  EXPECT_THROW((void)camera_of(info_of(spec), ImageKind::raw, 3, 2), Unusable);
  spec.k.assign(9, NAN);
  EXPECT_THROW((void)camera_of(info_of(spec), ImageKind::raw, 3, 2), Unusable);
}

TEST(Camera, IsMovedByTheRegionOfInterestAndScaledByTheBinning) {
  CameraSpec spec;
  spec.width = 640;
  spec.height = 480;
  spec.k = {500, 0, 320, 0, 500, 240, 0, 0, 1};
  spec.binning_x = spec.binning_y = 2;
  EXPECT_EQ(camera_of(info_of(spec), ImageKind::raw, 320, 240).intrinsics,
            (Intrinsics{250, 250, 160, 120}));
  spec.roi_x = 100;
  spec.roi_y = 40;
  spec.roi_width = 200;
  spec.roi_height = 100;
  EXPECT_EQ(camera_of(info_of(spec), ImageKind::raw, 100, 50).intrinsics,
            (Intrinsics{250, 250, 110, 100}));
  EXPECT_THROW((void)camera_of(info_of(spec), ImageKind::raw, 320, 240), Unusable);
}

TEST(Camera, SaysThatTheDistortionOfARawImageIsLeft) {
  CameraSpec spec;
  spec.d = {0.1, 0, 0, 0, 0};
  EXPECT_NE(camera_of(info_of(spec), ImageKind::raw, 3, 2).remark.find("plumb_bob"),
            std::string::npos);
  EXPECT_EQ(camera_of(info_of(spec), ImageKind::rectified, 3, 2).remark, "");
  spec.d = {};
  EXPECT_EQ(camera_of(info_of(spec), ImageKind::raw, 3, 2).remark, "");
}

RecordedCamera camera_at(std::int64_t stamp_ns, std::int64_t log_ns, double fx) {
  RecordedCamera camera{{stamp_ns, log_ns}, {}};
  camera.info.k[0] = fx;
  return camera;
}

TEST(CameraBook, GivesAnImageTheLatestCameraAtOrBeforeItElseTheFirstAfter) {
  CameraBook book(camera_at(100, 100, 1));
  EXPECT_EQ(book.of_image({50, 50}).k[0], 1) << "the first one after";
  book.add(camera_at(100, 100, 1));
  book.add(camera_at(200, 220, 2));
  EXPECT_EQ(book.of_image({150, 150}).k[0], 1);
  EXPECT_EQ(book.of_image({200, 201}).k[0], 2) << "recorded after its image, of the same stamp";
  EXPECT_EQ(book.of_image({900, 900}).k[0], 2);
}

TEST(CameraBook, GoesByTheOrderOfTheFileWhereStampsAreAllTheSame) {
  CameraBook book(camera_at(5, 10, 1));
  book.add(camera_at(5, 10, 1));
  book.add(camera_at(5, 20, 2));
  book.add(camera_at(5, 30, 3));
  EXPECT_EQ(book.of_image({5, 25}).k[0], 2);
  EXPECT_EQ(book.of_image({5, 5}).k[0], 1);
}

}  // namespace
}  // namespace cleave::recording::ros
