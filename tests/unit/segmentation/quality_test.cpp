// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdint>
#include <iostream>
#include <vector>

#include "recording/pcd/folder.hpp"
#include "segmentation/segmenter.hpp"
#include "tests/support/data_folder.hpp"
#include "workbench/evaluation/labelled_cloud.hpp"
#include "workbench/evaluation/quality.hpp"

namespace cleave::segmentation {
namespace {

TEST(Quality, CoversTheLabelledScenes) {
  const auto folder = tests::find_data("mosd/learn");
  if (!folder) GTEST_SKIP() << "mosd/learn is not below CLEAVE_DATA; see the README";
  const auto files = recording::pcd_files(*folder);
  Segmenter segmenter;
  double weighted = 0;
  double unweighted = 0;

  for (const auto& file : files) {
    const evaluation::LabelledCloud cloud = evaluation::load_cloud(file);
    std::vector<std::uint16_t> labels(cloud.label.size());
    Segmentation result;
    ASSERT_EQ(segmenter.segment(cloud.view(), labels, result), Outcome::segmented) << file;
    const evaluation::Quality quality = evaluation::judge(cloud.label, labels);
    weighted += quality.weighted_covering / static_cast<double>(files.size());
    unweighted += quality.unweighted_covering / static_cast<double>(files.size());
  }

  std::cout << "weighted covering " << weighted << ", unweighted " << unweighted << " over "
            << files.size() << " scenes\n";
  EXPECT_GE(weighted, 0.9955);
  EXPECT_GE(unweighted, 0.97);
}

}  // namespace
}  // namespace cleave::segmentation
