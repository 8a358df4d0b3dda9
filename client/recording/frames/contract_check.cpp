// SPDX-License-Identifier: BSD-3-Clause
#include "recording/frames/contract_check.hpp"

#include <cctype>
#include <string>

#include "recording/schemas/schemas.hpp"

namespace cleave::recording {
namespace {

// Those whose bytes this library knows by heart.
constexpr const char* types[] = {"FrameHeader",    "Pose3",       "Point",   "Quaternion",
                                 "ImageRectangle", "OrientedBox", "Segment", "Border",
                                 "SegmentList",    "Cloud",       "Labels"};

// Without comments, and with one blank wherever there is any.
std::string essence(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i, 2) == "//") i = text.find('\n', i);
    if (i >= text.size()) break;
    if (std::isspace(static_cast<unsigned char>(text[i])) == 0) {
      result += text[i];
    } else if (!result.empty() && result.back() != ' ') {
      result += ' ';
    }
  }
  return result;
}

// "struct NAME { ... };"; empty if there is none.
std::string_view definition(std::string_view text, const std::string& name) {
  const std::size_t start = text.find("struct " + name + " {");
  if (start == std::string_view::npos) return {};
  return text.substr(start, text.find("};", start) - start);
}

}  // namespace

bool is_of_this_contract(std::string_view schema) {
  static const std::string ours = essence(recording_schema);
  const std::string theirs = essence(schema);
  for (const char* const type : types) {
    const std::string_view found = definition(theirs, type);
    if (!found.empty() && found != definition(ours, type)) return false;
  }
  return !definition(theirs, "FrameHeader").empty();
}

}  // namespace cleave::recording
