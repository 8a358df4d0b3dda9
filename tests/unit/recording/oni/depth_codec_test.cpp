// SPDX-License-Identifier: BSD-3-Clause
#include "recording/oni/depth_codec.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "tests/unit/recording/oni/oni_file.hpp"

namespace cleave::oni {
namespace {

using test::Image;

std::optional<std::string> decode_text(Codec codec, const std::string& data, Image& pixels) {
  return decode(codec, {reinterpret_cast<const std::uint8_t*>(data.data()), data.size()}, pixels);
}

void expect_round_trip(const Image& image) {
  Image back(image.size());
  EXPECT_EQ(decode_text(Codec::none, test::encode_raw(image), back), std::nullopt);
  EXPECT_EQ(back, image);
  back.assign(image.size(), 7);
  EXPECT_EQ(decode_text(Codec::difference, test::encode_differences(image), back), std::nullopt);
  EXPECT_EQ(back, image);
  back.assign(image.size(), 7);
  EXPECT_EQ(decode_text(Codec::difference_table, test::encode_with_table(image), back),
            std::nullopt);
  EXPECT_EQ(back, image);
}

TEST(DepthCodec, GivesBackImagesOfEverySizeAndRoughness) {
  std::mt19937 random(1);
  for (std::size_t size = 1; size < 200; ++size) {
    for (const unsigned spread : {1U, 2U, 5U, 20U, 90U, 9000U}) {
      Image image(size);
      for (auto& pixel : image) pixel = static_cast<std::uint16_t>(500 + random() % spread);
      expect_round_trip(image);
    }
  }
}

TEST(DepthCodec, GivesBackALastPixelThatFollowsARunInItsPlace) {
  for (std::size_t run = 1; run < 80; ++run) {
    Image image(run, 1000);
    image.push_back(1001);
    expect_round_trip(image);
  }
}

TEST(DepthCodec, GivesBackTheRealisticImage) {
  expect_round_trip(test::example_image(640, 480, 3));
}

TEST(DepthCodec, SaysWhyAnImageThatEndsEarlyIsRefused) {
  const Image image = test::example_image(16, 12, 1);
  for (const Codec codec : {Codec::difference, Codec::difference_table, Codec::none}) {
    const std::string data = codec == Codec::none         ? test::encode_raw(image)
                             : codec == Codec::difference ? test::encode_differences(image)
                                                          : test::encode_with_table(image);
    for (std::size_t length = 0; length < data.size(); ++length) {
      Image back(image.size());
      EXPECT_TRUE(decode_text(codec, data.substr(0, length), back)) << length;
    }
  }
}

TEST(DepthCodec, RefusesMorePixelsThanTheImageHas) {
  Image back(3);
  EXPECT_TRUE(decode_text(Codec::difference, test::encode_differences(Image(5, 9)), back));
}

TEST(DepthCodec, RefusesAnIndexBehindTheTable) {
  Image back(1);
  EXPECT_TRUE(decode_text(Codec::difference_table, std::string("\1\0\x10\x20\1\0", 6), back));
}

TEST(DepthCodec, KnowsTheCodesOfDepthOnly) {
  const auto code = [](const char* name) {
    std::uint32_t value = 0;
    std::memcpy(&value, name, sizeof value);
    return value;
  };
  EXPECT_EQ(codec_of(code("16zT")), Codec::difference_table);
  EXPECT_EQ(codec_of(code("16zP")), Codec::difference);
  EXPECT_EQ(codec_of(code("NONE")), Codec::none);
  EXPECT_EQ(codec_of(code("JPEG")), std::nullopt);
  EXPECT_EQ(name_of_codec(code("JPEG")), "JPEG");
}

}  // namespace
}  // namespace cleave::oni
