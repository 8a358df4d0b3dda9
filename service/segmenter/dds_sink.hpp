// SPDX-License-Identifier: BSD-3-Clause
// Results on their DDS topics.
#pragma once

#include <memory>
#include <string_view>

#include "libcleave/cloud_writer.hpp"
#include "libcleave/stream.hpp"
#include "libcleave/types.hpp"
#include "libcleave/writer.hpp"
#include "segmenter/pipeline/result_sink.hpp"

namespace cleave::service {

class DdsSink : public ResultSink {
 public:
  // Throws std::runtime_error.
  DdsSink(Stream& stream, std::string_view sensor)
      : labels_(stream, sensor), segments_(stream, sensor) {}

  [[nodiscard]] std::unique_ptr<LabelMemory> loan_labels(std::uint64_t points) override;
  [[nodiscard]] std::string no_memory() const override;
  [[nodiscard]] bool publish(const SegmentList& segments) override {
    return segments_.publish(segments);
  }

 private:
  LabelWriter labels_;
  Writer<SegmentList> segments_;
};

}  // namespace cleave::service
