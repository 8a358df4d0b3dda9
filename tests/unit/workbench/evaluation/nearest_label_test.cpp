// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/nearest_label.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace cleave::evaluation {
namespace {

// A slow oracle: looks at all pairs.
std::vector<std::uint16_t> labelled_by_looking_at_all(const std::vector<float>& xyz,
                                                      const std::vector<std::uint16_t>& labels) {
  std::vector<std::uint16_t> result = labels;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    float best_m = std::numeric_limits<float>::infinity();
    for (std::size_t k = 0; k < labels.size() && labels[i] == 0; ++k) {
      const float distance_m = std::hypot(xyz[3 * k] - xyz[3 * i], xyz[3 * k + 1] - xyz[3 * i + 1],
                                          xyz[3 * k + 2] - xyz[3 * i + 2]);
      if (labels[k] == 0 || !(distance_m < best_m)) continue;
      best_m = distance_m;
      result[i] = labels[k];
    }
  }
  return result;
}

segmentation::CloudView view_of(const std::vector<float>& xyz) {
  return {xyz.data(), 3, static_cast<std::uint32_t>(xyz.size() / 3), 1};
}

TEST(LabelUnlabelled, TakesTheLabelOfTheNearestPoint) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> coordinate_m(-0.3F, 0.3F);
  for (const unsigned labelled_percent : {1U, 30U, 90U}) {
    std::vector<float> xyz(3 * 500);
    std::vector<std::uint16_t> labels(500);
    for (float& value : xyz) value = coordinate_m(random);
    for (std::uint16_t& label : labels) {
      label = random() % 100 < labelled_percent ? static_cast<std::uint16_t>(1 + random() % 9) : 0;
    }
    labels[0] = 1;
    const auto expected = labelled_by_looking_at_all(xyz, labels);

    label_unlabelled(view_of(xyz), labels);

    EXPECT_EQ(labels, expected);
  }
}

TEST(LabelUnlabelled, LeavesPointsThatAreNotFiniteAlone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> xyz = {0, 0, 1, 0, 0, nan, 5, 5, 9};
  std::vector<std::uint16_t> labels = {4, 0, 0};

  label_unlabelled(view_of(xyz), labels);

  EXPECT_EQ(labels, (std::vector<std::uint16_t>{4, 0, 4}));
}

TEST(LabelUnlabelled, DoesNothingWhereNoPointHasALabel) {
  const std::vector<float> xyz = {0, 0, 1, 0, 0, 2};
  std::vector<std::uint16_t> labels = {0, 0};

  label_unlabelled(view_of(xyz), labels);

  EXPECT_EQ(labels, (std::vector<std::uint16_t>{0, 0}));
}

}  // namespace
}  // namespace cleave::evaluation
