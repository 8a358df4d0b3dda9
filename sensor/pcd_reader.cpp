#include "sensor/pcd_reader.hpp"

#include <pcl/console/print.h>
#include <pcl/io/pcd_io.h>

#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <string_view>

#include "recording/cloud/fit_intrinsics.hpp"

namespace cleave::sensor {
namespace {

// Where one coordinate lies in the bytes of a point.
class Coordinate {
 public:
  Coordinate(const pcl::PCLPointCloud2& cloud, std::string_view name) {
    for (const pcl::PCLPointField& field : cloud.fields) {
      if (field.name != name) continue;
      offset_ = field.offset;
      is_double_ = field.datatype == pcl::PCLPointField::FLOAT64;
      return;
    }
  }
  [[nodiscard]] float read(const std::uint8_t* point) const {
    return is_double_ ? static_cast<float>(read_as<double>(point)) : read_as<float>(point);
  }

 private:
  template <class T>
  [[nodiscard]] T read_as(const std::uint8_t* point) const {
    T value;
    std::memcpy(&value, point + offset_, sizeof value);
    return value;
  }
  std::size_t offset_ = 0;
  bool is_double_ = false;
};

std::vector<float> points_of(const pcl::PCLPointCloud2& cloud) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const Coordinate x(cloud, "x"), y(cloud, "y"), z(cloud, "z");
  const std::size_t count = std::size_t{cloud.width} * cloud.height;
  std::vector<float> xyz(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* const point = cloud.data.data() + i * cloud.point_step;
    float* const p = xyz.data() + 3 * i;
    p[0] = x.read(point);
    p[1] = y.read(point);
    p[2] = z.read(point);
    const bool finite = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
    if (!finite || (p[0] == 0 && p[1] == 0 && p[2] == 0)) {
      p[0] = p[1] = p[2] = nan;
    }
  }
  return xyz;
}

// False where PCL gives up; why, it would only print.
bool load(const std::filesystem::path& file, pcl::PCLPointCloud2& cloud) {
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  try {
    return pcl::PCDReader().read(file.string(), cloud) == 0;
  } catch (const std::exception&) {
    return false;
  }
}

}  // namespace

std::variant<PointCloud, PcdProblem> read_pcd(const std::filesystem::path& file) {
  const std::variant<PcdHeader, PcdProblem> checked = read_pcd_header(file);
  if (const auto* const problem = std::get_if<PcdProblem>(&checked)) return *problem;
  const PcdHeader& header = std::get<PcdHeader>(checked);

  pcl::PCLPointCloud2 cloud;
  if (!load(file, cloud)) return PcdProblem{"damaged data", "the points cannot be decoded"};
  if (cloud.width != header.width || cloud.height != header.height ||
      cloud.data.size() < header.points * cloud.point_step) {
    return PcdProblem{"damaged data", "fewer points were decoded than the header tells"};
  }
  PointCloud result{cloud.width, cloud.height, points_of(cloud), {}};
  const recording::Intrinsics fit =
      recording::fit_intrinsics(result.xyz.data(), result.width, result.height);
  result.intrinsics = {fit.fx, fit.fy, fit.cx, fit.cy};
  return result;
}

}  // namespace cleave::sensor
