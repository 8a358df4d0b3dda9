// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/idl/idl_file.hpp"

#include <fstream>
#include <ostream>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace cleave::test {
namespace {

std::string text_without_comments(const std::string& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error("cannot read " + file);
  std::string text;
  for (std::string line; std::getline(stream, line);) text += line.substr(0, line.find("//")) + ' ';
  return text;
}

std::vector<std::smatch> all_matches(const std::string& text, const std::regex& pattern) {
  return {std::sregex_iterator(text.begin(), text.end(), pattern), {}};
}

std::vector<IdlMember> members_in(const std::string& body) {
  static const std::regex member(R"((?:@key )?\s*([\w<> ]*[\w>])\s+(\w+)(\[\w+\])?\s*;)");
  std::vector<IdlMember> members;
  for (const std::smatch& match : all_matches(body, member)) {
    const bool is_text = match[1] == "char" && match[3].matched;
    members.push_back({is_text ? "string" : match[1].str() + match[3].str(), match[2]});
  }
  return members;
}

std::vector<std::string> words_in(const std::string& body) {
  static const std::regex word(R"(\w+)");
  std::vector<std::string> words;
  for (const std::smatch& match : all_matches(body, word)) words.push_back(match.str());
  return words;
}

}  // namespace

IdlFile read_contract() {
  const std::string text = text_without_comments(CLEAVE_IDL);
  static const std::regex part(R"((struct|enum) (\w+) \{([^}]*)\})");
  IdlFile file;
  for (const std::smatch& match : all_matches(text, part)) {
    const std::string body = match[3];
    if (match[1] == "struct") {
      file.structs[match[2]] = members_in(body);
    } else {
      file.enumerations[match[2]] = words_in(body);
    }
  }
  return file;
}

void PrintTo(const IdlMember& member, std::ostream* to) {
  *to << member.type << ' ' << member.name;
}

}  // namespace cleave::test
