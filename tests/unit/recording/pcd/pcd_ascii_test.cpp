// SPDX-License-Identifier: BSD-3-Clause
// Points as text.
#include <gtest/gtest.h>

#include <array>
#include <clocale>
#include <cmath>
#include <cstring>

#include "recording/pcd/cloud.hpp"
#include "recording/pcd/encoding/number.hpp"
#include "tests/unit/recording/pcd/pcd_files.hpp"

namespace cleave::recording {
namespace {

template <class Number>
Number read_number(const std::string& word, char type) {
  Number value{};
  std::array<std::uint8_t, 8> bytes{};
  const PcdField field{"a", type, sizeof(Number), 1};
  EXPECT_EQ(write_number(word, field, bytes.data()), nullptr) << word;
  std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

std::string problem_of(const char* word, char type, std::uint32_t size) {
  std::array<std::uint8_t, 8> bytes{};
  const char* const problem = write_number(word, {"a", type, size, 1}, bytes.data());
  return problem == nullptr ? "" : problem;
}

TEST(PcdNumber, MayBeWrittenInAnyForm) {
  EXPECT_EQ(read_number<float>("1e-3", 'F'), 1e-3F);
  EXPECT_EQ(read_number<float>("+1.5E2", 'F'), 150.0F);
  EXPECT_EQ(read_number<float>(".5", 'F'), 0.5F);
  EXPECT_EQ(read_number<float>("5.", 'F'), 5.0F);
  EXPECT_EQ(read_number<double>("0.1", 'F'), 0.1);
  EXPECT_EQ(read_number<double>("9007199254740993", 'F'), 9007199254740992.0);
}

TEST(PcdNumber, MayBeNoneOrInfinite) {
  for (const char* word : {"nan", "NaN", "NAN", "-nan"}) {
    EXPECT_TRUE(std::isnan(read_number<float>(word, 'F'))) << word;
  }
  EXPECT_EQ(read_number<float>("inf", 'F'), INFINITY);
  EXPECT_EQ(read_number<double>("-Infinity", 'F'), -INFINITY);
}

TEST(PcdNumber, BeyondTheRangeOfItsTypeIsInfiniteOr0) {
  EXPECT_EQ(read_number<float>("1e300", 'F'), INFINITY);
  EXPECT_EQ(read_number<float>("-1e300", 'F'), -INFINITY);
  EXPECT_EQ(read_number<float>("1e-300", 'F'), 0.0F);
  for (const std::string huge : {"1e400", "1e5000", "1E+99999999999", "0.001e5000"}) {
    EXPECT_EQ(read_number<double>(huge, 'F'), INFINITY) << huge;
    EXPECT_EQ(read_number<double>("-" + huge, 'F'), -INFINITY) << huge;
  }
  EXPECT_EQ(read_number<double>("1" + std::string(6000, '0'), 'F'), INFINITY);
  EXPECT_EQ(read_number<double>("1" + std::string(6000, '0') + "e-6000", 'F'), 1);
  for (const std::string tiny : {"1e-400", "1e-5000", "-1E-99999999999", "1000e-5000"}) {
    EXPECT_EQ(read_number<double>(tiny, 'F'), 0) << tiny;
  }
  EXPECT_EQ(read_number<double>("0." + std::string(6000, '0') + "1", 'F'), 0);
  EXPECT_EQ(read_number<float>("1e-42", 'F'), 1e-42F) << "denormal";
}

TEST(PcdNumber, KeepsIntegersThatNoFloatHolds) {
  EXPECT_EQ(read_number<std::int64_t>("9007199254740993", 'I'), 9007199254740993);
  EXPECT_EQ(read_number<std::uint64_t>("18446744073709551615", 'U'), 18446744073709551615U);
  EXPECT_EQ(read_number<std::int64_t>("-9223372036854775808", 'I'), INT64_MIN);
  EXPECT_EQ(read_number<std::int8_t>("-128", 'I'), -128);
  EXPECT_EQ(read_number<std::uint16_t>("65535", 'U'), 65535);
}

TEST(PcdNumber, OfAnIntegerMayBeADecimalOrTheSameBits) {
  EXPECT_EQ(read_number<std::uint32_t>("2e3", 'U'), 2000U);
  EXPECT_EQ(read_number<std::int32_t>("-7.0", 'I'), -7);
  EXPECT_EQ(read_number<std::uint32_t>("-1", 'U'), 4294967295U);
  EXPECT_EQ(read_number<std::int8_t>("255", 'I'), -1);
  EXPECT_EQ(read_number<std::int32_t>("nan", 'I'), 0);
}

TEST(PcdNumber, ThatDoesNotFitIsNamed) {
  EXPECT_EQ(problem_of("256", 'U', 1), "does not fit into it");
  EXPECT_EQ(problem_of("-129", 'I', 1), "does not fit into it");
  EXPECT_EQ(problem_of("4294967296", 'U', 4), "does not fit into it");
  EXPECT_EQ(problem_of("1.5", 'U', 4), "is no whole number that it can hold");
  EXPECT_EQ(problem_of("1e30", 'I', 8), "is no whole number that it can hold");
  for (const char* word : {"one", "1,5", "0x10", "--1", "1e", "+", "-", "1.2.3"}) {
    EXPECT_EQ(problem_of(word, 'F', 4), "is no number") << word;
    EXPECT_EQ(problem_of(word, 'I', 4), "is no number") << word;
  }
}

TEST(PcdText, DoesNotDependOnTheLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) std::setlocale(LC_ALL, name);
  EXPECT_EQ(read_number<float>("1.5", 'F'), 1.5F);
  std::setlocale(LC_ALL, before.c_str());
}

std::string with_data(const std::string& data) {
  PcdText pcd;
  pcd.data = data;
  return to_file(pcd);
}

TEST(PcdText, ThatEndsEarlySaysHowManyPointsThereAre) {
  expect_refused(with_data("1 2 3\n"), "truncated", "promises 2 points, but the file ends after 1");
  expect_refused(with_data("1 2 3\n4"), "truncated", "ends after 1");
  expect_refused(with_data(""), "truncated", "ends after 0");
  expect_refused(with_data("1 2 3\n\n\n\n\n\n"), "truncated", "ends after 1");
}

TEST(PcdText, WithTooFewOrTooManyNumbersNamesTheLine) {
  expect_refused(with_data("1 2\n4 5 6\n"), "damaged data",
                 "line 12: has 2 numbers, the fields of a point ask for 3");
  expect_refused(with_data("1 2 3\n\n4 5 6 7 8\n"), "damaged data", "line 14: has 5 numbers");
}

TEST(PcdText, WithAWordForANumberNamesLineAndField) {
  expect_refused(with_data("1 2 3\n4 five 6\n"), "damaged data",
                 "line 13: 'five' in field y (TYPE F, SIZE 4) is no number");
}

TEST(PcdText, ThatPromisesFarMoreThanTheFileHoldsIsRefused) {
  PcdText pcd;
  pcd.width = pcd.points = "80000000";
  expect_refused(to_file(pcd), "truncated", "promises 80000000 points, but the file ends after 2");
}

}  // namespace
}  // namespace cleave::recording
