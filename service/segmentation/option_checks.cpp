// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/option_checks.hpp"

#include <array>
#include <span>
#include <sstream>
#include <stdexcept>

#include "segmentation/ignored_options.hpp"
#include "segmentation/option_visitor.hpp"

namespace cleave::segmentation {
namespace {

struct RangeCheck {
  template <typename Value, typename Bound>
  static void check(std::string_view name, Value value, Bound min, Bound max) {
    // Not a number is neither above nor below: it is refused as well.
    if (value >= static_cast<Value>(min) && value <= static_cast<Value>(max)) return;
    std::ostringstream message;
    message << "segmentation option " << name << " is " << value << "; it must lie between " << min
            << " and " << max;
    throw std::invalid_argument(message.str());
  }

  static void number(std::string_view name, float value, double min, double max, std::string_view) {
    check(name, value, min, max);
  }
  static void integer(std::string_view name, std::uint32_t value, std::uint32_t min,
                      std::uint32_t max, std::string_view) {
    check(name, value, min, max);
  }
  static void boolean(std::string_view, bool, std::string_view) {}
  template <typename Choices>
  static void choice(std::string_view name, std::size_t index, const Choices& choices,
                     std::string_view) {
    check(name, index, std::size_t{0}, choices.size() - 1);
  }
};

void check_all(const Options& options, std::span<const Options> presets) {
  Options copy = options;  // visit_options hands out references
  visit_options(copy, RangeCheck{});
  if (const auto ignored = find_ignored_option(options, presets)) {
    throw std::invalid_argument("segmentation option " + ignored->name + " is " + ignored->value +
                                ", but " + ignored->why + ": leave it out, or " + ignored->remedy);
  }
}

}  // namespace

void check_options(const Options& options, const Options& preset) {
  check_all(options, {&preset, 1});
}

void check_options(const Options& options) {
  check_all(options, std::array{Options{}, thesis()});
}

}  // namespace cleave::segmentation
