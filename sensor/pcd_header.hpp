// What a PCD file claims to hold, checked against its size before anybody believes it: a header
// that lies must not make a reader allocate gigabytes or run past the end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

namespace cleave::sensor {

// Why a file cannot be used.
struct PcdProblem {
  std::string cause;   // one of a few, to count by: "unreadable", "not PCD", "bad header", "no
                       // points", "too many points", "truncated", "damaged data"
  std::string detail;  // for people
};

struct PcdField {
  std::string name;
  char type;            // F, I or U
  std::uint64_t size;   // bytes: 1, 2, 4 or 8
  std::uint64_t count;  // values a point
};

enum class PcdEncoding { ascii, binary, binary_compressed };

struct PcdHeader {
  std::vector<PcdField> fields;
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  std::uint64_t points = 0;
  PcdEncoding encoding = PcdEncoding::ascii;
};

// Accepts PCD 0.6 and 0.7 with floating-point x, y, z, width * height = points, 1 to 640 x 480
// points, at most 512 MiB decoded, and as many bytes of data as the header needs (of ascii: the
// fewest that can hold its values).
[[nodiscard]] std::variant<PcdHeader, PcdProblem> read_pcd_header(
    const std::filesystem::path& file);

}  // namespace cleave::sensor
