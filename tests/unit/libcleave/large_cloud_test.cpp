// SPDX-License-Identifier: BSD-3-Clause
// Small and large clouds and label maps over the network path: readers take whichever comes.
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <optional>
#include <thread>

#include "libcleave/cloud_reader.hpp"
#include "libcleave/cloud_writer.hpp"
#include "libcleave/stream.hpp"

namespace cleave {
namespace {

struct Size {
  std::uint32_t width, height;
};

class SmallAndLarge : public testing::TestWithParam<Size> {
 protected:
  static bool eventually(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
  }
  template <class Reader>
  static auto receive(Reader& reader) {
    auto sample = reader.take();
    (void)eventually([&] { return sample || (sample = reader.take()); });
    return sample;
  }
  [[nodiscard]] static std::uint64_t points() {
    return std::uint64_t{GetParam().width} * GetParam().height;
  }

  Stream stream_{{.domain = 31, .shared_memory = false}};
};

TEST_P(SmallAndLarge, CloudsArriveWithEveryPoint) {
  CloudWriter writer(stream_, "camera");
  CloudReader reader(stream_, "camera");
  ASSERT_TRUE(eventually([&] { return writer.matched_readers() == 1; }));

  std::optional<CloudLoan> loan = writer.loan(points());
  ASSERT_TRUE(loan);
  loan->header() = {};
  loan->header().width = GetParam().width;
  loan->header().height = GetParam().height;
  for (std::size_t i = 0; i < 3 * points(); ++i) loan->room()[i] = static_cast<float>(i % 65521);
  ASSERT_TRUE(std::move(*loan).publish());

  const std::optional<CloudSample> cloud = receive(reader);
  ASSERT_TRUE(cloud);
  EXPECT_EQ(cloud->large(), is_large(points()));
  ASSERT_EQ(cloud->xyz().size(), 3 * points());
  for (std::size_t i = 0; i < 3 * points(); ++i) {
    ASSERT_EQ(cloud->xyz()[i], static_cast<float>(i % 65521)) << i;
  }
}

TEST_P(SmallAndLarge, LabelMapsArriveWithEveryLabelAndTheTimeOfTheirCloud) {
  LabelWriter writer(stream_, "camera");
  LabelReader reader(stream_, "camera");
  ASSERT_TRUE(eventually([&] { return writer.matched_readers() == 1; }));

  std::optional<LabelLoan> loan = writer.loan(points());
  ASSERT_TRUE(loan);
  loan->header() = {};
  loan->header().width = GetParam().width;
  loan->header().height = GetParam().height;
  loan->cloud_publication_time_ns() = 123;
  for (std::size_t i = 0; i < points(); ++i)
    loan->room()[i] = static_cast<std::uint16_t>(i % 65521);
  ASSERT_TRUE(std::move(*loan).publish());

  const std::optional<LabelSample> labels = receive(reader);
  ASSERT_TRUE(labels);
  EXPECT_EQ(labels->cloud_publication_time_ns(), 123);
  ASSERT_EQ(labels->labels().size(), points());
  EXPECT_EQ(labels->labels().back(), (points() - 1) % 65521);
}

TEST_P(SmallAndLarge, CloudsWhoseHeaderLiesAboutTheirSizeHaveNoPoints) {
  CloudWriter writer(stream_, "camera");
  CloudReader reader(stream_, "camera");
  ASSERT_TRUE(eventually([&] { return writer.matched_readers() == 1; }));
  std::optional<CloudLoan> loan = writer.loan(points());
  ASSERT_TRUE(loan);
  loan->header() = {};
  loan->header().width = 0xFFFFFFFF;
  loan->header().height = 0xFFFFFFFF;
  ASSERT_TRUE(std::move(*loan).publish());

  const std::optional<CloudSample> cloud = receive(reader);
  ASSERT_TRUE(cloud);
  EXPECT_TRUE(cloud->xyz().empty());
}

INSTANTIATE_TEST_SUITE_P(Sizes, SmallAndLarge,
                         testing::Values(Size{640, 480}, Size{848, 480}, Size{1280, 720},
                                         Size{1600, 1200}),
                         [](const auto& size) {
                           return std::to_string(size.param.width) + "x" +
                                  std::to_string(size.param.height);
                         });

TEST(CloudWriterLimits, MoreThanTheLargestImageIsNotLoaned) {
  Stream stream({.domain = 31, .shared_memory = false});
  CloudWriter writer(stream, "camera");
  EXPECT_FALSE(writer.loan(capacity_points + 1));
  EXPECT_TRUE(writer.loan(capacity_points));
}

}  // namespace
}  // namespace cleave
