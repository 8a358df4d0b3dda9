// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/cloud/option_setter.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <optional>

#include "console/table.hpp"
#include "segmentation/option_visitor.hpp"
#include "workbench/cloud/parse_number.hpp"

namespace cleave::workbench {
namespace {

template <class Choices>
std::string joined(const Choices& choices) {
  std::string text;
  for (const std::string_view choice : choices) {
    text += text.empty() ? "" : ", ";
    text += choice;
  }
  return text;
}

// Sets the one option that has the name; remembers all names for those who misspell it.
class Setter {
 public:
  Setter(std::string_view key, std::string_view value) : key_(key), value_(value) {}

  void number(std::string_view name, float& value, double min, double max, std::string_view) {
    if (!is_meant(name)) return;
    const auto given = parse_number<double>(value_);
    if (!given || !(*given >= min && *given <= max)) {
      refuse(fmt::format("a number from {} to {}", min, max));
    }
    value = static_cast<float>(*given);
  }
  void integer(std::string_view name, std::uint32_t& value, std::uint32_t min, std::uint32_t max,
               std::string_view) {
    if (!is_meant(name)) return;
    const auto given = parse_number<std::uint32_t>(value_);
    if (!given || *given < min || *given > max) {
      refuse(fmt::format("a whole number from {} to {}", min, max));
    }
    value = *given;
  }
  void boolean(std::string_view name, bool& value, std::string_view) {
    if (!is_meant(name)) return;
    if (value_ != "true" && value_ != "false") refuse("true or false");
    value = value_ == "true";
  }
  template <class Choices>
  void choice(std::string_view name, std::size_t& index, const Choices& choices, std::string_view) {
    if (!is_meant(name)) return;
    const auto given = std::find(choices.begin(), choices.end(), value_);
    if (given == choices.end()) refuse("one of " + joined(choices));
    index = static_cast<std::size_t>(given - choices.begin());
  }

  void refuse_unknown_key() const {
    if (found_) return;
    throw OptionError(fmt::format("there is no option '{}'; known are{}", key_, names_));
  }

 private:
  bool is_meant(std::string_view name) {
    names_ += fmt::format("\n  {}", name);
    if (name == key_) found_ = true;
    return name == key_;
  }
  [[noreturn]] void refuse(const std::string& expected) const {
    throw OptionError(fmt::format("{}: expected {}, found '{}'", key_, expected, value_));
  }

  std::string_view key_;
  std::string_view value_;
  std::string names_;
  bool found_ = false;
};

// Collects what there is to know of every option.
class Lister {
 public:
  void number(std::string_view name, float& value, double min, double max,
              std::string_view meaning) {
    add(name, fmt::format("{}", value), fmt::format("{} to {}", min, max), meaning);
  }
  void integer(std::string_view name, std::uint32_t& value, std::uint32_t min, std::uint32_t max,
               std::string_view meaning) {
    add(name, fmt::format("{}", value), fmt::format("{} to {}", min, max), meaning);
  }
  void boolean(std::string_view name, bool& value, std::string_view meaning) {
    add(name, value ? "true" : "false", "true, false", meaning);
  }
  template <class Choices>
  void choice(std::string_view name, std::size_t& index, const Choices& choices,
              std::string_view meaning) {
    add(name, std::string(choices[index]), joined(choices), meaning);
  }
  [[nodiscard]] std::string to_string() const { return table_.to_string(); }

 private:
  void add(std::string_view name, std::string value, std::string range, std::string_view meaning) {
    table_.add_row({std::string(name), std::move(value), std::move(range), std::string(meaning)});
  }
  Table table_{{{"option", Align::left},
                {"default", Align::right},
                {"allowed", Align::left},
                {"meaning", Align::left}}};
};

}  // namespace

void set_option(segmentation::Options& options, std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos) {
    throw OptionError(
        fmt::format("expected KEY=VALUE, e.g. voxel.size_m=0.005, found '{}'", assignment));
  }
  Setter setter(assignment.substr(0, equals), assignment.substr(equals + 1));
  segmentation::visit_options(options, setter);
  setter.refuse_unknown_key();
}

std::string list_options() {
  segmentation::Options defaults;
  Lister lister;
  segmentation::visit_options(defaults, lister);
  return lister.to_string();
}

}  // namespace cleave::workbench
