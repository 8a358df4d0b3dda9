// PCD files that lie: no crash, no hang, an error that names the file, or points.
#include <gtest/gtest.h>

#include <random>

#include "recording/pcd/cloud.hpp"
#include "recording/pcd/writer.hpp"
#include "tests/unit/recording/pcd_files.hpp"

namespace cleave::recording {
namespace {

void expect_points_or_an_error(const std::filesystem::path& file, const std::string& what) {
  try {
    const PcdCloud cloud = PcdCloud::read(file);
    EXPECT_EQ(cloud.xyz().size(), 3 * cloud.header().points()) << what;
    EXPECT_EQ(cloud.data().size(), cloud.header().point_bytes() * cloud.header().points()) << what;
  } catch (const PcdError& error) {
    EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos)
        << what << ": " << error.what();
  }
}

// 20 points with padding and fields of many kinds, in one encoding.
std::string small_file(const std::string& encoding) {
  PcdText pcd = {"x _ y stamp z ring",
                 "4 1 8 8 4 2",
                 "F U F U F I",
                 "1 3 1 2 1 1",
                 "5",
                 "4",
                 "0 0 0 1 0 0 0",
                 "20",
                 encoding,
                 ""};
  for (int i = 0; i < 20; ++i) pcd.data += std::to_string(i) + " 0 0 0 0.5 77 78 1e-1 -5\n";
  if (encoding == "ascii") return to_file(pcd);
  if (encoding == "binary") {
    pcd.data = std::string(std::size_t{20} * 37, 'a');
    return to_file(pcd);
  }
  pcd.encoding = "ascii";
  const TestFolder folder;
  const PcdCloud cloud = PcdCloud::read(folder.write("ascii.pcd", to_file(pcd)));
  write_pcd(folder.path() / "compressed.pcd", cloud);
  return read_text(folder.path() / "compressed.pcd");
}

class DamagedPcd : public testing::TestWithParam<const char*> {};

TEST_P(DamagedPcd, Of1000MutationsGivesPointsOrAnError) {
  const TestFolder folder;
  const std::string whole = small_file(GetParam());
  ASSERT_EQ(refusal_of(whole), "");
  std::mt19937 random(11);
  for (std::size_t i = 0; i < 1000; ++i) {
    std::string bytes = whole;
    for (std::size_t changes = 1 + random() % 6; changes > 0; --changes) {
      bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    expect_points_or_an_error(folder.write("mutated.pcd", bytes), "mutation " + std::to_string(i));
  }
}

TEST_P(DamagedPcd, Of200TruncationsGivesPointsOrAnError) {
  const TestFolder folder;
  const std::string whole = small_file(GetParam());
  std::mt19937 random(12);
  for (std::size_t i = 0; i < 200; ++i) {
    std::string bytes = whole;
    bytes.resize(random() % bytes.size());
    expect_points_or_an_error(folder.write("cut.pcd", bytes), "cut " + std::to_string(i));
  }
}

INSTANTIATE_TEST_SUITE_P(Encodings, DamagedPcd,
                         testing::Values("ascii", "binary", "binary_compressed"),
                         [](const auto& info) { return std::string(info.param); });

}  // namespace
}  // namespace cleave::recording
