#include "sensor/pcd_header.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/unit/grabber/pcd_file.hpp"

namespace cleave::sensor {
namespace {

class PcdHeaderCheck : public testing::Test {
 protected:
  // The cause of the refusal; empty if it is accepted.
  std::string cause(const std::string& content) const {
    return cause_of(folder_.write("cloud.pcd", content));
  }
  static std::string cause_of(const std::filesystem::path& file) {
    const auto result = read_pcd_header(file);
    const auto* const problem = std::get_if<PcdProblem>(&result);
    return problem == nullptr ? "" : problem->cause;
  }
  TestFolder folder_;
  PcdText pcd_;
};

TEST_F(PcdHeaderCheck, AcceptsAMinimalFile) {
  EXPECT_EQ(cause(to_file(pcd_)), "");
}

TEST_F(PcdHeaderCheck, AcceptsOtherFieldsAndDoubles) {
  pcd_ = {"label x y z normal", "4 8 8 8 4", "U F F F F", "1 1 1 1 3", "1", "1", "1", "ascii",
          "7 1 2 3 0 0 1\n"};
  EXPECT_EQ(cause(to_file(pcd_)), "");
}

TEST_F(PcdHeaderCheck, RefusesWhatIsNotAFile) {
  EXPECT_EQ(cause_of(folder_.path() / "missing.pcd"), "unreadable");
  std::filesystem::create_directory(folder_.path() / "folder.pcd");
  EXPECT_EQ(cause_of(folder_.path() / "folder.pcd"), "unreadable");
  std::filesystem::create_symlink("/nowhere", folder_.path() / "link.pcd");
  EXPECT_EQ(cause_of(folder_.path() / "link.pcd"), "unreadable");
}

TEST_F(PcdHeaderCheck, RefusesAFileThatThisUserMayNotRead) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const auto file = folder_.write("cloud.pcd", to_file(pcd_));
  std::filesystem::permissions(file, std::filesystem::perms::none);
  EXPECT_EQ(cause_of(file), "unreadable");
}

TEST_F(PcdHeaderCheck, RefusesWhatIsNotPcd) {
  EXPECT_EQ(cause(""), "not PCD");
  EXPECT_EQ(cause("ply\nformat ascii 1.0\n"), "not PCD");
  EXPECT_EQ(cause(std::string(1000, '\0')), "not PCD");
  EXPECT_EQ(cause(std::string(100000, 'x')), "not PCD");
}

TEST_F(PcdHeaderCheck, RefusesAHeaderThatEndsEarly) {
  EXPECT_EQ(cause("VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\n"), "truncated");
}

TEST_F(PcdHeaderCheck, RefusesMissingAndUnusableCoordinates) {
  pcd_.fields = "x y intensity";
  EXPECT_EQ(cause(to_file(pcd_)), "bad header");
  pcd_ = {};
  pcd_.type = "F F I";
  EXPECT_EQ(cause(to_file(pcd_)), "bad header");
  pcd_ = {};
  pcd_.count = "1 1 2";
  EXPECT_EQ(cause(to_file(pcd_)), "bad header");
}

TEST_F(PcdHeaderCheck, RefusesSizesThatAreMissingOrImpossible) {
  pcd_.size = "4 4";
  EXPECT_EQ(cause(to_file(pcd_)), "bad header");
  pcd_.size = "4 4 3";
  EXPECT_EQ(cause(to_file(pcd_)), "bad header");
  pcd_ = {};
  pcd_.count = "1 1 0";
  EXPECT_EQ(cause(to_file(pcd_)), "bad header");
  pcd_ = {};
  pcd_.width = "two";
  EXPECT_EQ(cause(to_file(pcd_)), "bad header");
}

TEST_F(PcdHeaderCheck, RefusesALineThatStandsThereTwice) {
  EXPECT_EQ(cause("FIELDS x y z\nWIDTH 1\nWIDTH 100000000\nDATA ascii\n"), "bad header");
}

TEST_F(PcdHeaderCheck, RefusesAWidthAndHeightThatDoNotMakeThePoints) {
  pcd_.width = "3";
  EXPECT_EQ(cause(to_file(pcd_)), "bad header");
  // 2^33 * 2^31 + 2 overflows to 2 in 64 bits.
  pcd_.width = "8589934592";
  pcd_.height = "2147483648";
  EXPECT_EQ(cause(to_file(pcd_)), "bad header");
}

TEST_F(PcdHeaderCheck, RefusesACloudWithoutPoints) {
  pcd_.width = pcd_.height = pcd_.points = "0";
  EXPECT_EQ(cause(to_file(pcd_)), "no points");
}

TEST_F(PcdHeaderCheck, RefusesMorePointsThanACloudHolds) {
  pcd_.width = "307201";
  pcd_.points = "307201";
  EXPECT_EQ(cause(to_file(pcd_)), "too many points");
  pcd_.width = pcd_.points = "4000000000";
  EXPECT_EQ(cause(to_file(pcd_)), "too many points");
}

TEST_F(PcdHeaderCheck, RefusesDataThatIsShorterThanThePointsNeed) {
  pcd_.data = "1 2 3\n4";
  EXPECT_EQ(cause(to_file(pcd_)), "truncated");
  std::string binary = binary_file({1, 2, 3, 4, 5, 6}, 2, 1);
  EXPECT_EQ(cause(binary), "");
  binary.pop_back();
  EXPECT_EQ(cause(binary), "truncated");
}

TEST_F(PcdHeaderCheck, RefusesCompressedDataThatEndsEarlyOrDecodesToAnotherSize) {
  pcd_.encoding = "binary_compressed";
  pcd_.data = compressed_body(std::string(24, 'x'));
  EXPECT_EQ(cause(to_file(pcd_)), "");
  pcd_.data.pop_back();
  EXPECT_EQ(cause(to_file(pcd_)), "truncated");
  pcd_.data = "xxx";
  EXPECT_EQ(cause(to_file(pcd_)), "truncated");
  pcd_.data = compressed_body(std::string(28, 'x'));
  EXPECT_EQ(cause(to_file(pcd_)), "damaged data");
}

TEST_F(PcdHeaderCheck, RefusesFieldsThatWouldDecodeToGigabytes) {
  pcd_ = {"x y z blob", "4 4 4 8", "F F F F",           "1 1 1 400000000",   "2",
          "1",          "2",       "binary_compressed", compressed_body("x")};
  EXPECT_EQ(cause(to_file(pcd_)), "bad header");
}

TEST_F(PcdHeaderCheck, RefusesAnUnknownEncoding) {
  pcd_.encoding = "zip";
  EXPECT_EQ(cause(to_file(pcd_)), "bad header");
}

}  // namespace
}  // namespace cleave::sensor
