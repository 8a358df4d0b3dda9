// SPDX-License-Identifier: BSD-3-Clause
// Which CameraInfo an image belongs to.
#pragma once

#include <cstdint>
#include <deque>

#include "recording/mcap/reader.hpp"
#include "recording/ros/messages.hpp"

namespace cleave::recording::ros {

// When something was true, and when it was recorded.
struct Moment {
  std::int64_t stamp_ns;
  std::int64_t log_ns;
};

// A message without a stamp has that of its recording.
[[nodiscard]] Moment moment_of(const Header& header, const MessageTimes& times);

struct RecordedCamera {
  Moment when;
  CameraInfo info;
};

// Throws DataError.
[[nodiscard]] RecordedCamera recorded_camera(const Message& message, Wire wire);

// Remembers the latest ones: drivers send one with every image, latched topics one for all.
class CameraBook {
 public:
  // `first`: of the file, for images that come before any.
  explicit CameraBook(RecordedCamera first) : first_(std::move(first)) {}

  void add(RecordedCamera camera);
  // The latest one with the image's stamp or an earlier one; where all are later, the earliest. Of
  // several with one stamp it is the one that was recorded last before the image, else the first
  // one after: a camera's info may be recorded on either side of its image.
  [[nodiscard]] const CameraInfo& of_image(const Moment& image) const;
  void clear() { latest_.clear(); }

 private:
  RecordedCamera first_;
  std::deque<RecordedCamera> latest_;
};

}  // namespace cleave::recording::ros
