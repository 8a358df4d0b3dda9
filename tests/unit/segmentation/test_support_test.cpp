#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <random>
#include <stdexcept>

#include "tests/support/covering.hpp"
#include "tests/support/labelled_cloud.hpp"

namespace cleave::tests {
namespace {

TEST(Judge, GivesOneToAPerfectSegmentation) {
  const std::vector<std::uint32_t> truth = {20, 20, 1, 1, 1, 0};
  const std::vector<std::uint16_t> found = {2, 2, 1, 1, 1, 9};

  const Quality quality = judge(truth, found);

  EXPECT_DOUBLE_EQ(quality.weighted_covering, 1);
  EXPECT_DOUBLE_EQ(quality.unweighted_covering, 1);
  EXPECT_EQ(quality.under, 0U);
  EXPECT_EQ(quality.over, 0U);
}

TEST(Judge, WorksOutEquations5_2And5_3) {
  // Truth: 6 and 2 points. Found: 5 of the first; the sixth together with the second.
  const std::vector<std::uint32_t> truth = {1, 1, 1, 1, 1, 1, 2, 2};
  const std::vector<std::uint16_t> found = {1, 1, 1, 1, 1, 2, 2, 2};

  const Quality quality = judge(truth, found);

  EXPECT_NEAR(quality.weighted_covering, (6 * 5.0 / 6 + 2 * 2.0 / 3) / 8, 1e-12);
  EXPECT_NEAR(quality.unweighted_covering, (5.0 / 6 + 2.0 / 3) / 2, 1e-12);
}

TEST(Judge, CountsUnderAndOverSegmentation) {
  const std::vector<std::uint32_t> truth = {1, 1, 2, 2, 3, 3, 3};
  const std::vector<std::uint16_t> merged = {1, 1, 1, 1, 2, 2, 2};
  const std::vector<std::uint16_t> split = {1, 1, 2, 2, 3, 4, 4};

  EXPECT_EQ(judge(truth, merged).under, 1U);
  EXPECT_EQ(judge(truth, merged).over, 0U);
  EXPECT_EQ(judge(truth, split).under, 0U);
  EXPECT_EQ(judge(truth, split).over, 1U);
}

TEST(Judge, TakesAnUnlabelledPointForNoSegment) {
  const Quality quality = judge(std::vector<std::uint32_t>{1, 1}, std::vector<std::uint16_t>{0, 1});

  EXPECT_DOUBLE_EQ(quality.weighted_covering, 0.5);
}

TEST(BestAssignment, IsTheBestOfAllPermutations) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<std::vector<double>> gain(4, std::vector<double>(5));
    for (auto& row : gain) {
      for (double& value : row) value = static_cast<double>(random() % 20);
    }
    const auto sum = [&](const std::vector<std::size_t>& column) {
      double total = 0;
      for (std::size_t row = 0; row < gain.size(); ++row) total += gain[row][column[row]];
      return total;
    };
    std::vector<std::size_t> columns(5);
    std::iota(columns.begin(), columns.end(), std::size_t{0});
    double best = 0;
    do best = std::max(best, sum(columns));
    while (std::next_permutation(columns.begin(), columns.end()));

    EXPECT_DOUBLE_EQ(sum(best_assignment(gain)), best);
  }
}

class CloudFolder : public testing::Test {
 protected:
  CloudFolder() { std::filesystem::create_directory(folder_); }
  ~CloudFolder() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("cleave_clouds_" + std::to_string(::getpid()));
};

TEST_F(CloudFolder, IsListedInNaturalOrder) {
  for (const char* name : {"a10.pcd", "a9.pcd", "a09b.pcd", "b1.pcd", "a1.txt"}) write(name, "");

  std::vector<std::string> names;
  for (const auto& file : list_clouds(folder_)) names.push_back(file.filename());

  EXPECT_EQ(names, (std::vector<std::string>{"a9.pcd", "a09b.pcd", "a10.pcd", "b1.pcd"}));
}

TEST_F(CloudFolder, LoadsPointsAndLabels) {
  const auto file = write("two.pcd",
                          "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\n"
                          "COUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ascii\n"
                          "1 2 3 7\n4 5 6 0\n");

  const LabelledCloud cloud = load_labelled_cloud(file);

  EXPECT_EQ(cloud.xyz, (std::vector<float>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(cloud.label, (std::vector<std::uint32_t>{7, 0}));
  EXPECT_EQ(cloud.view().size(), 2U);
}

TEST_F(CloudFolder, NamesTheFileThatCannotBeLoaded) {
  const auto file = write("bare.pcd",
                          "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n"
                          "WIDTH 1\nHEIGHT 1\nPOINTS 1\nDATA ascii\n1 2 3\n");

  EXPECT_THROW((void)load_labelled_cloud(file), std::runtime_error);
  EXPECT_THROW((void)load_labelled_cloud(folder_ / "none.pcd"), std::runtime_error);
}

}  // namespace
}  // namespace cleave::tests
