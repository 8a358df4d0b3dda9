#include "cleave/cloud/pcd_header.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "cleave/cloud/pcd_cloud.hpp"
#include "temporary_folder.hpp"

namespace cleave::client {
namespace {

// Lines of a good header; each test replaces what it wants to be wrong.
struct Header {
  std::string fields = "x y z";
  std::string sizes = "4 4 4";
  std::string types = "F F F";
  std::string counts = "1 1 1";
  std::string width = "2";
  std::string height = "1";
  std::string viewpoint = "0 0 0 1 0 0 0";
  std::string points = "2";
  std::string data = "ascii";

  [[nodiscard]] std::string text() const {
    return "# .PCD v0.7\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes + "\nTYPE " + types +
           "\nCOUNT " + counts + "\nWIDTH " + width + "\nHEIGHT " + height + "\nVIEWPOINT " +
           viewpoint + "\nPOINTS " + points + "\nDATA " + data + "\n";
  }
};

const std::string two_points = "0 0 1\n1 0 1\n";

// What reading the content as a file says; empty if it is accepted.
std::string refusal_of(const std::string& content) {
  const TemporaryFolder folder;
  const auto file = folder.file("bad.pcd", content);
  try {
    (void)PcdCloud::read(file);
  } catch (const PcdError& error) {
    EXPECT_EQ(std::string(error.what()).rfind(file.string(), 0), 0U) << "names no file";
    return error.what();
  }
  return {};
}

void expect_refused(const std::string& content, const std::string& why) {
  const std::string refusal = refusal_of(content);
  EXPECT_NE(refusal.find(why), std::string::npos) << "refused with: '" << refusal << "'";
}

std::string sizes_of_block(std::uint32_t compressed, std::uint32_t uncompressed) {
  std::string text(8, '\0');
  std::memcpy(text.data(), &compressed, 4);
  std::memcpy(&text[4], &uncompressed, 4);
  return text;
}

TEST(PcdHeader, OfAGoodFileIsAccepted) {
  EXPECT_EQ(refusal_of(Header().text() + two_points), "");
}

TEST(PcdHeader, IsMissingInWhatIsNoPcdFile) {
  expect_refused("", "is no PCD file");
  expect_refused("P6\n640 480\n255\n", "is no PCD file");
  expect_refused(std::string(1 << 20, 'x'), "is no PCD file");
}

// PCL stops reading there, and crashes.
TEST(PcdHeader, RefusesALineThatPclDoesNotKnow) {
  expect_refused("VERSIOZ 0.7\n" + Header().text() + two_points, "none of PCD's words");
}

TEST(PcdHeader, NamesWhatIsMissing) {
  Header header;
  header.fields = "";
  expect_refused(header.text() + two_points, "has no FIELDS");
}

TEST(PcdHeader, RefusesSizesThatDisagree) {
  Header header;
  header.width = "640";
  header.height = "480";
  expect_refused(header.text() + two_points, "WIDTH x HEIGHT is 640 x 480 but its POINTS is 2");
}

TEST(PcdHeader, RefusesHugePointsWithoutAllocatingThem) {
  for (const char* data : {"ascii", "binary"}) {
    Header header;
    header.width = "4294967295";
    header.height = "4294967295";
    header.points = "18446744065119617025";
    header.data = data;
    expect_refused(header.text() + two_points, "the header promises 18446744065119617025 points");
  }
}

TEST(PcdHeader, RefusesNumbersThatAreNone) {
  Header header;
  header.points = "-2";
  expect_refused(header.text() + two_points, "POINTS is '-2'");
  header.points = "2";
  header.width = "99999999999999999999";
  expect_refused(header.text() + two_points, "WIDTH is '99999999999999999999'");
}

TEST(PcdHeader, RefusesAnEmptyCloud) {
  Header header;
  header.width = "0";
  header.points = "0";
  expect_refused(header.text(), "holds no point");
}

TEST(PcdHeader, RefusesListsOfDifferentLengths) {
  Header header;
  header.sizes = "4 4";
  expect_refused(header.text() + two_points, "3, 2, 3 and 3 entries");
}

TEST(PcdHeader, RefusesUnknownTypesAndSizes) {
  Header header;
  header.types = "F F Q";
  expect_refused(header.text() + two_points, "field z has TYPE Q and SIZE 4");
  header.types = "F F F";
  header.sizes = "4 4 3";
  expect_refused(header.text() + two_points, "field z has TYPE F and SIZE 3");
}

TEST(PcdHeader, RefusesCountsOutOfReason) {
  Header header;
  header.counts = "1 1 0";
  expect_refused(header.text() + two_points, "COUNT 0");
  header.counts = "1 1 4000000000";
  expect_refused(header.text() + two_points, "COUNT 4000000000");
}

TEST(PcdHeader, RefusesAFieldThatIsNamedTwice) {
  Header header;
  header.fields = "x y x";
  expect_refused(header.text() + two_points, "names the field x twice");
}

TEST(PcdHeader, RefusesAWrongViewpoint) {
  Header header;
  header.viewpoint = "0 0 0 1";
  expect_refused(header.text() + two_points, "VIEWPOINT has 4 numbers");
  header.viewpoint = "0 0 0 1 0 0 nan";
  expect_refused(header.text() + two_points, "VIEWPOINT has 'nan'");
}

TEST(PcdHeader, RefusesAnUnknownEncoding) {
  Header header;
  header.data = "zip";
  expect_refused(header.text() + two_points, "DATA is 'zip'");
}

TEST(PcdData, RefusesTruncatedText) {
  expect_refused(Header().text() + "0 0 1\n", "1 lines of points follow");
}

TEST(PcdData, RefusesALineWithTooFewNumbersOrNone) {
  expect_refused(Header().text() + "0 0 1\n1 0\n", "point 1 has 2 numbers");
  expect_refused(Header().text() + "0 0 1\n1 0 one\n", "point 1 has 'one'");
}

TEST(PcdData, RefusesTruncatedBinary) {
  Header header;
  header.data = "binary";
  expect_refused(header.text() + std::string(23, '\0'), "23 bytes follow");
}

TEST(PcdData, RefusesATruncatedCompressedBlock) {
  Header header;
  header.data = "binary_compressed";
  expect_refused(header.text() + "abc", "no compressed block follows");
  expect_refused(header.text() + sizes_of_block(20, 24) + "abc", "20 bytes ends after 3");
}

TEST(PcdData, RefusesACompressedBlockOfAnotherSize) {
  Header header;
  header.data = "binary_compressed";
  expect_refused(header.text() + sizes_of_block(3, 2400) + "abc", "unpacks to 2400 bytes");
}

TEST(PcdData, RefusesABlockThatCannotUnpackToItsSize) {
  Header header;
  header.data = "binary_compressed";
  header.width = header.points = "100000000";
  expect_refused(header.text() + sizes_of_block(3, 1200000000) + "abc", "cannot unpack to");
}

TEST(PcdData, RefusesADamagedCompressedBlock) {
  Header header;
  header.data = "binary_compressed";
  expect_refused(header.text() + sizes_of_block(3, 24) + "\xff\xff\xff", "cannot be decoded");
}

TEST(PcdData, RefusesACloudWithoutCoordinates) {
  Header header;
  header.fields = "x y intensity";
  expect_refused(header.text() + two_points, "has no field z");
}

TEST(PcdCloud, RefusesAFileThatIsMissingOrAFolder) {
  const TemporaryFolder folder;
  EXPECT_THROW((void)PcdCloud::read(folder.path() / "missing.pcd"), PcdError);
  EXPECT_THROW((void)PcdCloud::read(folder.path()), PcdError);
}

}  // namespace
}  // namespace cleave::client
