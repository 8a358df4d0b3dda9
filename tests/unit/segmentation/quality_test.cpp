#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <iostream>
#include <vector>

#include "segmentation/segmenter.hpp"
#include "tests/support/covering.hpp"
#include "tests/support/labelled_cloud.hpp"

namespace cleave::segmentation {
namespace {

TEST(Quality, CoversTheLabelledScenes) {
  const auto folder = tests::find_data("mosd/learn");
  if (!folder) GTEST_SKIP() << "mosd/learn is not below CLEAVE_DATA; see the README";
  const auto files = tests::list_clouds(*folder);
  ASSERT_FALSE(files.empty());
  Segmenter segmenter;
  double weighted = 0;
  double unweighted = 0;

  for (const auto& file : files) {
    tests::LabelledCloud cloud = tests::load_labelled_cloud(file);
    for (std::size_t i = 0; i < cloud.label.size(); ++i) {
      if (!std::isfinite(cloud.xyz[3 * i + 2])) cloud.label[i] = 0;  // some have a label
    }
    std::vector<std::uint16_t> labels(cloud.label.size());
    Segmentation result;
    ASSERT_EQ(segmenter.segment(cloud.view(), labels, result), Outcome::segmented) << file;
    const tests::Quality quality = tests::judge(cloud.label, labels);
    weighted += quality.weighted_covering / static_cast<double>(files.size());
    unweighted += quality.unweighted_covering / static_cast<double>(files.size());
  }

  std::cout << "weighted covering " << weighted << ", unweighted " << unweighted << " over "
            << files.size() << " scenes\n";
  EXPECT_GE(weighted, 0.993);
  EXPECT_GE(unweighted, 0.95);
}

}  // namespace
}  // namespace cleave::segmentation
