// SPDX-License-Identifier: BSD-3-Clause
// PCD files that lie: no crash, no hang, an error that names the file, or points.
#include <gtest/gtest.h>

#include <random>
#include <tuple>

#include "recording/pcd/cloud.hpp"
#include "recording/pcd/writer.hpp"
#include "tests/unit/recording/pcd/pcd_files.hpp"

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

// Points with padding and fields of many kinds, in one encoding.
std::string small_file(const std::string& encoding, std::size_t points) {
  PcdText pcd = {"x _ y stamp z ring",
                 "4 1 8 8 4 2",
                 "F U F U F I",
                 "1 3 1 2 1 1",
                 std::to_string(points),
                 "1",
                 "0 0 0 1 0 0 0",
                 std::to_string(points),
                 encoding,
                 ""};
  for (std::size_t i = 0; i < points; ++i)
    pcd.data += std::to_string(i) + " 0 0 0 0.5 77 78 1e-1 -5\n";
  if (encoding == "ascii") return to_file(pcd);
  if (encoding == "binary") {
    pcd.data = std::string(points * 37, 'a');
    return to_file(pcd);
  }
  pcd.encoding = "ascii";
  const TestFolder folder;
  const PcdCloud cloud = PcdCloud::read(folder.write("ascii.pcd", to_file(pcd)));
  write_pcd(folder.path() / "compressed.pcd", cloud);
  return read_text(folder.path() / "compressed.pcd");
}

// An encoding, and how many points: of one or two, most of the file is sizes.
class DamagedPcd : public testing::TestWithParam<std::tuple<const char*, std::size_t>> {
 protected:
  const std::string whole_ = small_file(std::get<0>(GetParam()), std::get<1>(GetParam()));
};

TEST_P(DamagedPcd, Of1000MutationsGivesPointsOrAnError) {
  const TestFolder folder;
  ASSERT_EQ(refusal_of(whole_), "");
  ASSERT_NE(whole_.find(std::string("DATA ") + std::get<0>(GetParam()) + "\n"), std::string::npos);
  const std::size_t body = whole_.find('\n', whole_.find("DATA ")) + 1;
  std::mt19937 random(11);
  for (std::size_t i = 0; i < 1000; ++i) {
    std::string bytes = whole_;
    for (std::size_t changes = 1 + random() % 6; changes > 0; --changes) {
      // Half of them in the points and their sizes, and half of them 0.
      const std::size_t from = random() % 2 == 0 ? body : 0;
      const bool zero = random() % 2 == 0;
      bytes[from + random() % (bytes.size() - from)] = zero ? '\0' : static_cast<char>(random());
    }
    expect_points_or_an_error(folder.write("mutated.pcd", bytes), "mutation " + std::to_string(i));
  }
}

TEST_P(DamagedPcd, Of200TruncationsGivesPointsOrAnError) {
  const TestFolder folder;
  std::mt19937 random(12);
  for (std::size_t i = 0; i < 200; ++i) {
    std::string bytes = whole_;
    bytes.resize(random() % bytes.size());
    expect_points_or_an_error(folder.write("cut.pcd", bytes), "cut " + std::to_string(i));
  }
}

INSTANTIATE_TEST_SUITE_P(Encodings, DamagedPcd,
                         testing::Combine(testing::Values("ascii", "binary", "binary_compressed"),
                                          testing::Values(1, 2, 20)),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param)) + "_of_" +
                                  std::to_string(std::get<1>(info.param));
                         });

}  // namespace
}  // namespace cleave::recording
