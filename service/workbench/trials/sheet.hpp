// SPDX-License-Identifier: BSD-3-Clause
// One picture of a scene and of what methods made of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "console/picture/picture.hpp"
#include "workbench/evaluation/labelled_cloud.hpp"

namespace cleave::workbench {

// The first row is the input and the truth, then a row a method: its result, in the colours of the
// true segments that its own stand for, and the difference as in Figure 5.7: green where the label
// is right, red where it is wrong, grey where nothing is known.
class Sheet {
 public:
  // The cloud must outlive this.
  explicit Sheet(const evaluation::LabelledCloud& cloud);

  // One found label a point.
  void add_result(std::span<const std::uint16_t> found);
  // As PNG. Throws std::runtime_error.
  void write(const std::filesystem::path& file) const;

  [[nodiscard]] const Picture& picture() const { return picture_; }

 private:
  const evaluation::LabelledCloud& cloud_;
  Picture picture_;
};

// "007-learn7.png": in the order of the scenes, and different for files of the same name.
[[nodiscard]] std::string sheet_name(std::size_t index, const std::filesystem::path& scene);

}  // namespace cleave::workbench
