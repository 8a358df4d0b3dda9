// SPDX-License-Identifier: BSD-3-Clause
// What is told of a run, and of many: one list for tables, JSON and CSV.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "console/percentiles.hpp"
#include "workbench/trials/groups.hpp"
#include "workbench/trials/trial.hpp"

namespace cleave::workbench {

struct Measure {
  std::string_view key;  // of JSON and CSV
  double (*of)(const Run&);
};

// Coverings, under- and over-segmentation, boundaries, objects, in this order.
[[nodiscard]] std::span<const Measure> measures();
// Throws std::out_of_range for a key that none has.
[[nodiscard]] const Measure& measure(std::string_view key);

// The runs of one method on the scenes of a group that could be tried, in their order.
class Sample {
 public:
  Sample(const std::vector<Scene>& scenes, std::size_t method, const Group& group);

  [[nodiscard]] std::size_t scenes() const { return scenes_; }
  [[nodiscard]] std::size_t runs() const { return runs_.size(); }
  [[nodiscard]] Spread spread_of(const Measure& measure) const;
  [[nodiscard]] double mean_of(std::string_view key) const { return spread_of(measure(key)).mean; }
  [[nodiscard]] Percentiles milliseconds() const;

 private:
  std::size_t scenes_ = 0;
  std::vector<const Run*> runs_;
};

// All scenes.
[[nodiscard]] inline Sample sample_of(const std::vector<Scene>& scenes, std::size_t method) {
  return {scenes, method, Group{0, scenes.size() - 1}};
}

}  // namespace cleave::workbench
