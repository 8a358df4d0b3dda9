// SPDX-License-Identifier: BSD-3-Clause
// The segmentation's options by name, from text.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "segmentation/options.hpp"

namespace cleave::workbench {

class OptionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// "voxel.size_m=0.005". Throws OptionError: for an unknown key with the known ones, for a value
// that does not fit with what was expected.
void set_option(segmentation::Options& options, std::string_view assignment);

// Of `count` shifts of the grid, spread evenly over one voxel, the one with this index.
[[nodiscard]] inline float even_grid_offset(std::uint32_t index, std::uint32_t count) {
  return static_cast<float>(index) / static_cast<float>(count);
}

// A line an option: name, default, range, meaning.
[[nodiscard]] std::string list_options();

}  // namespace cleave::workbench
