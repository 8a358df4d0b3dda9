// SPDX-License-Identifier: BSD-3-Clause
// Files that are mutated and cut at random: whatever they say, the reader ends in time, with a
// clear error or with the frames that are whole. Worth most under the address sanitizer.
#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "recording/oni/oni_reader.hpp"
#include "tests/unit/recording/oni/oni_file.hpp"

namespace cleave::oni {
namespace {

using test::Image;
using test::OniFile;
using test::TestFile;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds hang{5};

struct Outcome {
  std::string error;
  std::vector<Image> frames;  // those that can be read
};

Outcome play(const TestFile& file) {
  const auto start = Clock::now();
  Outcome outcome;
  try {
    Reader reader(file.path());
    DepthFrame frame;
    for (std::size_t i = 0; i < reader.size(); ++i) {
      if (const auto why = reader.read(i, frame)) {
        EXPECT_NE(why->find(file.path().string()), std::string::npos) << *why;
      } else {
        outcome.frames.push_back(frame.depth);
      }
    }
  } catch (const std::runtime_error& error) {
    outcome.error = error.what();
    EXPECT_NE(outcome.error.find(file.path().string()), std::string::npos) << outcome.error;
  }
  EXPECT_LT(Clock::now() - start, hang);
  return outcome;
}

OniFile whole_file(std::uint32_t which) {
  OniFile file;
  file.codec = std::vector<std::string>{"16zT", "16zP", "NONE"}.at(which % 3);
  file.wide = which % 2 == 0;
  for (std::uint32_t i = 0; i < 4; ++i) {
    file.frames.push_back(test::example_image(file.width, file.height, 10 * which + i));
  }
  return file;
}

// One to eight bytes set, runs repeated or left out, numbers made extreme.
std::string mutate(std::string content, std::mt19937& random) {
  const auto place = [&] { return random() % content.size(); };
  for (unsigned changes = 1 + random() % 8; changes > 0; --changes) {
    switch (random() % 5) {
      case 0:
        content[place()] = static_cast<char>(random());
        break;
      case 1:
        content[place()] ^= static_cast<char>(1U << random() % 8);
        break;
      case 2:
        content.replace(place(), 4, std::string(4, random() % 2 == 0 ? '\xff' : '\0'));
        break;
      case 3:
        content.insert(place(), content.substr(place(), random() % 200));
        break;
      default:
        content.erase(place(), random() % 40);
    }
  }
  return content;
}

TEST(DamagedOni, AThousandMutatedFilesGiveAClearErrorOrTheirIntactFrames) {
  std::mt19937 random(20240501);
  const TestFile file("");
  std::size_t frames = 0, refused = 0;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    file.write(mutate(whole_file(i % 12).bytes(), random));
    const Outcome outcome = play(file);
    frames += outcome.frames.size();
    if (!outcome.error.empty()) ++refused;
  }
  EXPECT_LT(refused, 600U) << "the mutations leave nothing to read";
  EXPECT_GT(frames, 1000U);
  RecordProperty("refused", static_cast<int>(refused));
  RecordProperty("frames", static_cast<int>(frames));
}

TEST(DamagedOni, TwoHundredTruncatedFilesGiveEveryWholeFrame) {
  std::mt19937 random(7);
  const TestFile file("");
  for (std::uint32_t i = 0; i < 200; ++i) {
    const OniFile source = whole_file(i % 12);
    std::vector<std::size_t> starts;
    const std::string whole = source.bytes(&starts);
    const std::size_t length = random() % whole.size();
    file.write(whole.substr(0, length));
    const Outcome outcome = play(file);
    std::size_t expected = 0;
    while (expected + 1 < starts.size() && starts[expected + 1] <= length) ++expected;
    ASSERT_GE(outcome.frames.size(), expected) << outcome.error;
    for (std::size_t f = 0; f < outcome.frames.size(); ++f) {
      ASSERT_EQ(outcome.frames[f], source.frames[f]);
    }
    EXPECT_TRUE(length > starts[0] || !outcome.error.empty() || outcome.frames.empty());
  }
}

TEST(DamagedOni, AFileOfNothingButRecordStartsIsPassedOverInTime) {
  std::string content = whole_file(0).bytes();
  for (int i = 0; i < 500'000; ++i) content.append("NIR\0", 4);
  const TestFile file(content);
  EXPECT_EQ(play(file).frames.size(), 4U);
}

}  // namespace
}  // namespace cleave::oni
