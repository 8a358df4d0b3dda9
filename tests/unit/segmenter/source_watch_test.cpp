// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/source_watch.hpp"

#include <gtest/gtest.h>

namespace cleave::service {
namespace {

TEST(SourceWatch, IsStartingUntilTheFirstWriterComes) {
  SourceWatch watch;

  EXPECT_FALSE(watch.update(0));
  EXPECT_EQ(watch.state(), NodeState::starting);
}

TEST(SourceWatch, RunsWhileAWriterIsAlive) {
  SourceWatch watch;

  EXPECT_TRUE(watch.update(1));
  EXPECT_FALSE(watch.update(2));
  EXPECT_EQ(watch.state(), NodeState::running);
}

TEST(SourceWatch, LosesItsSourceAndFindsItAgain) {
  SourceWatch watch;
  (void)watch.update(1);

  EXPECT_TRUE(watch.update(0));
  EXPECT_EQ(watch.state(), NodeState::source_lost);
  EXPECT_FALSE(watch.update(0));
  EXPECT_TRUE(watch.update(1));
  EXPECT_EQ(watch.state(), NodeState::running);
}

}  // namespace
}  // namespace cleave::service
