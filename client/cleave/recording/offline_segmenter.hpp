// Recorded clouds through the segmentation, several at a time.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "recording/frames/frame.hpp"
#include "segmentation/segmenter.hpp"

namespace cleave::client {

// What the daemon would publish for a cloud, but for what depends on the moment: times of
// publication are those of the cloud, and it cost 0 ms.
struct SegmentedCloud {
  recording::Labels labels;
  recording::SegmentList list;
};

class OfflineSegmenter {
 public:
  // Throws std::invalid_argument when an option is out of its range.
  OfflineSegmenter(const segmentation::Options& options, std::size_t workers);

  // One result a cloud, in their order; the same for any number of workers.
  [[nodiscard]] std::vector<SegmentedCloud> segment(std::span<const recording::Cloud> clouds);
  [[nodiscard]] std::size_t workers() const { return segmenters_.size(); }

 private:
  std::vector<segmentation::Segmenter> segmenters_;  // one a worker
};

}  // namespace cleave::client
