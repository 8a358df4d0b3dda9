// SPDX-License-Identifier: BSD-3-Clause
// Figure 5.10: along which eigenvectors the cuts go that agree with the truth.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "segmentation/options.hpp"

namespace cleave::workbench {

// Scenes with more true segments are complex, the others simple.
inline constexpr std::size_t most_simple_segments = 10;

class EigenvectorsUsed {
 public:
  explicit EigenvectorsUsed(const segmentation::Options& options) : options_(options) {}

  // Cuts the scene with the truth at hand (segmentation::segment_guided). A file that cannot be
  // read or has no labels is one of the problems.
  void add(const std::filesystem::path& file);

  [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }
  // A line an eigenvector, and one with the sums.
  [[nodiscard]] std::string table() const;
  // Columns eigenvector, cuts in simple scenes, cuts in complex ones, behind lines of comment.
  [[nodiscard]] std::string data() const;

 private:
  struct Group {
    std::size_t scenes = 0;
    std::size_t cuts = 0;
    std::vector<std::size_t> cuts_along;  // by eigenvector, from 1

    [[nodiscard]] std::size_t along(std::size_t eigenvector) const;
    void add_cut(std::size_t eigenvector);
  };

  [[nodiscard]] std::size_t last_eigenvector() const;

  segmentation::Options options_;
  Group simple_, complex_;
  std::vector<std::string> problems_;
};

}  // namespace cleave::workbench
