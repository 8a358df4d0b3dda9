// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/trials/csv.hpp"

#include <spdlog/fmt/fmt.h>

#include "workbench/trials/measures.hpp"

namespace cleave::workbench {
namespace {

std::string line_of(const TrialResult& result, std::size_t index, std::size_t method,
                    const Run& run) {
  const Scene& scene = result.scenes[index];
  std::string line = fmt::format("{},{},{},{},{},{},{}", index, csv_field(scene.file.string()),
                                 csv_field(result.methods[method]), run.grid_offset, scene.points,
                                 scene.true_segments, run.quality.found_segments);
  for (const Measure& measure : measures()) line += fmt::format(",{}", measure.of(run));
  return line + fmt::format(",{:.3f}\n", run.milliseconds);
}

}  // namespace

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + '"';
}

std::string csv_of(const TrialResult& result) {
  std::string text = "index,file,algorithm,grid_offset,points,true_segments,found_segments";
  for (const Measure& measure : measures()) text += fmt::format(",{}", measure.key);
  text += ",milliseconds\n";
  for (std::size_t i = 0; i < result.scenes.size(); ++i) {
    for (std::size_t m = 0; m < result.scenes[i].runs.size(); ++m) {
      for (const Run& run : result.scenes[i].runs[m]) text += line_of(result, i, m, run);
    }
  }
  return text;
}

}  // namespace cleave::workbench
