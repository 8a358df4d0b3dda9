// SPDX-License-Identifier: BSD-3-Clause
#include "config/segmenter_config.hpp"

#include <gtest/gtest.h>

#include "tests/unit/config/yaml_file.hpp"

namespace cleave::config {
namespace {

std::string segmenter_message(const std::string& content) {
  return message_for(content, [](const auto& path) {
    Section file = Section::load(path);
    (void)read_segmenter_config(file);
    file.finish();
  });
}

TEST(SegmenterConfig, AsShippedHoldsTheDefaults) {
  Section file = Section::load(CLEAVE_CONFIG "/segmenter.yaml");
  const SegmenterConfig shipped = read_segmenter_config(file);
  const SegmenterConfig defaults;
  EXPECT_EQ(shipped.sensors, defaults.sensors);
  EXPECT_EQ(shipped.workers, defaults.workers);
  EXPECT_EQ(shipped.queue, defaults.queue);
  EXPECT_EQ(shipped.mode, defaults.mode);
  EXPECT_EQ(shipped.check_unit, defaults.check_unit);
  EXPECT_EQ(shipped.stream.domain, defaults.stream.domain);
  EXPECT_EQ(shipped.stream.shared_memory, defaults.stream.shared_memory);
  EXPECT_EQ(shipped.stream.public_interface, defaults.stream.public_interface);
}

TEST(SegmenterConfig, LeavesTheSegmentationToItsCaller) {
  const YamlFile yaml("segmentation: {voxel: {size_m: 0.01}}\n");
  Section file = Section::load(yaml.path());
  (void)read_segmenter_config(file);
  float size_m = 0;
  Section segmentation = file.section("segmentation");
  segmentation.section("voxel").number("size_m", size_m, 0.001, 0.1);
  file.finish();
  EXPECT_FLOAT_EQ(size_m, 0.01F);
}

TEST(SegmenterConfig, RefusesSensorsThatAreNoneOrTwice) {
  EXPECT_EQ(segmenter_message("sensors: []\n"),
            "file:1: sensors: expected at least one sensor, found a list");
  EXPECT_NE(segmenter_message("sensors: [left, left]\n").find("'left' twice"), std::string::npos);
  EXPECT_NE(segmenter_message("sensors: [left, 'a b']\n").find("'a b'"), std::string::npos);
}

TEST(SegmenterConfig, RefusesCountsOutOfRange) {
  EXPECT_EQ(segmenter_message("workers: 17\n"),
            "file:1: workers: expected a whole number from 0 to 6, found '17'");
  EXPECT_EQ(segmenter_message("queue: 0\n"),
            "file:1: queue: expected a whole number from 1 to 8, found '0'");
}

TEST(SegmenterConfig, LeavesOneCoreToTheRestOfTheSystem) {
  SegmenterConfig config;
  EXPECT_EQ(worker_count(config, 0), 1U);  // unknown
  EXPECT_EQ(worker_count(config, 1), 1U);
  EXPECT_EQ(worker_count(config, 2), 1U);
  EXPECT_EQ(worker_count(config, 4), 3U);
  EXPECT_EQ(worker_count(config, 128), 6U);
  config.workers = 3;
  EXPECT_EQ(worker_count(config, 128), 3U);
}

}  // namespace
}  // namespace cleave::config
