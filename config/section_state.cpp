// SPDX-License-Identifier: BSD-3-Clause
#include "config/section_state.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "config/closest.hpp"

namespace cleave::config {
namespace {

std::string describe(const YAML::Node& value) {
  switch (value.Type()) {
    case YAML::NodeType::Scalar:
      return "'" + value.Scalar() + "'";
    case YAML::NodeType::Sequence:
      return "a list";
    case YAML::NodeType::Map:
      return "a section";
    default:
      return "nothing";
  }
}

std::string read(const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& why) {
    throw ConfigurationError(file.string() + ": cannot read the configuration: " + why);
  };
  std::error_code error;
  if (!std::filesystem::exists(file, error)) refuse("there is no such file");
  if (std::filesystem::is_directory(file, error)) refuse("it is a folder");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) refuse("may this user read it?");
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::shared_ptr<Section::State> Section::State::load(const std::filesystem::path& file) {
  auto state = std::make_shared<State>(State{file.string(), "", {}});
  std::vector<YAML::Node> documents;
  try {
    documents = YAML::LoadAll(read(file));
  } catch (const YAML::Exception& error) {
    state->line = error.mark.is_null() ? 1 : error.mark.line + 1;
    state->fail({}, "", "this is not YAML: " + error.msg);
  }
  if (documents.size() > 1) state->fail(documents[1], "", "expected one document, found more");
  if (!documents.empty()) state->mapping = documents.front();
  if (!state->mapping.IsMap()) state->refuse("", state->mapping, "keys with values, 'key: value'");
  state->check_mapping();
  return state;
}

YAML::Node Section::State::find(std::string_view key) {
  if (std::find(known.begin(), known.end(), key) == known.end()) known.emplace_back(key);
  return value_of(key);
}

YAML::Node Section::State::value_of(std::string_view key) const {
  for (const auto& entry : mapping) {
    if (entry.first.Scalar() == key) return entry.second;
  }
  return YAML::Node(YAML::NodeType::Undefined);
}

std::shared_ptr<Section::State> Section::State::child(std::string_view key) {
  const YAML::Node found = find(key);
  for (const auto& [name, child] : children) {
    if (name == key) return child;
  }
  auto below = std::make_shared<State>(State{file, path + std::string(key) + ".", {}, line});
  // A section whose keys are all commented out is null, and as good as absent.
  if (found.IsDefined() && !found.IsNull()) {
    if (!found.IsMap()) refuse(key, found, "a section");
    below->mapping = found;
    below->line = found.Mark().line + 1;
    below->check_mapping();
  }
  children.emplace_back(key, below);
  return below;
}

void Section::State::check_mapping() const {
  std::vector<std::string> seen;
  for (const auto& entry : mapping) {
    if (!entry.first.IsScalar()) refuse("", entry.first, "a key");
    const std::string& key = entry.first.Scalar();
    if (std::find(seen.begin(), seen.end(), key) != seen.end()) {
      fail(entry.first, key, "stands there twice");
    }
    seen.push_back(key);
  }
}

void Section::State::finish() const {
  for (const auto& entry : mapping) {
    const std::string& key = entry.first.Scalar();
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string suggestion = closest(key, known);
    fail(entry.first, key,
         "unknown key; " + (suggestion.empty() ? "" : "did you mean '" + suggestion + "'? ") +
             "Known here: " + joined(known));
  }
  for (const auto& [key, child] : children) child->finish();
}

void Section::State::refuse(std::string_view key, const YAML::Node& found,
                            const std::string& expected) const {
  fail(found, key, "expected " + expected + ", found " + describe(found));
}

void Section::State::fail(const YAML::Node& where, std::string_view key,
                          const std::string& problem) const {
  const std::string name = path + std::string(key);
  throw ConfigurationError(file + ":" + std::to_string(line_of(where, key)) + ": " +
                           (name.empty() ? "" : name + ": ") + problem);
}

int Section::State::line_of(const YAML::Node& value, std::string_view key) const {
  YAML::Node place = value;
  if (value.IsDefined() && value.IsNull()) {  // whose mark is where the next key begins
    for (const auto& entry : mapping) {
      if (entry.first.Scalar() == key) place.reset(entry.first);
    }
  }
  return place.IsDefined() && !place.Mark().is_null() ? place.Mark().line + 1 : line;
}

}  // namespace cleave::config
