// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/studies/eigenvectors_used.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "console/table.hpp"
#include "segmentation/guided.hpp"
#include "workbench/evaluation/labelled_cloud.hpp"

namespace cleave::workbench {

std::size_t EigenvectorsUsed::Group::along(std::size_t eigenvector) const {
  return eigenvector <= cuts_along.size() ? cuts_along[eigenvector - 1] : 0;
}

void EigenvectorsUsed::Group::add_cut(std::size_t eigenvector) {
  ++cuts;
  cuts_along.resize(std::max(cuts_along.size(), eigenvector), 0);
  ++cuts_along[eigenvector - 1];
}

void EigenvectorsUsed::add(const std::filesystem::path& file) {
  evaluation::LabelledCloud cloud;
  try {
    cloud = evaluation::load_labelled_cloud(file);
  } catch (const std::runtime_error& error) {
    problems_.emplace_back(error.what());
    return;
  }
  std::set<std::uint32_t> objects(cloud.label.begin(), cloud.label.end());
  objects.erase(0);
  Group& group = objects.size() > most_simple_segments ? complex_ : simple_;
  ++group.scenes;
  for (const auto& cut : segmentation::segment_guided(cloud.view(), cloud.label, options_).cuts) {
    group.add_cut(cut.eigenvector);
  }
}

std::size_t EigenvectorsUsed::last_eigenvector() const {
  return std::max(simple_.cuts_along.size(), complex_.cuts_along.size());
}

std::string EigenvectorsUsed::table() const {
  Table table({{"eigenvector", Align::right},
               {"cuts, simple scenes", Align::right},
               {"cuts, complex scenes", Align::right}});
  for (std::size_t e = 1; e <= last_eigenvector(); ++e) {
    table.add_row({fmt::format("{}", e), fmt::format("{}", simple_.along(e)),
                   fmt::format("{}", complex_.along(e))});
  }
  table.add_row({"all", fmt::format("{}", simple_.cuts), fmt::format("{}", complex_.cuts)});
  return table.to_string();
}

std::string EigenvectorsUsed::data() const {
  std::string text = fmt::format(
      "# Cuts along eigenvectors (Figure 5.10 of the thesis), in {} scenes of up to {} segments "
      "and "
      "{} of more\n"
      "# eigenvector; cuts in simple scenes; cuts in complex scenes\n",
      simple_.scenes, most_simple_segments, complex_.scenes);
  for (std::size_t e = 1; e <= last_eigenvector(); ++e) {
    text += fmt::format("{} {} {}\n", e, simple_.along(e), complex_.along(e));
  }
  return text;
}

}  // namespace cleave::workbench
