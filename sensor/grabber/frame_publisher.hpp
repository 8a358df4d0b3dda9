// SPDX-License-Identifier: BSD-3-Clause
// Frames of a source become clouds on the stream.
#pragma once

#include <string>

#include "idl/frame_key.hpp"
#include "libcleave/cloud_writer.hpp"
#include "libcleave/lossless_flow.hpp"
#include "libcleave/stream.hpp"
#include "libcleave/types.hpp"
#include "sensor/sources/source.hpp"

namespace cleave::sensor {

enum class Publication { done, no_free_chunk, no_large_chunks, refused };

// The frames that points are in.
struct Place {
  std::string coordinate_frame;
  std::string parent_frame;
  cleave_v1_Pose3 pose{};
};

class FramePublisher {
 public:
  // Names must fit the contract. `depth`: clouds kept for readers that the network serves.
  FramePublisher(Stream& stream, const std::string& sensor, const Place& place, WriterDepth depth);

  // The source writes its points straight into the memory that is published. With `copy` they are
  // also put there.
  [[nodiscard]] Publication publish(const Frame& frame, FrameKey key, Source& source,
                                    KeptFrame* copy);

  // For frames that must be published again.
  [[nodiscard]] CloudWriter& writer() { return writer_; }
  [[nodiscard]] unsigned readers() const { return writer_.matched_readers(); }
  [[nodiscard]] bool zero_copy() const { return writer_.zero_copy(); }

 private:
  CloudWriter writer_;
  FrameHeader header_;  // with the names filled in
};

}  // namespace cleave::sensor
