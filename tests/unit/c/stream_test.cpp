// SPDX-License-Identifier: BSD-3-Clause
#include "tests/unit/c/c_stream.hpp"

namespace cleave {
namespace {

using OfC = test::CStream;

TEST_F(OfC, IsOneAProcessAtATime) {
  const cleave_options options = test::c_options();
  cleave_stream* second = nullptr;
  EXPECT_EQ(cleave_open(&options, &second), CLEAVE_FAILED);
  EXPECT_EQ(second, nullptr);
  EXPECT_STREQ(cleave_error(),
               "this process has a stream already: use that one, or close it and all that was "
               "opened or taken from it");
  cleave_close(stream_);
  EXPECT_EQ(cleave_open(&options, &stream_), CLEAVE_OK);
}

TEST_F(OfC, SaysWhyItDoesNotUseSharedMemory) {
  const char* reason = nullptr;
  EXPECT_EQ(cleave_uses_shared_memory(stream_, &reason), 0);
  EXPECT_STREQ(reason, "switched off by configuration");
  EXPECT_EQ(cleave_uses_shared_memory(stream_, nullptr), 0);
}

TEST(CStreamOptions, AreRefusedByNameWhereTheyCannotBe) {
  cleave_stream* stream = nullptr;
  for (const std::int32_t domain : {-2, 100}) {
    const cleave_options options{domain, 0, nullptr};
    EXPECT_EQ(cleave_open(&options, &stream), CLEAVE_BAD_ARGUMENT);
    EXPECT_NE(std::string(cleave_error()).find(std::to_string(domain)), std::string::npos);
  }
  const cleave_options no_name{20, 0, "a\"/><"};
  EXPECT_EQ(cleave_open(&no_name, &stream), CLEAVE_BAD_ARGUMENT);
  const cleave_options not_there{20, 0, "nosuch0"};
  EXPECT_EQ(cleave_open(&not_there, &stream), CLEAVE_FAILED);
  EXPECT_NE(std::string(cleave_error()).find("nosuch0"), std::string::npos);
  EXPECT_EQ(stream, nullptr);
}

}  // namespace
}  // namespace cleave
