#include "sensor/renderer/labelled_pcd.hpp"

#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>

#include <cstring>
#include <stdexcept>
#include <string>

namespace cleave::render {
namespace {

constexpr std::size_t value_bytes = 4;
constexpr std::size_t point_bytes = 4 * value_bytes;

pcl::PCLPointCloud2 to_pcl(const LabelledDepth& image, const Intrinsics& intrinsics) {
  const std::vector<float> xyz = to_points(image, intrinsics);
  pcl::PCLPointCloud2 cloud;
  cloud.width = image.width;
  cloud.height = image.height;
  cloud.point_step = point_bytes;
  cloud.row_step = image.width * cloud.point_step;
  cloud.is_dense = 0;
  std::uint32_t offset = 0;
  for (const char* name : {"x", "y", "z", "label"}) {
    pcl::PCLPointField field;
    field.name = name;
    field.offset = offset;
    field.datatype =
        offset < 3 * value_bytes ? pcl::PCLPointField::FLOAT32 : pcl::PCLPointField::UINT32;
    field.count = 1;
    cloud.fields.push_back(field);
    offset += value_bytes;
  }
  cloud.data.resize(image.label.size() * point_bytes);
  for (std::size_t i = 0; i < image.label.size(); ++i) {
    const std::uint32_t label = image.label[i];
    std::memcpy(&cloud.data[i * point_bytes], &xyz[3 * i], 3 * value_bytes);
    std::memcpy(&cloud.data[i * point_bytes + 3 * value_bytes], &label, value_bytes);
  }
  return cloud;
}

}  // namespace

void write_labelled_pcd(const std::filesystem::path& file, const LabelledDepth& image,
                        const Intrinsics& intrinsics) {
  const std::filesystem::path unfinished = file.string() + ".part";
  const auto refuse = [&](const std::string& why) {
    std::error_code ignored;
    std::filesystem::remove(unfinished, ignored);
    throw std::runtime_error("cannot write " + file.string() + ": " + why +
                             "; choose a folder that can be written to and has room");
  };
  try {
    if (pcl::PCDWriter().writeBinaryCompressed(unfinished.string(), to_pcl(image, intrinsics)) <
        0) {
      refuse("PCL's writer gives up");
    }
    std::filesystem::rename(unfinished, file);
  } catch (const pcl::IOException& error) {
    refuse(error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    refuse(error.what());
  }
}

}  // namespace cleave::render
