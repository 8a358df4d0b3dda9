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
  void pad(const SegmentImage& image, std::uint32_t radius);
  // Most windows hold one segment only; this marks those that may not.
  void mark_mixed_windows(std::uint32_t radius);
  void spread_marks(std::size_t step, std::uint32_t radius);
  // A segment with half of the window's pixels or more needs no rival counted.
  void filter_block(std::size_t begin, std::size_t end, std::uint32_t radius, float depth_gate_m,
                    std::uint32_t* result);
  [[nodiscard]] std::uint32_t mode_around(std::size_t middle, std::uint32_t radius,
                                          float depth_gate_m);

  struct Count {
    std::uint32_t segment = 0;
    std::uint32_t pixels = 0;
  };
  // The image inside a border without segments, so that no window ends early.
  std::size_t stride_ = 0;
  std::vector<std::uint32_t> segment_;
  std::vector<float> depth_m_;  // infinite where there is no segment: no gate lets it in
  std::vector<std::uint8_t> mixed_, spread_;
  std::vector<std::uint32_t> filled_;
  std::vector<Count> counts_;
};

}  // namespace cleave::segmentation
