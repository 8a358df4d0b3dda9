// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <stdexcept>
#include <string>

#include "segmentation/option_visitor.hpp"
#include "segmentation/segmenter.hpp"

namespace cleave::segmentation {
namespace {

// Sets one number to a value and remembers all names.
struct Setter {
  std::string key;
  double value = 0;
  std::set<std::string, std::less<>> names = {};
  double max = 0;

  void number(std::string_view name, float& option, double, double limit, std::string_view) {
    remember(name);
    if (name != key) return;
    option = static_cast<float>(value);
    max = limit;
  }
  void integer(std::string_view name, std::uint32_t& option, std::uint32_t, std::uint32_t limit,
               std::string_view) {
    remember(name);
    if (name != key) return;
    option = static_cast<std::uint32_t>(value);
    max = limit;
  }
  void boolean(std::string_view name, bool&, std::string_view) { remember(name); }
  template <typename Choices>
  void choice(std::string_view name, std::size_t&, const Choices&, std::string_view) {
    remember(name);
  }

 private:
  void remember(std::string_view name) { EXPECT_TRUE(names.emplace(name).second) << name; }
};

Options with(const std::string& key, double value) {
  Options options;
  visit_options(options, Setter{.key = key, .value = value});
  return options;
}

TEST(Options, AreVisitedByUniqueNames) {
  Options options;
  Setter setter;

  visit_options(options, setter);

  EXPECT_TRUE(setter.names.contains("voxel.size_m"));
}

TEST(Options, OfTheThesisAndOursAreInRange) {
  EXPECT_NO_THROW(Segmenter{});
  EXPECT_NO_THROW(Segmenter{thesis()});
}

TEST(Options, OutOfRangeAreRefusedByName) {
  for (const auto& [key, value] : {std::pair<std::string, double>{"voxel.size_m", 0},
                                   {"voxel.size_m", std::numeric_limits<double>::quiet_NaN()},
                                   {"supervoxel.sweeps", 101},
                                   {"graph.validity_max_rad", -1},
                                   {"partition.eigenvectors", 1e6}}) {
    try {
      const Segmenter segmenter(with(key, value));
      ADD_FAILURE() << key << " = " << value << " was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(key), std::string::npos) << error.what();
    }
  }
}

TEST(Options, ThatTheAlgorithmDoesNotReadAreRefusedWithThoseThatDo) {
  Options options;
  options.algorithm = Algorithm::convex_components;
  options.partition.eigenvectors = 4;
  try {
    const Segmenter segmenter(options);
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(),
                 "segmentation option partition.eigenvectors is 4, but algorithm convex-components "
                 "does not read it: leave it out, or set algorithm to ssc or svc");
  }
}

TEST(Options, AtTheEndOfTheirRangeAreAccepted) {
  EXPECT_NO_THROW(Segmenter(with("voxel.grid_offset", 1)));
  EXPECT_NO_THROW(Segmenter(with("graph.cannot_link_rad", 3.1415)));
}

TEST(Options, RefuseAChoiceThatIsNone) {
  Options options;
  options.voxel.viewpoint = static_cast<Viewpoint>(7);

  EXPECT_THROW(Segmenter{options}, std::invalid_argument);
}

}  // namespace
}  // namespace cleave::segmentation
