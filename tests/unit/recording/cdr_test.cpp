// SPDX-License-Identifier: BSD-3-Clause
#include "recording/cdr/cdr.hpp"

#include <gtest/gtest.h>

#include "recording/frames/segment_list_message.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::recording {
namespace {

TEST(Cdr, AlignsNumbersToTheirSizeBehindTheEncapsulation) {
  CdrWriter cdr;
  cdr.number(std::uint8_t{1});
  cdr.number(std::uint32_t{2});
  cdr.number(std::uint8_t{3});
  cdr.number(4.0);
  EXPECT_EQ(cdr.bytes().size(), 4U + 4 + 4 + 8 + 8);
  CdrReader reader(cdr.bytes());
  EXPECT_EQ(reader.number<std::uint8_t>(), 1);
  EXPECT_EQ(reader.number<std::uint32_t>(), 2U);
  EXPECT_EQ(reader.number<std::uint8_t>(), 3);
  EXPECT_EQ(reader.number<double>(), 4.0);
}

TEST(Cdr, WritesTextsWithTheirEnd) {
  CdrWriter cdr;
  cdr.string("abc");
  cdr.characters("de", 4);
  CdrReader reader(cdr.bytes());
  EXPECT_EQ(reader.string(), "abc");
  EXPECT_EQ(reader.characters(4), "de");
}

TEST(Cdr, RefusesANameThatIsTooLong) {
  CdrWriter cdr;
  EXPECT_THROW(cdr.characters("abcd", 4), DataError);
}

TEST(Cdr, RefusesALengthThatTheMessageCannotHold) {
  CdrWriter cdr;
  cdr.length(1'000'000'000);
  CdrReader reader(cdr.bytes());
  EXPECT_THROW((void)reader.length(4), DataError);
}

TEST(Cdr, ReadsBigEndianNumbersToo) {
  Bytes message(8);  // its encapsulation says big endian
  message[7] = std::byte{9};
  EXPECT_EQ(CdrReader(message).number<std::uint32_t>(), 9U);
}

TEST(Cdr, RefusesOtherEncodingsByName) {
  EXPECT_THROW(CdrReader reader(ByteView{}), DataError);
  for (const auto& [second, name] :
       {std::pair{3, "PL_CDR"}, {7, "XCDR2"}, {77, "does not begin"}}) {
    Bytes message(8);
    message[1] = static_cast<std::byte>(second);
    try {
      const CdrReader reader(message);
      FAIL() << name;
    } catch (const DataError& error) {
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
  }
}

TEST(SegmentListMessage, GivesBackEveryField) {
  const SegmentList list = segment_list(3);
  EXPECT_EQ(read_segment_list(segment_list_message(list)), list);
}

TEST(SegmentListMessage, CannotBeCutShort) {
  const Bytes whole = segment_list_message(segment_list(3));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW((void)read_segment_list(ByteView(whole).first(size)), DataError) << size;
  }
}

}  // namespace
}  // namespace cleave::recording
