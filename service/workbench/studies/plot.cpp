// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/studies/plot.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "workbench/studies/program.hpp"

namespace cleave::workbench {
namespace {

// Both scales leave a little room, and do not jump from study to study for small differences.
double left_end(const std::vector<StudyPoint>& points) {
  constexpr double cropped_at = 25;
  double most = 1;
  for (const StudyPoint& point : points) most = std::max({most, point.under, point.over});
  return std::min(cropped_at, std::ceil(most * 1.1));
}

double right_begin(const std::vector<StudyPoint>& points) {
  double least = 1;
  for (const StudyPoint& point : points) {
    least = std::min({least, point.weighted, point.unweighted});
  }
  return std::max(0.0, std::floor(least * 10 - 0.5) / 10);
}

// Draws the macro `plots` into both files.
std::string output_of(const std::string& name) {
  return fmt::format(
      R"(set terminal svg size 800,480 background rgb 'white'
set output '{0}.svg'
@plots
set terminal pngcairo size 1200,720 font 'sans,16'
set output '{0}.png'
@plots
)",
      name);
}

}  // namespace

std::string data_of(const Study& study, const std::vector<StudyPoint>& points, std::size_t scenes) {
  std::string text = fmt::format(
      "# {} (Figure {} of the thesis), means over {} scenes\n"
      "# {}; under-segmentation; over-segmentation; weighted covering; unweighted covering\n",
      study.title, study.figure, scenes, study.x_label);
  for (const StudyPoint& p : points) {
    text += fmt::format("{} {:.4f} {:.4f} {:.6f} {:.6f}\n", p.x, p.under, p.over, p.weighted,
                        p.unweighted);
  }
  return text;
}

std::string script_of(const Study& study, const std::vector<StudyPoint>& points) {
  return fmt::format(
             R"(set title '{title}'
set xlabel '{x_label}'
set ylabel 'segments'
set y2label 'covering'
set xrange [{x_first}:{x_last}]
set yrange [0:{left_end}]
set y2range [{right_begin}:1]
set xtics nomirror
set ytics nomirror
set y2tics
set grid xtics y2tics lc rgb '#dddddd'
set key bottom center outside horizontal maxrows 1
set bmargin 6
set style fill transparent solid 0.7 noborder
plots = "plot '{name}.dat' using 1:3 with filledcurves y1=0 lc rgb '#9ecae1' title 'over-segmentation', \
  '' using 1:2 with filledcurves y1=0 lc rgb '#2171b5' title 'under-segmentation', \
  '' using 1:4 axes x1y2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#cb181d' title 'weighted covering', \
  '' using 1:5 axes x1y2 with linespoints lw 2 pt 7 ps 0.5 lc rgb '#238b45' title 'unweighted covering'"
)",
             fmt::arg("title", study.title), fmt::arg("x_label", study.x_label),
             fmt::arg("x_first", points.front().x), fmt::arg("x_last", points.back().x),
             fmt::arg("left_end", left_end(points)), fmt::arg("right_begin", right_begin(points)),
             fmt::arg("name", study.name)) +
         output_of(study.name);
}

std::string histogram_script(const std::string& name) {
  return fmt::format(
             R"(set title 'Cuts along eigenvectors'
set xlabel 'eigenvector'
set ylabel 'cuts'
set xtics nomirror
set ytics nomirror
set key bottom center outside horizontal maxrows 1
set bmargin 6
set style data histograms
set style histogram clustered gap 1
set style fill solid 0.9 noborder
plots = "plot '{0}.dat' using 2:xtic(1) lc rgb '#cb181d' title 'simple scenes', \
  '' using 3 lc rgb '#2171b5' title 'complex scenes'"
)",
             name) +
         output_of(name);
}

void draw(const std::filesystem::path& script) {
  const std::string folder = std::filesystem::absolute(script).parent_path().string();
  std::string quoted;  // gnuplot doubles a quote within quotes
  for (const char c : folder) quoted += c == '\'' ? "''" : std::string(1, c);
  switch (run_program({"gnuplot", "-e", "cd '" + quoted + "'", script.filename()})) {
    case ProgramEnd::done:
      return;
    case ProgramEnd::not_found:
      throw std::runtime_error("gnuplot is not there to draw " + script.string() +
                               ", which is written, as is its data: apt-get install gnuplot-nox, "
                               "then run the command again");
    case ProgramEnd::failed:
      throw std::runtime_error("gnuplot could not draw " + script.string() +
                               ", which is written, as is its data; what it printed says why");
  }
}

}  // namespace cleave::workbench
