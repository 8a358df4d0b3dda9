// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/topic_names.hpp"

#include "console/command.hpp"

namespace cleave::client {

const char* topic_of(recording::Kind kind) {
  switch (kind) {
    case recording::Kind::cloud:
      return "cloud";
    case recording::Kind::labels:
      return "labels";
    case recording::Kind::segments:
      break;
  }
  return "segments";
}

std::set<recording::Kind> kinds_of(const std::vector<std::string>& names) {
  using recording::Kind;
  std::set<Kind> all = {Kind::cloud, Kind::labels, Kind::segments};
  if (names.empty()) return all;
  std::set<Kind> kinds;
  for (const std::string& name : names) {
    bool known = false;
    for (const Kind kind : all) {
      if (name != topic_of(kind)) continue;
      kinds.insert(kind);
      known = true;
    }
    if (!known) {
      throw UsageError("--topics: '" + name + "' is none of cloud, labels, segments");
    }
  }
  return kinds;
}

}  // namespace cleave::client
