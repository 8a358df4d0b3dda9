// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/cloud/option_setter.hpp"

#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>

#include "segmentation/option_visitor.hpp"

namespace cleave::workbench {
namespace {

std::string refusal_of(const std::string& assignment) {
  segmentation::Options options;
  try {
    set_option(options, assignment);
  } catch (const OptionError& error) {
    return error.what();
  }
  return {};
}

TEST(OptionSetter, SetsEachKindOfOption) {
  segmentation::Options options;
  set_option(options, "voxel.size_m=0.005");
  set_option(options, "clean_up.min_segment_points=17");
  set_option(options, "refine.boundary=false");
  set_option(options, "voxel.viewpoint=multiple");
  EXPECT_EQ(options.voxel.size_m, 0.005F);
  EXPECT_EQ(options.clean_up.min_segment_points, 17U);
  EXPECT_FALSE(options.refine.boundary);
  EXPECT_EQ(options.voxel.viewpoint, segmentation::Viewpoint::multiple);
}

TEST(OptionSetter, NamesTheKnownKeysForAnUnknownOne) {
  const std::string refusal = refusal_of("voxel.size=1");
  EXPECT_NE(refusal.find("no option 'voxel.size'"), std::string::npos);
  EXPECT_NE(refusal.find("voxel.size_m"), std::string::npos);
  EXPECT_NE(refusal.find("describe.plane_distance_m"), std::string::npos);
}

TEST(OptionSetter, SaysWhatItExpectedAndWhatItFound) {
  const std::string size = "voxel.size_m: expected a number from 0.0005 to 1, found ";
  EXPECT_EQ(refusal_of("voxel.size_m=fast"), size + "'fast'");
  EXPECT_EQ(refusal_of("voxel.size_m=-1"), size + "'-1'");
  EXPECT_EQ(refusal_of("voxel.size_m=nan"), size + "'nan'");
  EXPECT_EQ(refusal_of("voxel.size_m="), size + "''");
  EXPECT_EQ(refusal_of("voxel.size_m=1.0001"), size + "'1.0001'");
  EXPECT_EQ(refusal_of("clean_up.min_segment_points=1.5"),
            "clean_up.min_segment_points: expected a whole number from 0 to 1000000, found '1.5'");
  EXPECT_EQ(refusal_of("refine.boundary=maybe"),
            "refine.boundary: expected true or false, found 'maybe'");
  EXPECT_EQ(refusal_of("algorithm=magic"),
            "algorithm: expected one of ssc, constrained-ssc, svc, convex-components, found "
            "'magic'");
  EXPECT_EQ(refusal_of("voxel.size_m"),
            "expected KEY=VALUE, e.g. voxel.size_m=0.005, found 'voxel.size_m'");
}

TEST(OptionSetter, LeavesTheOptionsAsTheyWereWhenItRefuses) {
  segmentation::Options options;
  EXPECT_THROW(set_option(options, "voxel.size_m=2"), OptionError);
  EXPECT_EQ(options.voxel.size_m, segmentation::Options().voxel.size_m);
}

struct EachHasALine {
  const std::map<std::string, std::string>& line_of;

  void number(std::string_view name, float, double, double, std::string_view) const { look(name); }
  void integer(std::string_view name, std::uint32_t, std::uint32_t, std::uint32_t,
               std::string_view) const {
    look(name);
  }
  void boolean(std::string_view name, bool, std::string_view) const { look(name); }
  template <typename Choices>
  void choice(std::string_view name, std::size_t, const Choices&, std::string_view) const {
    look(name);
  }

 private:
  void look(std::string_view name) const {
    EXPECT_TRUE(line_of.contains(std::string(name))) << name;
  }
};

TEST(OptionSetter, ListsEveryOptionOnALineWithItsDefaultAndRange) {
  std::istringstream lines(list_options());
  std::map<std::string, std::string> line_of;
  for (std::string line; std::getline(lines, line);) {
    line_of[line.substr(0, line.find(' '))] = line;
  }
  EXPECT_NE(line_of["supervoxel.seed_spacing_m"].find("0.025  0.002 to 10"), std::string::npos);
  EXPECT_NE(line_of["refine.boundary"].find("true  true, false"), std::string::npos);
  EXPECT_NE(line_of["representation"].find("cells  cells, voxels"), std::string::npos);

  // Each can be set to the default that its line names.
  for (const auto& [name, line] : line_of) {
    if (name == "option") continue;
    std::istringstream words(line);
    std::string value;
    words >> value >> value;
    EXPECT_EQ(refusal_of(name + "=" + value), "") << line;
  }
  segmentation::Options options;
  segmentation::visit_options(options, EachHasALine{line_of});
}

}  // namespace
}  // namespace cleave::workbench
