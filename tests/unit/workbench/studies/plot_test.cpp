// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/studies/plot.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "recording/replace_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace cleave::workbench {
namespace {

const std::vector<StudyPoint> points = {{5, 0.1, 60, 0.8, 0.72}, {90, 5, 2, 0.9, 0.8}};

TEST(StudyData, HasALineAPoint) {
  const std::string data = data_of(studies().front(), points, 20);

  EXPECT_NE(data.find("means over 20 scenes"), std::string::npos);
  EXPECT_NE(data.find("\n5 0.1000 60.0000 0.800000 0.720000\n90 "), std::string::npos) << data;
}

TEST(StudyScript, CropsOverSegmentationAsFigure5_9Does) {
  EXPECT_NE(script_of(studies().front(), points).find("set yrange [0:25]"), std::string::npos);
  EXPECT_NE(script_of(studies().front(), {points[1]}).find("set yrange [0:6]"), std::string::npos);
}

TEST(StudyScript, DrawsSvgAndPngInAFolderOfAnyName) {
  const tests::TemporaryFolder folder;
  const auto place = folder.path() / "it's here, \"now\"";
  recording::make_folder(place);
  const Study& study = studies().front();
  recording::replace_file(place / (study.name + ".dat"), data_of(study, points, 1));
  recording::replace_file(place / (study.name + ".gnuplot"), script_of(study, points));

  draw(place / (study.name + ".gnuplot"));

  EXPECT_EQ(tests::read_file(place / (study.name + ".png")).substr(1, 3), "PNG");
  const std::string svg = tests::read_file(place / (study.name + ".svg"));
  EXPECT_NE(svg.find("weighted covering"), std::string::npos);
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
}

TEST(StudyScript, ThatGnuplotCannotDrawIsAFailure) {
  const tests::TemporaryFolder folder;
  const auto script = folder.file("broken.gnuplot", "plot 'nothing.dat'\n");

  EXPECT_THROW(draw(script), std::runtime_error);
}

}  // namespace
}  // namespace cleave::workbench
