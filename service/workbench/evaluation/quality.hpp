// SPDX-License-Identifier: BSD-3-Clause
// How well a segmentation agrees with the truth (section 5.2 of the thesis).
#pragma once

#include <cstdint>
#include <span>

#include "workbench/evaluation/labelled_cloud.hpp"

namespace cleave::evaluation {

struct Quality {
  double weighted_covering = 0;    // equation 5.2
  double unweighted_covering = 0;  // equation 5.3
  std::uint32_t true_segments = 0;
  std::uint32_t found_segments = 0;  // with a point that counts
  std::uint32_t under = 0;           // true segments without a match, section 5.2.2
  std::uint32_t over = 0;            // found segments without a match
  // Segments whose intersection over union with one of the other side is above 0.75, as a share of
  // the found ones and of the true ones, and the harmonic mean of the two.
  double object_precision = 0;
  double object_recall = 0;
  double object_f = 0;
};

// One true and one found label a point; points whose true label is 0 do not count. A found label 0
// is no segment: see label_unlabelled. All 0 where no point counts.
[[nodiscard]] Quality judge(std::span<const std::uint32_t> truth,
                            std::span<const std::uint16_t> found);

// The same for a labelled cloud, once label_unlabelled has been applied to `found`.
[[nodiscard]] Quality judge(const LabelledCloud& cloud, std::span<std::uint16_t> found);

}  // namespace cleave::evaluation
