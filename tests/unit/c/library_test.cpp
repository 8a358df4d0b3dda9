// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <new>
#include <stdexcept>
#include <string>
#include <thread>

#include "c/cleave.h"
#include "c/errors.hpp"
#include "libcleave/cdr.hpp"

namespace cleave {
namespace {

TEST(CLibrary, TellsItsVersions) {
  EXPECT_EQ(cleave_abi_version(), CLEAVE_ABI_VERSION);
  EXPECT_NE(std::string(cleave_version()).find(" (contract cleave_v1, C ABI 1)"),
            std::string::npos);
}

TEST(CLibrary, NamesOutcomesAndStates) {
  EXPECT_STREQ(cleave_outcome_name(0), "segmented");
  EXPECT_STREQ(cleave_outcome_name(cleave_v1_OUTCOME_REJECTED_WRONG_UNIT), "wrong unit");
  EXPECT_STREQ(cleave_outcome_name(7), "unknown");
  EXPECT_STREQ(cleave_outcome_name(0xFFFFFFFFU), "unknown");
  EXPECT_STREQ(cleave_state_name(cleave_v1_STATE_SOURCE_LOST), "source lost");
  EXPECT_STREQ(cleave_state_name(0xFFFFFFFFU), "unknown");
}

// What is thrown behind the boundary, and what the caller gets.
template <class Exception>
cleave_result result_of(const Exception& exception) {
  return c::guarded([&]() -> cleave_result { throw exception; });
}

TEST(CLibrary, TurnsEveryExceptionIntoACodeAndAText) {
  EXPECT_EQ(result_of(std::invalid_argument("a name")), CLEAVE_BAD_ARGUMENT);
  EXPECT_STREQ(cleave_error(), "a name");
  EXPECT_EQ(result_of(std::bad_alloc()), CLEAVE_NO_MEMORY);
  EXPECT_EQ(result_of(CdrError("cut off")), CLEAVE_BAD_DATA);
  EXPECT_STREQ(cleave_error(), "cut off");
  EXPECT_EQ(result_of(c::Failure(CLEAVE_TIMEOUT, "late")), CLEAVE_TIMEOUT);
  EXPECT_EQ(result_of(std::runtime_error("DDS")), CLEAVE_FAILED);
  EXPECT_EQ(result_of(42), CLEAVE_FAILED);
  EXPECT_STREQ(cleave_error(), "an unknown exception");
}

TEST(CLibrary, KeepsAnErrorForEachThread) {
  (void)c::fail(CLEAVE_FAILED, "of this thread");
  std::string other = "not asked";
  std::thread([&] { other = cleave_error(); }).join();
  EXPECT_EQ(other, "");
  EXPECT_STREQ(cleave_error(), "of this thread");
}

TEST(CLibrary, CutsATextThatIsTooLong) {
  (void)c::fail(CLEAVE_FAILED, std::string(5000, 'x'));
  EXPECT_EQ(cleave_error(), std::string(1023, 'x'));
}

}  // namespace
}  // namespace cleave
