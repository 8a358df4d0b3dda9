// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/studies/study.hpp"

#include <gtest/gtest.h>

#include <set>

#include "workbench/cloud/option_setter.hpp"

namespace cleave::workbench {
namespace {

TEST(Studies, AreTheFiguresOfTheThesisThatSweepAnOption) {
  std::set<std::string> figures;
  for (const Study& study : studies()) figures.insert(study.figure);

  EXPECT_EQ(figures, (std::set<std::string>{"5.9", "5.11", "5.12", "5.13"}));
}

TEST(Studies, HaveOptionsThatThereAreAndValuesThatTheyTake) {
  for (const Study& study : studies()) {
    EXPECT_EQ(methods_of(study, {}).size(), study.x.size()) << study.name;
    EXPECT_GE(study.x.size(), 10U);
  }
}

TEST(Studies, TakeOtherValuesForWhatTheyDoNotVary) {
  const Study& study = studies().front();

  EXPECT_NO_THROW((void)methods_of(study, {"voxel.size_m=0.01"}));
  EXPECT_THROW((void)methods_of(study, {"voxel.size_m=big"}), OptionError);
}

TEST(Studies, AreFoundByName) {
  EXPECT_EQ(find_study("eigenvectors-single")->figure, "5.11");
  EXPECT_EQ(find_study("weather"), nullptr);
}

}  // namespace
}  // namespace cleave::workbench
