// SPDX-License-Identifier: BSD-3-Clause
// A recording and, perhaps, which of its topics is meant: bag.mcap?topic=/camera/depth/points
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace cleave::recording {

struct FileTopic {
  std::filesystem::path file;
  std::string topic = {};  // empty: the only one that can be segmented
};

// `?topic=` where it stands last parts the two; every other `?` is of the file's name. A file whose
// name has `?topic=` in it is named with another one behind it, which may be empty.
[[nodiscard]] FileTopic split_topic(std::string_view text);

}  // namespace cleave::recording
