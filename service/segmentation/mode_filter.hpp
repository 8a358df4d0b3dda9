// Smooths borders in the image: every pixel takes the commonest segment around it.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace cleave::segmentation {

// Row-major; a pixel without a measurement has `no_segment` and any depth.
struct SegmentImage {
  static constexpr std::uint32_t no_segment = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint32_t> segment;
  std::vector<float> depth_m;
};

class ModeFilter {
 public:
  // Window of (2 radius + 1)^2 pixels; only those count that are within `depth_gate_m` of the
  // middle's depth. Among equally common segments the pixel's own wins, then the lowest. Pixels
  // without a segment stay so.
  void filter(SegmentImage& image, std::uint32_t radius, float depth_gate_m);

 private:
  // Most windows hold one segment only; this marks those that may not.
  void mark_mixed_windows(const SegmentImage& image, std::uint32_t radius);
  void spread_marks(const SegmentImage& image, std::uint32_t radius);
  [[nodiscard]] std::uint32_t mode_around(const SegmentImage& image, std::uint32_t column,
                                          std::uint32_t row, std::uint32_t radius,
                                          float depth_gate_m);

  struct Count {
    std::uint32_t segment = 0;
    std::uint32_t pixels = 0;
  };
  std::vector<std::uint8_t> mixed_, spread_;
  std::vector<std::uint32_t> filled_, filtered_;
  std::vector<Count> counts_;
};

}  // namespace cleave::segmentation
