// PCD files that lie: no crash, no hang, an error or points.
#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "cleave/cloud/pcd_cloud.hpp"
#include "cleave/cloud/pcd_writer.hpp"
#include "temporary_folder.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::client {
namespace {

constexpr std::chrono::seconds longest{5};

void expect_points_or_an_error(const std::filesystem::path& file, const std::string& what) {
  const auto start = std::chrono::steady_clock::now();
  try {
    const PcdCloud cloud = PcdCloud::read(file);
    EXPECT_EQ(cloud.view().size(), cloud.header().points()) << what;
  } catch (const PcdError& error) {
    EXPECT_NE(std::string(error.what()).find(file.filename().string()), std::string::npos)
        << what << ": " << error.what();
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, longest) << what;
}

// The same points as text, as they are, and compressed.
std::vector<std::string> small_files(const TemporaryFolder& folder) {
  const std::string header =
      "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 20\nHEIGHT 1\n"
      "POINTS 20\nDATA ascii\n";
  std::string text = header;
  for (int i = 0; i < 20; ++i) text += std::to_string(i) + " 0.5 1\n";
  const std::filesystem::path ascii = folder.file("ascii.pcd", text);
  PcdCloud compressed = PcdCloud::read(ascii);
  write_pcd(folder.path() / "compressed.pcd", compressed);
  write_pcd(folder.path() / "binary.pcd",
            PcdCloud::of_points(recording::depth_cloud(1, 8, 6).xyz, 8, 6));
  return {text, read_file(folder.path() / "compressed.pcd"),
          read_file(folder.path() / "binary.pcd")};
}

TEST(DamagedPcd, Of1000MutationsGivesPointsOrAnError) {
  const TemporaryFolder folder;
  const std::vector<std::string> whole = small_files(folder);
  std::mt19937 random(11);
  for (std::size_t i = 0; i < 1000; ++i) {
    std::string bytes = whole[i % whole.size()];
    const std::size_t changes = 1 + random() % 6;
    for (std::size_t c = 0; c < changes; ++c) {
      bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    expect_points_or_an_error(folder.file("mutated.pcd", bytes), "mutation " + std::to_string(i));
  }
}

TEST(DamagedPcd, Of200TruncationsGivesPointsOrAnError) {
  const TemporaryFolder folder;
  const std::vector<std::string> whole = small_files(folder);
  std::mt19937 random(12);
  for (std::size_t i = 0; i < 200; ++i) {
    std::string bytes = whole[i % whole.size()];
    bytes.resize(random() % bytes.size());
    expect_points_or_an_error(folder.file("truncated.pcd", bytes),
                              "truncation " + std::to_string(i));
  }
}

}  // namespace
}  // namespace cleave::client
