// SPDX-License-Identifier: BSD-3-Clause
#include "config/section.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <utility>

#include "config/section_state.hpp"

namespace cleave::config {
namespace {

// Quoted scalars are texts: "30" is no number, "true" is no boolean.
bool is_plain(const YAML::Node& value) {
  return value.IsScalar() && value.Tag() != "!";
}

template <class T>
bool parse(const YAML::Node& value, T& number) {
  if (!is_plain(value)) return false;
  const std::string& text = value.Scalar();
  const char* const end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && last == end;
}

template <class T>
std::string range(const char* what, T min, T max) {
  std::ostringstream text;
  text << what << " from " << min << " to " << max;
  return text.str();
}

}  // namespace

Section Section::load(const std::filesystem::path& file) {
  return Section(State::load(file));
}

Section::Section(std::shared_ptr<State> state) : state_(std::move(state)) {}
Section::Section(Section&&) noexcept = default;
Section::~Section() = default;

void Section::number(std::string_view key, double& value, double min, double max) {
  const YAML::Node found = state_->find(key);
  if (!found.IsDefined()) return;
  double number = 0;
  // Written so that NaN is refused.
  if (!parse(found, number) || !(number >= min && number <= max)) {
    state_->refuse(key, found, range("a number", min, max));
  }
  value = number;
}

void Section::number(std::string_view key, float& value, double min, double max) {
  double number = value;
  this->number(key, number, min, max);
  value = static_cast<float>(number);
}

void Section::integer(std::string_view key, std::uint32_t& value, std::uint32_t min,
                      std::uint32_t max) {
  const YAML::Node found = state_->find(key);
  if (!found.IsDefined()) return;
  std::uint32_t number = 0;
  if (!parse(found, number) || number < min || number > max) {
    state_->refuse(key, found, range("a whole number", min, max));
  }
  value = number;
}

void Section::boolean(std::string_view key, bool& value) {
  const YAML::Node found = state_->find(key);
  if (!found.IsDefined()) return;
  if (!is_plain(found) || (found.Scalar() != "true" && found.Scalar() != "false")) {
    state_->refuse(key, found, "true or false");
  }
  value = found.Scalar() == "true";
}

void Section::text(std::string_view key, std::string& value) {
  const YAML::Node found = state_->find(key);
  if (!found.IsDefined()) return;
  if (!found.IsScalar()) state_->refuse(key, found, "a text");
  value = found.Scalar();
}

void Section::choice(std::string_view key, std::size_t& index,
                     const std::vector<std::string>& choices) {
  const YAML::Node found = state_->find(key);
  if (!found.IsDefined()) return;
  const auto chosen =
      found.IsScalar() ? std::find(choices.begin(), choices.end(), found.Scalar()) : choices.end();
  if (chosen == choices.end()) state_->refuse(key, found, "one of " + joined(choices));
  index = static_cast<std::size_t>(chosen - choices.begin());
}

void Section::list(std::string_view key, std::vector<std::string>& value) {
  const YAML::Node found = state_->find(key);
  if (!found.IsDefined()) return;
  if (!found.IsSequence()) state_->refuse(key, found, "a list, [a, b]");
  std::vector<std::string> texts;
  for (const YAML::Node& element : found) {
    if (!element.IsScalar()) {
      const std::string place = std::string(key) + "[" + std::to_string(texts.size()) + "]";
      state_->refuse(place, element, "a text");
    }
    texts.push_back(element.Scalar());
  }
  value = std::move(texts);
}

Section Section::section(std::string_view key) {
  return Section(state_->child(key));
}

void Section::refuse(std::string_view key, const std::string& expected) const {
  const YAML::Node found = state_->value_of(key);
  if (found.IsDefined()) state_->refuse(key, found, expected);
  state_->fail(found, key, "expected " + expected);
}

void Section::finish() const {
  state_->finish();
}

}  // namespace cleave::config
