// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/ignored_options.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <vector>

#include "segmentation/option_visitor.hpp"
#include "segmentation/path/path_options.hpp"

namespace cleave::segmentation {
namespace {

using Algorithms = unsigned;  // a set: a bit each, by its number

constexpr Algorithms only(Algorithm algorithm) {
  return 1U << static_cast<unsigned>(algorithm);
}
constexpr Algorithms on_voxels = only(Algorithm::svc);
constexpr Algorithms uncut = only(Algorithm::convex_components);
constexpr Algorithms on_cut_supervoxels = only(Algorithm::ssc) | only(Algorithm::constrained_ssc);
constexpr Algorithms on_supervoxels = on_cut_supervoxels | uncut;

struct Readers {
  std::string_view options;  // the beginning of their names
  Algorithms algorithms;
};

// What is not listed, all algorithms read; of two that fit, the first counts.
constexpr std::array readers = {
    Readers{"representation", on_supervoxels},  // svc cuts voxels
    Readers{"supervoxel.", on_supervoxels},
    // Convex components are cut nowhere, and their small segments join by weight alone.
    Readers{"graph.cannot_link_rad", on_cut_supervoxels},
    Readers{"graph.soft_cannot_link_rad", on_cut_supervoxels},
    Readers{"graph.", on_supervoxels},
    Readers{"partition.eigenvectors", only(Algorithm::ssc) | on_voxels},
    Readers{"partition.utility_threshold", on_cut_supervoxels},  // svc has its own
    Readers{"partition.decomposition", on_cut_supervoxels | on_voxels},
    Readers{"partition.laplacian", on_cut_supervoxels | on_voxels},
    Readers{"partition.cannot_link_weight", only(Algorithm::constrained_ssc)},
    Readers{"partition.coarsening_rounds", on_cut_supervoxels},
    Readers{"svc.", on_voxels},
    Readers{"convex_components.", uncut},
    Readers{"clean_up.join_across_borders", on_cut_supervoxels},
    Readers{"clean_up.weak_border_points", on_cut_supervoxels},
};

constexpr std::string_view of_voxels_alone = "voxel.neighbourhood";

bool is_read(std::string_view option, Algorithm algorithm) {
  const auto* const found = std::ranges::find_if(
      readers, [&](const Readers& r) { return option.starts_with(r.options); });
  return found == readers.end() || (found->algorithms & only(algorithm)) != 0;
}

// The value of every option as text, in the order of visit_options.
struct Texts {
  std::vector<std::string_view> names;
  std::vector<std::string> values;
  std::vector<std::string_view> algorithms;

  explicit Texts(Options options) { visit_options(options, *this); }

  void number(std::string_view name, float value, double, double, std::string_view) {
    add(name, as_text(value));
  }
  void integer(std::string_view name, std::uint32_t value, std::uint32_t, std::uint32_t,
               std::string_view) {
    add(name, as_text(value));
  }
  void boolean(std::string_view name, bool value, std::string_view) {
    add(name, value ? "true" : "false");
  }
  template <typename Choices>
  void choice(std::string_view name, std::size_t index, const Choices& choices, std::string_view) {
    add(name, choices[index]);
    if (name == "algorithm") algorithms.assign(choices.begin(), choices.end());
  }

 private:
  // The shortest that tells any two values apart.
  template <typename Number>
  static std::string as_text(Number value) {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
  }
  void add(std::string_view name, std::string_view value) {
    names.push_back(name);
    values.emplace_back(value);
  }
};

std::string names_of_readers(std::string_view option, const Texts& texts) {
  std::string readers_of_it;
  for (std::size_t a = 0; a < texts.algorithms.size(); ++a) {
    if (!is_read(option, static_cast<Algorithm>(a))) continue;
    readers_of_it += readers_of_it.empty() ? "" : " or ";
    readers_of_it += texts.algorithms[a];
  }
  return readers_of_it;
}

// Whether the i-th option counts for nothing and is as no preset has it.
bool is_set_in_vain(std::size_t i, const Texts& given, const Options& options,
                    const std::vector<Texts>& presets) {
  const std::string_view name = given.names[i];
  const bool read = is_read(name, options.algorithm) &&
                    !(name == of_voxels_alone && images_become_cells(options));
  return !read && std::ranges::none_of(
                      presets, [&](const Texts& p) { return p.values[i] == given.values[i]; });
}

}  // namespace

std::optional<IgnoredOption> find_ignored_option(const Options& options,
                                                 std::span<const Options> presets) {
  const Texts given(options);
  const std::vector<Texts> expected(presets.begin(), presets.end());
  std::size_t i = 0;
  while (i < given.names.size() && !is_set_in_vain(i, given, options, expected)) ++i;
  if (i == given.names.size()) return std::nullopt;

  const std::string name(given.names[i]);
  if (is_read(name, options.algorithm)) {
    return IgnoredOption{name, given.values[i], "images become cells, which do not read it",
                         "set representation to voxels"};
  }
  const std::string algorithm(given.algorithms[static_cast<std::size_t>(options.algorithm)]);
  return IgnoredOption{name, given.values[i], "algorithm " + algorithm + " does not read it",
                       "set algorithm to " + names_of_readers(name, given)};
}

}  // namespace cleave::segmentation
