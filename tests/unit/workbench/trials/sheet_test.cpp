// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/trials/sheet.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace cleave::workbench {
namespace {

// 4 x 2 points; left half label 7, right half label 9, the last point unlabelled.
evaluation::LabelledCloud halves() {
  evaluation::LabelledCloud cloud{
      .width = 4, .height = 2, .xyz = {}, .label = {7, 7, 9, 9, 7, 7, 9, 0}};
  for (int i = 0; i < 8; ++i) cloud.xyz.insert(cloud.xyz.end(), {0.0F, 0.0F, 1.0F});
  return cloud;
}

bool is_green(const Rgb& colour) {
  return colour.green > 2 * colour.red && colour.green > 2 * colour.blue;
}
bool is_red(const Rgb& colour) {
  return colour.red > 2 * colour.green && colour.red > 2 * colour.blue;
}

TEST(Sheet, HasARowForTheSceneAndOneForEachResult) {
  const auto cloud = halves();
  Sheet sheet(cloud);
  const std::vector<std::uint16_t> found(8, 1);

  sheet.add_result(found);
  sheet.add_result(found);

  EXPECT_EQ(sheet.picture().width, 8U);
  EXPECT_EQ(sheet.picture().height, 6U);
}

TEST(Sheet, PaintsRightPointsGreenAndWrongOnesRed) {
  const auto cloud = halves();
  Sheet sheet(cloud);

  sheet.add_result(std::vector<std::uint16_t>{3, 5, 5, 5, 3, 3, 5, 5});

  EXPECT_TRUE(is_green(sheet.picture().at(4, 2)));
  EXPECT_TRUE(is_red(sheet.picture().at(5, 2))) << "it belongs to the right half";
  EXPECT_TRUE(is_green(sheet.picture().at(6, 2)));
  const Rgb unknown = sheet.picture().at(7, 3);
  EXPECT_EQ(unknown.red, unknown.green) << "nothing is known of it";
}

TEST(Sheet, GivesAResultTheColoursOfTheTruthThatItStandsFor) {
  const auto cloud = halves();
  Sheet sheet(cloud);

  sheet.add_result(std::vector<std::uint16_t>{2, 2, 1, 1, 2, 2, 1, 1});

  EXPECT_EQ(sheet.picture().at(0, 2), sheet.picture().at(4, 0));
}

TEST(SheetName, TellsScenesOfTheSameNameApart) {
  EXPECT_EQ(sheet_name(7, "a/learn7.pcd"), "007-learn7.png");
  EXPECT_NE(sheet_name(1, "a/x.pcd"), sheet_name(2, "b/x.pcd"));
}

}  // namespace
}  // namespace cleave::workbench
