// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/frame_ledger.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <random>
#include <thread>
#include <vector>

namespace cleave::service {
namespace {

std::uint64_t dropped(const FrameLedger& ledger, DropCause cause) {
  return ledger.snapshot().dropped.at(static_cast<std::size_t>(cause));
}

void expect_balanced(const FrameCounts& counts) {
  EXPECT_EQ(counts.received,
            counts.published + counts.dropped_total() + counts.rejected_total() + counts.in_flight);
}

TEST(FrameLedger, StartsWithNothing) {
  const FrameCounts counts = FrameLedger().snapshot();

  EXPECT_EQ(counts.received, 0U);
  EXPECT_EQ(counts.in_flight, 0U);
  expect_balanced(counts);
}

TEST(FrameLedger, CountsAFrameInFlightUntilItEnds) {
  FrameLedger ledger;
  for (std::uint64_t id = 0; id < 4; ++id) (void)ledger.arrive({0, id}, id % 2 == 0);
  EXPECT_EQ(ledger.snapshot().in_flight, 4U);

  ledger.publish({0, 0});
  ledger.drop({0, 1}, DropCause::queue);
  ledger.reject({0, 2}, RejectCause::no_finite_point);

  const FrameCounts counts = ledger.snapshot();
  EXPECT_EQ(counts.received, 4U);
  EXPECT_EQ(counts.published, 1U);
  EXPECT_EQ(counts.dropped_total(), 1U);
  EXPECT_EQ(counts.rejected_total(), 1U);
  EXPECT_EQ(counts.in_flight, 1U);
  EXPECT_EQ(counts.zero_copy, 2U);
  expect_balanced(counts);
}

TEST(FrameLedger, CountsAGapInTheIdsAsDroppedInTransport) {
  FrameLedger ledger;
  (void)ledger.arrive({0, 10}, true);

  const Arrived arrived = ledger.arrive({0, 14}, true);

  EXPECT_EQ(arrived.missed, 3U);
  EXPECT_EQ(dropped(ledger, DropCause::transport), 3U);
  EXPECT_EQ(ledger.snapshot().received, 5U);
  expect_balanced(ledger.snapshot());
}

TEST(FrameLedger, MissesNothingBeforeTheFirstFrame) {
  FrameLedger ledger;

  EXPECT_EQ(ledger.arrive({3, 1000}, false).missed, 0U);
  EXPECT_EQ(ledger.snapshot().received, 1U);
}

TEST(FrameLedger, CountsAGapWhereTheEpochRisesByOne) {
  FrameLedger ledger;
  (void)ledger.arrive({7, 100}, false);

  EXPECT_EQ(ledger.arrive({8, 103}, false).missed, 2U);
  EXPECT_EQ(ledger.snapshot().received, 4U);
}

TEST(FrameLedger, StartsTheIdsAnewWithAnyOtherEpoch) {
  FrameLedger ledger;
  (void)ledger.arrive({7, 100}, false);

  for (const FrameKey first : {FrameKey{9, 500}, FrameKey{2, 0}}) {
    const Arrived arrived = ledger.arrive(first, false);
    EXPECT_EQ(arrived.arrival, Arrival::fresh);
    EXPECT_EQ(arrived.missed, 0U);
  }
  EXPECT_EQ(ledger.snapshot().received, 3U);
}

TEST(FrameLedger, IgnoresAResendOfAFrameInFlight) {
  FrameLedger ledger;
  (void)ledger.arrive({0, 1}, false);

  EXPECT_EQ(ledger.arrive({0, 1}, false).arrival, Arrival::in_flight);
  EXPECT_EQ(ledger.snapshot().received, 1U);
  EXPECT_EQ(ledger.snapshot().duplicates, 1U);
}

TEST(FrameLedger, AnswersAResendOfAPublishedFrameWithoutCountingIt) {
  FrameLedger ledger;
  (void)ledger.arrive({0, 1}, false);
  (void)ledger.arrive({0, 2}, false);
  ledger.publish({0, 1});
  ledger.publish({0, 2});

  EXPECT_EQ(ledger.arrive({0, 1}, false).arrival, Arrival::again);
  ledger.publish({0, 1});

  EXPECT_EQ(ledger.snapshot().received, 2U);
  EXPECT_EQ(ledger.snapshot().published, 2U);
  EXPECT_EQ(ledger.snapshot().duplicates, 1U);
}

TEST(FrameLedger, TakesBackTheDropOfAFrameThatComesAfterAll) {
  FrameLedger ledger;
  (void)ledger.arrive({0, 1}, false);
  (void)ledger.arrive({0, 4}, false);
  ledger.drop({0, 4}, DropCause::no_free_chunk);
  EXPECT_EQ(ledger.snapshot().dropped_total(), 3U);

  for (const std::uint64_t id : {2, 3, 4}) {
    EXPECT_EQ(ledger.arrive({0, id}, false).arrival, Arrival::fresh);
    ledger.publish({0, id});
  }

  EXPECT_EQ(ledger.snapshot().received, 4U);
  EXPECT_EQ(ledger.snapshot().dropped_total(), 0U);
  EXPECT_EQ(ledger.snapshot().published, 3U);
  expect_balanced(ledger.snapshot());
}

TEST(FrameLedger, SurvivesTheLargestGapThatAHeaderCanClaim) {
  FrameLedger ledger;
  (void)ledger.arrive({0, 0}, false);

  (void)ledger.arrive({0, std::numeric_limits<std::uint64_t>::max()}, false);

  expect_balanced(ledger.snapshot());
}

TEST(FrameLedger, BalancesInEverySnapshotWhileThreadsChangeIt) {
  FrameLedger ledger;
  std::atomic<bool> done{false};
  std::thread reader([&] {
    while (!done) expect_balanced(ledger.snapshot());
  });
  std::vector<std::thread> writers;
  for (std::uint32_t epoch = 0; epoch < 3; ++epoch) {
    writers.emplace_back([&ledger, epoch] {
      std::mt19937 random(epoch);
      std::uint64_t id = 0;
      for (int i = 0; i < 3000; ++i) {
        id += random() % 3;  // 0: a resend, 2: a gap
        (void)ledger.arrive({epoch, id}, random() % 2 == 0);
        switch (random() % 4) {
          case 0:
            ledger.publish({epoch, id});
            break;
          case 1:
            ledger.drop({epoch, id}, DropCause::queue);
            break;
          case 2:
            ledger.reject({epoch, id}, RejectCause::bad_size);
            break;
          default:
            ledger.publish({epoch, id - random() % 2});
            break;
        }
      }
    });
  }
  for (std::thread& writer : writers) writer.join();
  done = true;
  reader.join();

  expect_balanced(ledger.snapshot());
}

}  // namespace
}  // namespace cleave::service
