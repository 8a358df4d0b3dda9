// SPDX-License-Identifier: BSD-3-Clause
#include "recording/ros/file_topic.hpp"

namespace cleave::recording {

FileTopic split_topic(std::string_view text) {
  constexpr std::string_view key = "?topic=";
  const std::size_t at = text.rfind(key);
  if (at == std::string_view::npos) return {text, ""};
  return {text.substr(0, at), std::string(text.substr(at + key.size()))};
}

}  // namespace cleave::recording
