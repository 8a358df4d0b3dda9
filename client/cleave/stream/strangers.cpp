// SPDX-License-Identifier: BSD-3-Clause
#include "cleave/stream/strangers.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <map>

#include "console/table.hpp"
#include "idl/topics.hpp"

namespace cleave::client {
namespace {

using Writers = std::map<std::string, std::vector<std::string>>;  // by topic

std::string name_of(const Endpoint& endpoint) {
  return endpoint.process.empty() ? "a program that does not tell its name"
                                  : printable(endpoint.process);
}

// Every node publishes its status.
Writers writers_of_sensors(const std::vector<Endpoint>& endpoints) {
  Writers writers;
  for (const Endpoint& e : endpoints) {
    if (e.writes && e.topic != status_topic) writers[e.topic].push_back(name_of(e));
  }
  return writers;
}

// As discovery names a process: "cleave-segmenter (12)".
bool is_process(const std::string& writer, std::uint32_t process) {
  return writer.ends_with("(" + std::to_string(process) + ")");
}

void add_impostors(const Writers& writers, const NodeReport& node,
                   std::vector<std::string>& lines) {
  if (node.node != segmenter_node(node.sensor)) return;
  const auto of_sensor = writers.find(segments_topic(node.sensor));
  if (of_sensor == writers.end()) return;
  for (const std::string& writer : of_sensor->second) {
    if (is_process(writer, node.process_id)) continue;
    lines.push_back(fmt::format("{} publishes {} and is not its segmenter, which is process {}",
                                writer, printable(of_sensor->first), node.process_id));
  }
}

}  // namespace

std::vector<std::string> strangers(const std::vector<Endpoint>& endpoints,
                                   const std::vector<NodeReport>& nodes) {
  std::vector<std::string> lines;
  const Writers writers = writers_of_sensors(endpoints);
  for (const auto& [topic, names] : writers) {
    if (names.size() < 2) continue;
    lines.push_back(fmt::format("{} programs publish {}, and readers get the samples of all: {}",
                                names.size(), printable(topic), fmt::join(names, ", ")));
  }
  for (const NodeReport& node : nodes) add_impostors(writers, node, lines);
  if (std::string other = other_contract(endpoints); !other.empty()) {
    lines.push_back(printable(other));
  }
  return lines;
}

}  // namespace cleave::client
