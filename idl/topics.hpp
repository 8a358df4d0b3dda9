// SPDX-License-Identifier: BSD-3-Clause
// Names of the contract and its topics, and the rule for the one part of them that a user chooses.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace cleave {

// Programs whose contract differs do not understand each other: the module in cleave_v1.idl.
inline constexpr std::string_view contract_name = "cleave_v1";

// Programs that were compiled against another one must be compiled anew: CLEAVE_ABI_VERSION of
// client/c/cleave.h.
inline constexpr unsigned c_abi_version = 1;

inline std::string version_text(std::string_view version) {
  return std::string(version) + " (contract " + std::string(contract_name) + ", C ABI " +
         std::to_string(c_abi_version) + ")";
}

inline constexpr std::size_t max_sensor_name_length = 63;  // char sensor[64] in the contract

inline std::string cloud_topic(std::string_view sensor) {
  return "cleave/" + std::string(sensor) + "/cloud";
}
inline std::string labels_topic(std::string_view sensor) {
  return "cleave/" + std::string(sensor) + "/labels";
}
// Where clouds of more than 640 x 480 points travel, and their label maps.
inline std::string large_cloud_topic(std::string_view sensor) {
  return "cleave/" + std::string(sensor) + "/large_cloud";
}
inline std::string large_labels_topic(std::string_view sensor) {
  return "cleave/" + std::string(sensor) + "/large_labels";
}
inline std::string segments_topic(std::string_view sensor) {
  return "cleave/" + std::string(sensor) + "/segments";
}
inline constexpr std::string_view status_topic = "cleave/status";

// What the nodes of a sensor call themselves in their statuses.
inline std::string grabber_node(std::string_view sensor) {
  return "grabber/" + std::string(sensor);
}
inline std::string segmenter_node(std::string_view sensor) {
  return "segmenter/" + std::string(sensor);
}

// A sensor's name is part of topic names: 1 to 63 letters, digits or '_' (DDS allows no others).
inline bool is_valid_sensor_name(std::string_view name) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !name.empty() && name.size() <= max_sensor_name_length &&
         std::all_of(name.begin(), name.end(), allowed);
}

}  // namespace cleave
