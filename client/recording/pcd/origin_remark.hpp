// SPDX-License-Identifier: BSD-3-Clause
// What a user must know of clouds that are not where their files say.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "recording/pcd/stream_cloud.hpp"

namespace cleave::recording {

// Of all the files that are read in a run.
class OriginRemark {
 public:
  // For the first cloud that is relative to an origin; empty for all others.
  [[nodiscard]] std::optional<std::string> of(const std::filesystem::path& file,
                                              const StreamCloud& cloud);

 private:
  bool made_ = false;
};

}  // namespace cleave::recording
