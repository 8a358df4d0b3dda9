// SPDX-License-Identifier: BSD-3-Clause
// A study's figures, drawn as in the thesis.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workbench/studies/study.hpp"

namespace cleave::workbench {

// Means over all runs at one x.
struct StudyPoint {
  double x = 0;
  double under = 0;
  double over = 0;
  double weighted = 0;
  double unweighted = 0;
};

// Columns x, under, over, weighted, unweighted, behind two lines of comment.
[[nodiscard]] std::string data_of(const Study& study, const std::vector<StudyPoint>& points,
                                  std::size_t scenes);

// gnuplot's commands: areas for under- and over-segmentation on the left axis, which ends at 25 as
// in Figure 5.9, lines for the coverings on the right one; NAME.svg and NAME.png from NAME.dat,
// all in the folder in which gnuplot runs.
[[nodiscard]] std::string script_of(const Study& study, const std::vector<StudyPoint>& points);

// Figure 5.10: two histograms side by side from NAME.dat, whose columns are the eigenvector and the
// cuts along it in simple and in complex scenes.
[[nodiscard]] std::string histogram_script(const std::string& name);

// Runs gnuplot on a script in its folder. Throws std::runtime_error where it is not there, with the
// package to install, or where it fails.
void draw(const std::filesystem::path& script);

}  // namespace cleave::workbench
