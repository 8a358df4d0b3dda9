#include "cleave/cloud/pcd_cloud.hpp"

#include <gtest/gtest.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>

#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <cstring>

#include "cleave/cloud/pcd_writer.hpp"
#include "temporary_folder.hpp"

namespace cleave::client {
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

// What PCL, which wrote none of it, finds in a file.
pcl::PCLPointCloud2 read_by_pcl(const std::filesystem::path& file) {
  pcl::PCLPointCloud2 cloud;
  EXPECT_EQ(pcl::PCDReader().read(file.string(), cloud), 0);
  return cloud;
}

std::vector<std::uint8_t> values_of(const pcl::PCLPointCloud2& cloud, const std::string& name) {
  std::vector<std::uint8_t> values;
  for (const auto& field : cloud.fields) {
    if (field.name != name) continue;
    const std::size_t bytes =
        field.count * static_cast<std::size_t>(pcl::getFieldSize(field.datatype));
    for (std::size_t at = field.offset; at < cloud.data.size(); at += cloud.point_step) {
      values.insert(values.end(), &cloud.data[at], &cloud.data[at] + bytes);
    }
  }
  return values;
}

std::vector<std::uint32_t> labels_of(const pcl::PCLPointCloud2& cloud) {
  const std::vector<std::uint8_t> bytes = values_of(cloud, "label");
  std::vector<std::uint32_t> labels(bytes.size() / 4);
  std::memcpy(labels.data(), bytes.data(), bytes.size());
  return labels;
}

const std::vector<std::uint16_t> six_labels = {1, 2, 0, 65535, 1, 3};
const std::vector<std::uint32_t> six_labels_read = {1, 2, 0, 65535, 1, 3};

TEST(PcdCloud, KeepsEveryFieldOrderOrganisationAndViewpoint) {
  const TemporaryFolder folder;
  const auto input = folder.file("in.pcd", many_fields);
  const auto output = folder.path() / "out.pcd";

  PcdCloud cloud = PcdCloud::read(input);
  cloud.set_labels(six_labels);
  write_pcd(output, cloud);

  const pcl::PCLPointCloud2 before = read_by_pcl(input);
  const pcl::PCLPointCloud2 after = read_by_pcl(output);
  EXPECT_EQ(after.width, 3U);
  EXPECT_EQ(after.height, 2U);
  for (const char* name : {"x", "y", "z", "rgb", "stamp", "weight", "vector", "flag"}) {
    EXPECT_EQ(values_of(after, name), values_of(before, name)) << name;
    EXPECT_FALSE(values_of(after, name).empty()) << name;
  }
  EXPECT_EQ(labels_of(after), six_labels_read);
  const std::string text = read_file(output);
  EXPECT_NE(text.find("FIELDS x y z rgb stamp weight vector flag label\n"), std::string::npos);
  EXPECT_NE(text.find("TYPE F F F F I F F U U\n"), std::string::npos);
  EXPECT_NE(text.find("VIEWPOINT 0.1234567891 -2 3 0.70710678118 0 0.70710678118 0\n"),
            std::string::npos);
}

TEST(PcdCloud, HandsOutCoordinatesInTheFilesOrder) {
  const TemporaryFolder folder;
  const PcdCloud cloud = PcdCloud::read(folder.file("in.pcd", many_fields));
  const segmentation::CloudView view = cloud.view();
  ASSERT_EQ(view.size(), 6U);
  EXPECT_TRUE(view.organised());
  EXPECT_EQ(view.point(5)[0], 2);
  EXPECT_EQ(view.point(5)[2], 2);
  EXPECT_TRUE(std::isnan(view.point(2)[0]));
}

TEST(PcdCloud, ReadsCoordinatesOfDoublePrecisionInAnyPlace) {
  const TemporaryFolder folder;
  const PcdCloud cloud = PcdCloud::read(folder.file(
      "in.pcd",
      "VERSION 0.7\nFIELDS flag z y x\nSIZE 1 8 4 8\nTYPE U F F F\nWIDTH 1\nHEIGHT 1\nPOINTS 1\n"
      "DATA ascii\n7 3.5 2.5 1.5\n"));
  EXPECT_EQ(cloud.view().point(0)[0], 1.5F);
  EXPECT_EQ(cloud.view().point(0)[1], 2.5F);
  EXPECT_EQ(cloud.view().point(0)[2], 3.5F);
}

TEST(PcdCloud, ReplacesALabelOfAnyTypeInItsPlace) {
  for (const char* old_label : {"SIZE 4 4 1 4\nTYPE F F U F\n", "SIZE 4 4 4 4\nTYPE F F F F\n",
                                "SIZE 4 4 8 4\nTYPE F F I F\n"}) {
    const TemporaryFolder folder;
    const auto input =
        folder.file("in.pcd", std::string("VERSION 0.7\nFIELDS x y label z\n") + old_label +
                                  "COUNT 1 1 1 1\nWIDTH 2\nHEIGHT 1\nPOINTS 2\n"
                                  "DATA ascii\n0 0 9 1\n5 6 8 7\n");
    const auto output = folder.path() / "out.pcd";
    PcdCloud cloud = PcdCloud::read(input);
    cloud.set_labels(std::vector<std::uint16_t>{4, 0});
    write_pcd(output, cloud);

    const pcl::PCLPointCloud2 after = read_by_pcl(output);
    EXPECT_NE(read_file(output).find("FIELDS x y label z\n"), std::string::npos);
    EXPECT_EQ(labels_of(after), (std::vector<std::uint32_t>{4, 0}));
    EXPECT_EQ(values_of(after, "z"), values_of(read_by_pcl(input), "z"));
  }
}

TEST(PcdCloud, IsWrittenAsItWasReadOrCompressed) {
  for (const auto& [from, to] :
       {std::pair("ascii", "binary_compressed"), std::pair("binary", "binary"),
        std::pair("binary_compressed", "binary_compressed")}) {
    const TemporaryFolder folder;
    const auto ascii = folder.file("ascii.pcd", many_fields);
    const auto input = folder.path() / "in.pcd";
    const pcl::PCLPointCloud2 cloud = read_by_pcl(ascii);
    if (from == std::string("binary")) {
      pcl::PCDWriter().writeBinary(input.string(), cloud);
    } else if (from == std::string("binary_compressed")) {
      pcl::PCDWriter().writeBinaryCompressed(input.string(), cloud);
    } else {
      std::filesystem::copy(ascii, input);
    }
    PcdCloud labelled = PcdCloud::read(input);
    labelled.set_labels(six_labels);
    write_pcd(folder.path() / "out.pcd", labelled);

    EXPECT_NE(read_file(folder.path() / "out.pcd").find(std::string("DATA ") + to + "\n"),
              std::string::npos);
    EXPECT_EQ(values_of(read_by_pcl(folder.path() / "out.pcd"), "vector"),
              values_of(cloud, "vector"));
  }
}

TEST(PcdWriter, MayReplaceItsOwnInputAndFollowsALink) {
  const TemporaryFolder folder;
  const auto file = folder.file("in.pcd", many_fields);
  std::filesystem::create_symlink(file, folder.path() / "link.pcd");
  PcdCloud cloud = PcdCloud::read(file);
  cloud.set_labels(six_labels);
  write_pcd(folder.path() / "link.pcd", cloud);
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link.pcd"));
  EXPECT_EQ(labels_of(read_by_pcl(file)), six_labels_read);
}

TEST(PcdWriter, LeavesNothingBehindWhereItCannotWrite) {
  const TemporaryFolder folder;
  PcdCloud cloud = PcdCloud::read(folder.file("in.pcd", many_fields));
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
  const TemporaryFolder folder;
  const auto file = folder.file("in.pcd", many_fields);
  PcdCloud cloud = PcdCloud::read(file);
  cloud.set_labels(six_labels);
  {
    const FullDisk disk(100);
    EXPECT_THROW(write_pcd(file, cloud), std::runtime_error);
  }
  EXPECT_EQ(read_file(file), many_fields);
  const auto entries = std::filesystem::directory_iterator(folder.path());
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1) << "no temporary file stays behind";
}

TEST(PcdWriter, RefusesToReplaceWhatIsNoRegularFile) {
  const TemporaryFolder folder;
  const PcdCloud cloud = PcdCloud::read(folder.file("in.pcd", many_fields));
  EXPECT_THROW(write_pcd("/dev/null", cloud), std::runtime_error);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace cleave::client
