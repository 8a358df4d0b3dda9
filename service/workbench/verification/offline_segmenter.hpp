// SPDX-License-Identifier: BSD-3-Clause
// Recorded clouds through the segmentation, several at a time.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "recording/frames/frame.hpp"
#include "recording/units/unit.hpp"
#include "segmentation/segmenter.hpp"

namespace cleave::workbench {

// What the daemon would publish for a cloud, but for what depends on the moment: times of
// publication are those of the cloud, and it cost 0 ms.
struct SegmentedCloud {
  recording::Labels labels;
  recording::SegmentList list;
};

class OfflineSegmenter {
 public:
  // `unit`: of the clouds, which are scaled to metres. Throws std::invalid_argument when an option
  // is out of its range.
  OfflineSegmenter(const segmentation::Options& options, std::size_t workers,
                   std::optional<recording::Unit> unit = {});

  // One result a cloud, in their order; the same for any number of workers. Without a unit, throws
  // recording::WrongUnit, which names the file, where the very first cloud seems to be in
  // millimetres; a later one is rejected, as by the daemon. Scales `clouds`.
  [[nodiscard]] std::vector<SegmentedCloud> segment(std::span<recording::Cloud> clouds,
                                                    const std::string& file);
  [[nodiscard]] std::size_t workers() const { return segmenters_.size(); }

 private:
  std::vector<segmentation::Segmenter> segmenters_;  // one a worker
  std::optional<recording::Unit> unit_;
  bool has_cloud_ = false;
};

}  // namespace cleave::workbench
