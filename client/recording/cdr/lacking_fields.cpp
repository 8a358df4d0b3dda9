// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cdr/lacking_fields.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

#include "recording/schemas/schemas.hpp"

namespace cleave::recording {
namespace {

// Those whose bytes this library knows by heart; the first may lack fields.
constexpr const char* types[] = {"FrameHeader", "Point",          "Quaternion",
                                 "Pose3",       "ImageRectangle", "OrientedBox",
                                 "Segment",     "Border",         "SegmentList"};
constexpr const char* unchanged_types[] = {"Cloud", "Labels"};

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

// The members of "struct NAME { ... };" as they are declared; none if there is no such struct.
std::vector<std::string> members_of(std::string_view text, const std::string& name) {
  const std::string head = "struct " + name + " {";
  const std::size_t start = text.find(head);
  if (start == std::string_view::npos) return {};
  text.remove_prefix(start + head.size());
  text = text.substr(0, text.find('}'));
  std::vector<std::string> members;
  for (std::size_t end = text.find(';'); end != std::string_view::npos; end = text.find(';')) {
    std::string_view member = text.substr(0, end);
    member.remove_prefix(std::min(member.find_first_not_of(' '), member.size()));
    members.emplace_back(member);
    text.remove_prefix(end + 1);
  }
  return members;
}

// "char sensor[64]" declares "sensor".
std::string name_in(const std::string& member) {
  const std::string without_size = member.substr(0, member.find('['));
  return without_size.substr(without_size.rfind(' ') + 1);
}

// Names of ours that theirs lack; nothing if theirs are not ours with some left out.
std::optional<std::set<std::string, std::less<>>> left_out(const std::vector<std::string>& ours,
                                                           const std::vector<std::string>& theirs) {
  std::set<std::string, std::less<>> names;
  auto next = theirs.begin();
  for (const std::string& member : ours) {
    if (next != theirs.end() && *next == member) {
      ++next;
    } else {
      names.insert(name_in(member));
    }
  }
  if (next != theirs.end()) return std::nullopt;
  return names;
}

}  // namespace

std::optional<LackingFields> lacking_fields(std::string_view schema) {
  static const std::string ours = essence(recording_schema);
  const std::string theirs = essence(schema);
  if (members_of(theirs, types[0]).empty()) return std::nullopt;
  LackingFields lacking;
  for (const char* const type : types) {
    const std::vector<std::string> members = members_of(theirs, type);
    if (members.empty()) continue;  // its recordings hold none
    auto names = left_out(members_of(ours, type), members);
    if (!names) return std::nullopt;
    if (!names->empty()) lacking[type] = std::move(*names);
  }
  for (const char* const type : unchanged_types) {
    const std::vector<std::string> members = members_of(theirs, type);
    if (!members.empty() && members != members_of(ours, type)) return std::nullopt;
  }
  return lacking;
}

}  // namespace cleave::recording
