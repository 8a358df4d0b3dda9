// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/evaluation/labelled_cloud.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "recording/pcd/error.hpp"

namespace cleave::evaluation {
namespace {

class LabelledCloudFile : public testing::Test {
 protected:
  LabelledCloudFile() { std::filesystem::create_directory(folder_); }
  ~LabelledCloudFile() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& fields, const std::string& points) {
    std::ofstream(folder_ / "two.pcd")
        << "VERSION 0.7\nFIELDS x y z" << fields << "\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n"
        << points;
    return folder_ / "two.pcd";
  }
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("cleave_clouds_" + std::to_string(::getpid()));
};

const char* const with_label = " label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1";

TEST_F(LabelledCloudFile, HasPointsAndLabels) {
  const LabelledCloud cloud = load_cloud(write(with_label, "1 2 3 7\n4 5 6 0\n"));

  EXPECT_EQ(cloud.xyz, (std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(cloud.label, (std::vector<std::uint32_t>{7, 0}));
  EXPECT_TRUE(cloud.labelled());
  EXPECT_EQ(cloud.view().size(), 2U);
}

TEST_F(LabelledCloudFile, HasNoLabelOnAPointThatIsNotFinite) {
  const LabelledCloud cloud = load_cloud(write(with_label, "1 2 3 7\n0 0 nan 8\n"));

  EXPECT_EQ(cloud.label, (std::vector<std::uint32_t>{7, 0}));
}

TEST_F(LabelledCloudFile, MayHaveNoLabels) {
  const auto file = write("\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1", "1 2 3\n4 5 6\n");

  EXPECT_FALSE(load_cloud(file).labelled());
}

TEST_F(LabelledCloudFile, IsRefusedIfItsLabelsAreNoWholeNumbers) {
  const auto file =
      write(" label\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1", "1 2 3 7\n4 5 6 0\n");

  EXPECT_THROW((void)load_cloud(file), recording::PcdError);
}

}  // namespace
}  // namespace cleave::evaluation
