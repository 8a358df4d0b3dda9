// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/trials/groups.hpp"

#include "workbench/cloud/parse_number.hpp"

namespace cleave::workbench {
namespace {

Group parse_group(std::string_view text, std::size_t scenes) {
  const std::size_t dash = text.find('-');
  const auto first = parse_number<std::size_t>(text.substr(0, dash));
  const auto last =
      dash == std::string_view::npos ? first : parse_number<std::size_t>(text.substr(dash + 1));
  if (!first || !last || *first > *last) {
    throw GroupError("expected groups like 0-15,16-23, found '" + std::string(text) + "'");
  }
  if (*last >= scenes) {
    throw GroupError("group " + std::string(text) + " is not there: the " + std::to_string(scenes) +
                     " scenes are numbered from 0 to " + std::to_string(scenes - 1));
  }
  return {*first, *last};
}

}  // namespace

std::string Group::name() const {
  return first == last ? std::to_string(first) : std::to_string(first) + "-" + std::to_string(last);
}

std::vector<Group> parse_groups(std::string_view text, std::size_t scenes) {
  std::vector<Group> groups;
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    groups.push_back(parse_group(text.substr(0, comma), scenes));
    text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
  }
  return groups;
}

}  // namespace cleave::workbench
