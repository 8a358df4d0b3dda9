// SPDX-License-Identifier: BSD-3-Clause
// The same scene in fewer and in more points.
#pragma once

#include "workbench/evaluation/labelled_cloud.hpp"

namespace cleave::workbench {

// Every second column and row of an image, every fourth point of an unorganised cloud.
[[nodiscard]] evaluation::LabelledCloud quarter(const evaluation::LabelledCloud& cloud);

// Twice the columns and rows: between two pixels of one surface (depths that differ by less than
// 3 %) their mean, else the nearer one's copy. An unorganised cloud has no "between": each point
// stands four times, moved by under a millimetre. The labels are those of the pixel or point that
// the new one comes from.
[[nodiscard]] evaluation::LabelledCloud quadruple(const evaluation::LabelledCloud& cloud);

}  // namespace cleave::workbench
