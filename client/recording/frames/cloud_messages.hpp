// SPDX-License-Identifier: BSD-3-Clause
// cleave::recording::Cloud: what a recording says of a cloud beyond Image and CameraInfo.
#pragma once

#include <cstdint>
#include <vector>

#include "recording/cdr/lacking_fields.hpp"
#include "recording/cloud/projection.hpp"
#include "recording/frames/frame.hpp"
#include "recording/mcap/bytes.hpp"

namespace cleave::recording {

struct CloudMessage {
  FrameHeader header;
  Projection projection = Projection::none;
  std::vector<std::uint8_t> correction;
};

[[nodiscard]] Bytes cloud_message(const CloudMessage& cloud);
// Throws DataError.
[[nodiscard]] CloudMessage read_cloud_message(ByteView message, const LackingFields& lacking = {});

}  // namespace cleave::recording
