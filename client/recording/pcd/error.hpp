// SPDX-License-Identifier: BSD-3-Clause
// Why a PCD file cannot be used.
#pragma once

#include <filesystem>
#include <string>

#include "recording/error.hpp"

namespace cleave::recording {

enum class PcdCause {
  unreadable,
  not_pcd,
  bad_header,
  no_points,
  too_many_points,
  truncated,
  damaged_data
};

// To count by: "unreadable", "not PCD", "bad header", ...
[[nodiscard]] const char* name_of(PcdCause cause);

// "scene.pcd: line 14: point 2 has 2 numbers, its fields ask for 3; correct the line or the header"
class PcdError : public FileError {
 public:
  PcdError(const std::filesystem::path& file, PcdCause cause, const std::string& why)
      : FileError(file.string() + ": " + why), cause_(cause) {}
  [[nodiscard]] PcdCause cause() const { return cause_; }

 private:
  PcdCause cause_;
};

}  // namespace cleave::recording
