// SPDX-License-Identifier: BSD-3-Clause
// A cloud that goes through the program: nothing of it may change but its labels.
#include "recording/pcd/cloud.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <cstring>

#include "recording/pcd/writer.hpp"
#include "tests/unit/recording/pcd/pcd_files.hpp"

namespace cleave::recording {
namespace {

// 3 x 2 points with fields of many types, a padding field, and NaN points.
const char* const many_fields =
    "VERSION 0.7\nFIELDS x y z rgb stamp _ weight vector flag\nSIZE 4 4 4 4 8 1 8 4 1\n"
    "TYPE F F F F I U F F U\nCOUNT 1 1 1 1 1 3 1 3 1\nWIDTH 3\nHEIGHT 2\n"
    "VIEWPOINT 0.1234567891 -2 3 0.70710678118 0 0.70710678118 0\nPOINTS 6\nDATA ascii\n"
    "0 0 1 4.2108e+06 9007199254740993 0 0 0 0.1 1 2 3 0\n"
    "1 0 1 4.2109e+06 -1 0 0 0 0.2 4 5 6 255\n"
    "nan nan nan 0 0 0 0 0 0.3 7 8 9 1\n"
    "0 1 2 1e-20 4 0 0 0 0.4 1 2 3 2\n"
    "1 1 2 0 5 0 0 0 0.5 1 2 3 3\n"
    "2 1 2 0 6 0 0 0 0.6 nan 2 3 4\n";

// The bytes of one field of all points.
std::vector<std::uint8_t> values_of(const PcdCloud& cloud, const std::string& name) {
  std::vector<std::uint8_t> values;
  const auto field = cloud.header().find(name);
  if (!field) return values;
  const std::size_t bytes = cloud.header().fields[*field].bytes();
  const std::size_t step = cloud.header().point_bytes();
  for (std::size_t at = cloud.header().offset_of(*field); at < cloud.data().size(); at += step) {
    const auto value = cloud.data().subspan(at, bytes);
    values.insert(values.end(), value.begin(), value.end());
  }
  return values;
}

const std::vector<std::uint16_t> six_labels = {1, 2, 0, 65535, 1, 3};
const std::vector<std::uint32_t> six_labels_read = {1, 2, 0, 65535, 1, 3};

TEST(PcdCloud, KeepsEveryFieldOrderOrganisationAndViewpoint) {
  const TestFolder folder;
  const auto input = folder.write("in.pcd", many_fields);
  const auto output = folder.path() / "out.pcd";

  PcdCloud cloud = PcdCloud::read(input);
  cloud.set_labels(six_labels);
  write_pcd(output, cloud);

  const PcdCloud before = PcdCloud::read(input);
  const PcdCloud after = PcdCloud::read(output);
  EXPECT_EQ(after.header().width, 3U);
  EXPECT_EQ(after.header().height, 2U);
  for (const char* name : {"x", "y", "z", "rgb", "stamp", "weight", "vector", "flag"}) {
    EXPECT_EQ(values_of(after, name), values_of(before, name)) << name;
    EXPECT_FALSE(values_of(after, name).empty()) << name;
  }
  EXPECT_EQ(after.labels(), six_labels_read);
  const std::string text = read_text(output);
  EXPECT_NE(text.find("FIELDS x y z rgb stamp weight vector flag label\n"), std::string::npos);
  EXPECT_NE(text.find("TYPE F F F F I F F U U\n"), std::string::npos);
  EXPECT_NE(text.find("VIEWPOINT 0.1234567891 -2 3 0.70710678118 0 0.70710678118 0\n"),
            std::string::npos);
}

TEST(PcdCloud, HandsOutCoordinatesInTheFilesOrder) {
  const TestFolder folder;
  const PcdCloud cloud = PcdCloud::read(folder.write("in.pcd", many_fields));
  ASSERT_EQ(cloud.xyz().size(), 18U);
  EXPECT_EQ(cloud.xyz()[15], 2);
  EXPECT_EQ(cloud.xyz()[17], 2);
  EXPECT_TRUE(std::isnan(cloud.xyz()[6]));
}

TEST(PcdCloud, ReplacesALabelOfAnyTypeInItsPlace) {
  for (const char* old_label : {"SIZE 4 4 1 4\nTYPE F F U F\n", "SIZE 4 4 4 4\nTYPE F F F F\n",
                                "SIZE 4 4 8 4\nTYPE F F I F\n"}) {
    const TestFolder folder;
    const auto input =
        folder.write("in.pcd", std::string("VERSION 0.7\nFIELDS x y label z\n") + old_label +
                                   "COUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n"
                                   "DATA ascii\n0 0 9 1\n5 6 8 7\n");
    const auto output = folder.path() / "out.pcd";
    PcdCloud cloud = PcdCloud::read(input);
    cloud.set_labels(std::vector<std::uint16_t>{4, 0});
    write_pcd(output, cloud);

    const PcdCloud after = PcdCloud::read(output);
    EXPECT_NE(read_text(output).find("FIELDS x y label z\n"), std::string::npos);
    EXPECT_EQ(after.labels(), (std::vector<std::uint32_t>{4, 0}));
    EXPECT_EQ(values_of(after, "z"), values_of(PcdCloud::read(input), "z"));
  }
}

TEST(PcdCloud, IsWrittenAsItWasReadOrCompressed) {
  const TestFolder folder;
  const auto text = folder.write("text.pcd", many_fields);
  const PcdCloud cloud = PcdCloud::read(text);
  const auto packed = folder.path() / "packed.pcd";
  write_pcd(packed, cloud);
  EXPECT_NE(read_text(packed).find("DATA binary_compressed\n"), std::string::npos);
  const auto bytes = folder.write("bytes.pcd", binary_file({1, 2, 3, 4, 5, 6}, 2, 1));
  write_pcd(bytes, PcdCloud::read(bytes));
  EXPECT_NE(read_text(bytes).find("DATA binary\n"), std::string::npos);
  EXPECT_EQ(values_of(PcdCloud::read(packed), "vector"), values_of(cloud, "vector"));
}

TEST(PcdWriter, WritesTheSameBytesForTheSameCloud) {
  const TestFolder folder;
  const PcdCloud cloud = PcdCloud::read(folder.write("in.pcd", many_fields));
  write_pcd(folder.path() / "a.pcd", cloud);
  write_pcd(folder.path() / "b.pcd", PcdCloud::read(folder.path() / "a.pcd"));
  EXPECT_EQ(read_text(folder.path() / "a.pcd"), read_text(folder.path() / "b.pcd"));
}

TEST(PcdWriter, MayReplaceItsOwnInputAndFollowsALink) {
  const TestFolder folder;
  const auto file = folder.write("in.pcd", many_fields);
  std::filesystem::create_symlink(file, folder.path() / "link.pcd");
  PcdCloud cloud = PcdCloud::read(file);
  cloud.set_labels(six_labels);
  write_pcd(folder.path() / "link.pcd", cloud);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link.pcd"));
  EXPECT_EQ(PcdCloud::read(file).labels(), six_labels_read);
}

TEST(PcdWriter, LeavesNothingBehindWhereItCannotWrite) {
  const TestFolder folder;
  PcdCloud cloud = PcdCloud::read(folder.write("in.pcd", many_fields));
  EXPECT_THROW(write_pcd(folder.path() / "missing" / "out.pcd", cloud), std::runtime_error);
  EXPECT_THROW(write_pcd(folder.path(), cloud), std::runtime_error);
  const auto entries = std::filesystem::directory_iterator(folder.path());
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1) << "only the input is there";
}

// While it lives, no file grows beyond a size: to a writer, a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    (void)std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(PcdWriter, LeavesTheOldFileWhereTheDiskIsFull) {
  const TestFolder folder;
  const auto file = folder.write("in.pcd", many_fields);
  PcdCloud cloud = PcdCloud::read(file);
  cloud.set_labels(six_labels);
  {
    const FullDisk disk(100);
    EXPECT_THROW(write_pcd(file, cloud), std::runtime_error);
  }
  EXPECT_EQ(read_text(file), many_fields);
  const auto entries = std::filesystem::directory_iterator(folder.path());
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1) << "no temporary file stays behind";
}

TEST(PcdWriter, RefusesToReplaceWhatIsNoRegularFile) {
  const TestFolder folder;
  const PcdCloud cloud = PcdCloud::read(folder.write("in.pcd", many_fields));
  EXPECT_THROW(write_pcd("/dev/null", cloud), std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace cleave::recording
