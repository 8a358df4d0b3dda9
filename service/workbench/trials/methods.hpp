// SPDX-License-Identifier: BSD-3-Clause
// Ways to segment a cloud, ours and others, in one form.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "segmentation/options.hpp"
#include "workbench/peers/peer.hpp"

namespace cleave::workbench {

struct Method {
  std::string name;
  // A runner of its own for each thread.
  std::function<std::unique_ptr<peers::Peer>(float grid_offset)> make_runner;
  bool has_grid_offset = true;  // PCL's grid lies where the cloud puts it: one run a cloud
};

// `options` began as `preset`. Throws OptionError for one out of its range, or set in vain.
[[nodiscard]] Method our_method(std::string name, const segmentation::Options& options,
                                const segmentation::Options& preset);

// An algorithm of ours with our defaults ("ssc", "svc", ..), "thesis" for the thesis's plain SSC,
// "thesis-" and an algorithm for that with the thesis's values, or one of PCL ("lccp",
// "lccp-tuned", "cpc"). `settings` ("KEY=VALUE") go on top of ours. Throws OptionError for any
// other name or setting, with what there is.
[[nodiscard]] Method method_named(const std::string& name,
                                  const std::vector<std::string>& settings);

// All names that method_named takes, a comma between two.
[[nodiscard]] std::string method_names();

}  // namespace cleave::workbench
