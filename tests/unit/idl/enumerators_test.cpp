// SPDX-License-Identifier: BSD-3-Clause
// Enumerations of the contract are mirrored by hand, and people read words of our own: both in the
// IDL's order.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include "libcleave/status.hpp"
#include "recording/frames/frame.hpp"
#include "segmenter/pipeline/causes.hpp"
#include "tests/unit/idl/idl_file.hpp"

namespace cleave::test {
namespace {

// {"STATE_SOURCE_LOST", ...} without "STATE_": {"source lost", ...}.
std::vector<std::string> words_of(const std::string& enumeration,
                                  const std::vector<std::string_view>& prefixes) {
  const IdlFile contract = read_contract();
  std::vector<std::string> words;
  for (std::string_view name : contract.enumerations.at(enumeration)) {
    for (const std::string_view prefix : prefixes) {
      if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
    }
    std::string& word = words.emplace_back(name);
    std::ranges::replace(word, '_', ' ');
    std::ranges::transform(word, word.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  }
  return words;
}

// The words for 0, 1, ..., as many as the contract has.
template <class Enum, class Name>
std::vector<std::string> names(std::size_t count, const Name& name) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < count; ++i) all.emplace_back(name(static_cast<Enum>(i)));
  return all;
}

const auto word = [](auto value) { return to_string(value); };
const auto recorded_word = [](auto value) { return name_of(value); };

TEST(Enumerators, OfANodesStateHaveTheirWords) {
  const auto words = words_of("NodeState", {"STATE_"});
  EXPECT_EQ(names<NodeState>(words.size(), word), words);
  EXPECT_STREQ(to_string(static_cast<NodeState>(words.size())), "unknown");
}

TEST(Enumerators, OfATransportHaveTheirWords) {
  const auto words = words_of("Transport", {"TRANSPORT_"});
  EXPECT_EQ(names<Transport>(words.size(), word), words);
}

TEST(Enumerators, OfABordersKindHaveTheirWords) {
  const auto words = words_of("BorderKind", {"BORDER_"});
  EXPECT_EQ(names<recording::BorderKind>(words.size(), recorded_word), words);
}

TEST(Enumerators, OfAFramesOutcomeHaveTheirWords) {
  const auto words = words_of("FrameOutcome", {"OUTCOME_", "REJECTED_"});
  EXPECT_EQ(names<recording::FrameOutcome>(words.size(), recorded_word), words);
  EXPECT_STREQ(name_of(static_cast<recording::FrameOutcome>(words.size())), "unknown");
}

TEST(Enumerators, OfARejectionAreTheOutcomesBehindTheFirst) {
  auto words = words_of("FrameOutcome", {"OUTCOME_", "REJECTED_"});
  words.erase(words.begin());
  ASSERT_EQ(service::reject_cause_names.size(), words.size());
  EXPECT_EQ(names<service::RejectCause>(words.size(), word), words);
}

}  // namespace
}  // namespace cleave::test
