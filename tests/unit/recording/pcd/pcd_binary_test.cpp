// SPDX-License-Identifier: BSD-3-Clause
// Points as bytes, plain and compressed.
#include <gtest/gtest.h>

#include <cstring>

#include "recording/pcd/cloud.hpp"
#include "tests/unit/recording/pcd/pcd_files.hpp"

namespace cleave::recording {
namespace {

PcdText header_of(const std::string& encoding) {
  PcdText pcd;
  pcd.encoding = encoding;
  pcd.data = "";
  return pcd;
}

std::string file_of(const std::string& encoding, const std::string& data) {
  PcdText pcd = header_of(encoding);
  pcd.data = data;
  return to_file(pcd);
}

std::string sizes_of_block(std::uint32_t packed, std::uint32_t unpacked) {
  return bytes_of(std::vector<std::uint32_t>{packed, unpacked});
}

std::vector<float> points_of(const std::string& content) {
  const TestFolder folder;
  const PcdCloud cloud = PcdCloud::read(folder.write("a.pcd", content));
  return {cloud.xyz().begin(), cloud.xyz().end()};
}

const std::vector<float> two_points = {1, 2, 3, 4, 5, 6};
const std::string by_field = bytes_of(std::vector<float>{1, 4, 2, 5, 3, 6});

TEST(PcdBinary, BeginsBehindTheLineEndWhateverItsFirstByte) {
  std::string first_is_line_end = bytes_of(two_points);
  first_is_line_end[0] = '\n';
  const std::vector<float> points = points_of(file_of("binary", first_is_line_end));
  EXPECT_EQ(std::memcmp(points.data(), first_is_line_end.data(), first_is_line_end.size()), 0);
}

TEST(PcdBinary, MayBeFollowedByMore) {
  EXPECT_EQ(points_of(file_of("binary", bytes_of(two_points) + "trailing")), two_points);
}

TEST(PcdBinary, ThatIsCutOffSaysHowManyPointsThereAre) {
  expect_refused(file_of("binary", std::string(23, '\0')), "truncated",
                 "the header promises 2 points, but the file ends after 1");
}

TEST(PcdBinary, LeavesPaddingBehind) {
  PcdText pcd = header_of("binary");
  pcd.fields = "x _ y z _ ring";
  pcd.size = "4 1 4 4 4 2";
  pcd.type = "F U F F F U";
  pcd.count = "1 3 1 1 0 1";
  const auto point = [](float x, float y, float z) {
    return bytes_of(std::vector{x}) + "pad" + bytes_of(std::vector{y, z}) + "rr";
  };
  pcd.data = point(1, 2, 3) + point(4, 5, 6);
  EXPECT_EQ(points_of(to_file(pcd)), two_points);
}

TEST(PcdCompressed, IsStoredFieldByField) {
  EXPECT_EQ(points_of(file_of("binary_compressed", compressed_body(by_field))), two_points);
}

TEST(PcdCompressed, MayOrMayNotHoldPadding) {
  PcdText pcd = header_of("binary_compressed");
  pcd.fields = "x _ y z";
  pcd.size = "4 1 4 4";
  pcd.type = "F U F F";
  pcd.count = "1 3 1 1";
  pcd.data = compressed_body(by_field);
  EXPECT_EQ(points_of(to_file(pcd)), two_points) << "as PCL writes it";
  std::string with_padding = by_field;
  with_padding.insert(8, "padpad");
  pcd.data = compressed_body(with_padding);
  EXPECT_EQ(points_of(to_file(pcd)), two_points) << "as others do";
}

TEST(PcdCompressed, ThatIsCutOffIsTruncated) {
  std::string body = compressed_body(by_field);
  body.pop_back();
  expect_refused(file_of("binary_compressed", body), "truncated", "so that none of its 2 points");
  expect_refused(file_of("binary_compressed", "abc"), "truncated", "ends after 0");
  expect_refused(file_of("binary_compressed", sizes_of_block(20, 24) + "abc"), "truncated",
                 "20 bytes ends after 3");
}

TEST(PcdCompressed, OfAnotherSizeIsDamaged) {
  expect_refused(file_of("binary_compressed", compressed_body(by_field + "more")), "damaged data",
                 "promises 2 points of 12 bytes, but its compressed block unpacks to 28 bytes");
  expect_refused(file_of("binary_compressed", sizes_of_block(100, 2400) + std::string(100, 'a')),
                 "damaged data", "unpacks to 2400 bytes");
}

TEST(PcdCompressed, ThatCannotUnpackToItsSizeIsRefusedBeforeAnythingIsAllocated) {
  PcdText pcd = header_of("binary_compressed");
  pcd.width = pcd.points = "80000000";
  pcd.data = sizes_of_block(3, 960000000) + "abc";
  expect_refused(to_file(pcd), "damaged data", "cannot unpack to 960000000");
}

TEST(PcdCompressed, OfNothingCannotUnpackToPoints) {
  PcdText pcd = header_of("binary_compressed");
  pcd.width = pcd.points = "1";
  pcd.data = sizes_of_block(0, 12);
  expect_refused(to_file(pcd), "damaged data", "block of 0 bytes cannot unpack to 12");
  pcd.data += "abc";
  expect_refused(to_file(pcd), "damaged data", "block of 0 bytes cannot unpack to 12");
}

TEST(PcdCompressed, OfAnyFewBytesGivesPointsOrIsDamaged) {
  PcdText pcd = header_of("binary_compressed");
  pcd.width = pcd.points = "1";
  for (std::uint32_t first = 0; first < 256; ++first) {
    for (std::uint32_t size = 1; size < 4; ++size) {
      pcd.data = sizes_of_block(size, 12) + std::string(size, static_cast<char>(first));
      expect_refused(to_file(pcd), "damaged data", "cannot be decoded");
    }
  }
}

TEST(PcdCompressed, ThatRefersToBeforeItsBeginningIsDamaged) {
  std::string body = compressed_body(by_field);
  body[8] = '\xff';
  expect_refused(file_of("binary_compressed", body), "damaged data", "cannot be decoded");
  expect_refused(file_of("binary_compressed", sizes_of_block(3, 24) + "\xff\xff\xff"),
                 "damaged data", "cannot be decoded");
}

}  // namespace
}  // namespace cleave::recording
