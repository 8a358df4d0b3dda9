#include "cleave/cloud/pcl_reader.hpp"

#include <pcl/PCLPointCloud2.h>
#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>

namespace cleave::client {
namespace {

pcl::PCLPointCloud2 read_with_pcl(const std::filesystem::path& file) {
  // What PCL would print, the exceptions here say with the file's name.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  pcl::PCLPointCloud2 cloud;
  Eigen::Vector4f origin;
  Eigen::Quaternionf orientation;
  int version = 0;
  std::string reason = "PCL's reader refuses it";
  try {
    if (pcl::PCDReader().read(file.string(), cloud, origin, orientation, version) == 0) {
      return cloud;
    }
  } catch (const std::exception& error) {
    reason = error.what();
  }
  throw PcdError(file.string() + ": the points cannot be decoded: " + reason +
                 "; the file is damaged: copy or record it again");
}

bool same_layout(const pcl::PCLPointCloud2& cloud, const PcdHeader& header) {
  if (cloud.width != header.width || cloud.height != header.height ||
      cloud.fields.size() != header.fields.size() ||
      cloud.data.size() != header.points() * cloud.point_step) {
    return false;
  }
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    if (cloud.fields[i].name != header.fields[i].name ||
        cloud.fields[i].offset + header.fields[i].bytes() > cloud.point_step) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<std::uint8_t> read_points_with_pcl(const std::filesystem::path& file,
                                               const PcdHeader& header) {
  const pcl::PCLPointCloud2 cloud = read_with_pcl(file);
  if (!same_layout(cloud, header)) {
    throw PcdError(file.string() +
                   ": PCL reads another layout than the header describes; "
                   "write the file anew");
  }
  std::vector<std::uint8_t> data;
  data.reserve(cloud.data.size());
  for (std::size_t i = 0; i < header.points(); ++i) {
    const std::uint8_t* point = &cloud.data[i * cloud.point_step];
    for (std::size_t f = 0; f < header.fields.size(); ++f) {
      if (header.fields[f].name == "_") continue;
      const std::uint8_t* value = point + cloud.fields[f].offset;
      data.insert(data.end(), value, value + header.fields[f].bytes());
    }
  }
  return data;
}

}  // namespace cleave::client
