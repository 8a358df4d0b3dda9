// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/trials/methods.hpp"

#include <algorithm>
#include <stdexcept>

#include "segmentation/option_checks.hpp"
#include "segmentation/option_visitor.hpp"
#include "segmentation/segmenter.hpp"
#include "workbench/cloud/option_setter.hpp"
#include "workbench/peers/load_peers.hpp"

namespace cleave::workbench {
namespace {

using segmentation::Options;

class OurRunner : public peers::Peer {
 public:
  explicit OurRunner(const Options& options) : segmenter_(options) {}

  void prepare(const segmentation::CloudView& cloud) override { cloud_ = cloud; }

  void segment(std::span<std::uint16_t> labels) override {
    // On a cloud that cannot be segmented all labels are 0, which is what it is judged by.
    (void)segmenter_.segment(cloud_, labels, result_);
  }

 private:
  segmentation::Segmenter segmenter_;
  segmentation::CloudView cloud_;
  segmentation::Segmentation result_;
};

// The values of the option `algorithm`.
class AlgorithmNames {
 public:
  void number(std::string_view, float&, double, double, std::string_view) {}
  void integer(std::string_view, std::uint32_t&, std::uint32_t, std::uint32_t, std::string_view) {}
  void boolean(std::string_view, bool&, std::string_view) {}
  template <class Choices>
  void choice(std::string_view name, std::size_t&, const Choices& choices, std::string_view) {
    if (name == "algorithm") names_.assign(choices.begin(), choices.end());
  }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  std::vector<std::string> names_;
};

std::vector<std::string> algorithms() {
  Options options;
  AlgorithmNames visitor;
  segmentation::visit_options(options, visitor);
  return visitor.names();
}

bool is_algorithm(const std::string& name) {
  const auto names = algorithms();
  return std::find(names.begin(), names.end(), name) != names.end();
}

Method ours(const std::string& name, const std::string& algorithm, const Options& preset,
            const std::vector<std::string>& settings) {
  Options options = preset;
  set_option(options, "algorithm=" + algorithm);
  for (const std::string& setting : settings) set_option(options, setting);
  return our_method(name, options, preset);
}

}  // namespace

Method our_method(std::string name, const Options& options, const Options& preset) {
  try {
    segmentation::check_options(options, preset);
  } catch (const std::invalid_argument& error) {
    throw OptionError(error.what());
  }
  return {.name = std::move(name), .make_runner = [options](float grid_offset) {
            Options shifted = options;
            if (grid_offset > 0) shifted.voxel.grid_offset = grid_offset;
            return std::make_unique<OurRunner>(shifted);
          }};
}

Method method_named(const std::string& name, const std::vector<std::string>& settings) {
  const std::string thesis_prefix = "thesis-";
  if (is_algorithm(name)) return ours(name, name, {}, settings);
  if (name == "thesis") return ours(name, "ssc", segmentation::thesis(), settings);
  const std::string behind_prefix = name.substr(std::min(name.size(), thesis_prefix.size()));
  if (name.starts_with(thesis_prefix) && behind_prefix != "ssc" && is_algorithm(behind_prefix)) {
    return ours(name, behind_prefix, segmentation::thesis(), settings);
  }
  if (name == "lccp") {
    return {name, [](float) { return peers::make_pcl_lccp(); }, false};
  }
  if (name == "lccp-tuned") {
    return {name, [](float) { return peers::make_pcl_lccp(peers::tuned_lccp()); }, false};
  }
  if (name == "cpc") {
    return {name, [](float) { return peers::make_pcl_cpc(); }, false};
  }
  throw OptionError("there is no algorithm '" + name + "'; known are " + method_names());
}

std::string method_names() {
  std::string ours;
  std::string with_values_of_thesis;
  for (const std::string& name : algorithms()) {
    ours += name + ", ";
    if (name != "ssc") with_values_of_thesis += "thesis-" + name + ", ";
  }
  return ours + "thesis, " + with_values_of_thesis + "lccp, lccp-tuned, cpc";
}

}  // namespace cleave::workbench
