// What a PCD file says about itself, believed only as far as the file's size bears it out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace cleave::client {

// "scene.pcd: the header promises 307200 points of 16 bytes, ...: what to do"
class PcdError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct PcdField {
  std::string name;     // "_" is padding
  char type;            // I signed, U unsigned, F floating point
  std::uint32_t size;   // bytes of one element: 1, 2, 4 or 8
  std::uint32_t count;  // elements a point
  [[nodiscard]] std::size_t bytes() const { return std::size_t{size} * count; }
};

enum class PcdEncoding { ascii, binary, binary_compressed };

struct PcdHeader {
  std::vector<PcdField> fields;
  std::uint32_t width = 0;
  std::uint32_t height = 0;                 // 1 = unorganised
  std::string viewpoint = "0 0 0 1 0 0 0";  // as written: translation and quaternion w x y z
  PcdEncoding encoding = PcdEncoding::ascii;
  std::size_t data_offset = 0;  // where the points begin in the file

  [[nodiscard]] std::size_t points() const { return std::size_t{width} * height; }
  [[nodiscard]] std::size_t point_bytes() const;  // padding included
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const;
};

// Reads and checks the header: known sizes and types, as many of each as there are fields, no name
// twice, width * height = points, at least one point. Throws PcdError.
[[nodiscard]] PcdHeader read_pcd_header(const std::filesystem::path& file);

// Checks that the file holds the points that the header promises, before anyone allocates memory
// for them. Throws PcdError.
void check_pcd_data(const std::filesystem::path& file, const PcdHeader& header);

}  // namespace cleave::client
