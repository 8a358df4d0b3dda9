// PCD files that lie to the grabber: no crash, no hang, a reason or points.
#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "sensor/pcd_reader.hpp"
#include "tests/unit/grabber/pcd_file.hpp"

namespace cleave::sensor {
namespace {

constexpr std::chrono::seconds longest{5};

void expect_points_or_a_reason(const std::filesystem::path& file, const std::string& what) {
  const auto start = std::chrono::steady_clock::now();
  const auto read = read_pcd(file);
  if (const auto* const cloud = std::get_if<PointCloud>(&read)) {
    EXPECT_EQ(cloud->xyz.size(), 3 * std::size_t{cloud->width} * cloud->height) << what;
  } else {
    EXPECT_FALSE(std::get<PcdProblem>(read).cause.empty()) << what;
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, longest) << what;
}

std::vector<std::string> small_files() {
  PcdText compressed;
  compressed.encoding = "binary_compressed";
  compressed.data = compressed_body(bytes_of(std::vector<float>{1, 4, 2, 5, 3, 6}));
  return {to_file(PcdText()), to_file(compressed),
          binary_file({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}, 2, 2)};
}

TEST(DamagedPcd, Of1000MutationsGivesPointsOrAReason) {
  const TestFolder folder;
  const std::vector<std::string> whole = small_files();
  std::mt19937 random(13);
  for (std::size_t i = 0; i < 1000; ++i) {
    std::string bytes = whole[i % whole.size()];
    const std::size_t changes = 1 + random() % 6;
    for (std::size_t c = 0; c < changes; ++c) {
      bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    expect_points_or_a_reason(folder.write("a.pcd", bytes), "mutation " + std::to_string(i));
  }
}

TEST(DamagedPcd, Of200TruncationsGivesPointsOrAReason) {
  const TestFolder folder;
  const std::vector<std::string> whole = small_files();
  std::mt19937 random(14);
  for (std::size_t i = 0; i < 200; ++i) {
    std::string bytes = whole[i % whole.size()];
    bytes.resize(random() % bytes.size());
    expect_points_or_a_reason(folder.write("a.pcd", bytes), "truncation " + std::to_string(i));
  }
}

}  // namespace
}  // namespace cleave::sensor
