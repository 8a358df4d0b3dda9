// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/pipeline/in_order_publisher.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <random>
#include <thread>
#include <vector>

namespace cleave::service {
namespace {

struct Collected {
  std::vector<int> results;
  InOrderPublisher<int> order{64, [this](int& result) { results.push_back(result); }};
};

TEST(InOrderPublisher, PublishesAtOnceWhatIsNext) {
  Collected collected;
  const auto ticket = collected.order.draw();

  collected.order.complete(ticket, 7);

  EXPECT_EQ(collected.results, (std::vector{7}));
}

TEST(InOrderPublisher, HoldsBackAResultUntilAllBeforeItAreOut) {
  Collected collected;
  const auto first = collected.order.draw();
  const auto second = collected.order.draw();
  const auto third = collected.order.draw();

  collected.order.complete(third, 3);
  collected.order.complete(second, 2);
  EXPECT_TRUE(collected.results.empty());
  collected.order.complete(first, 1);

  EXPECT_EQ(collected.results, (std::vector{1, 2, 3}));
}

TEST(InOrderPublisher, DoesNotWaitForASkippedFrame) {
  Collected collected;
  const auto first = collected.order.draw();
  const auto second = collected.order.draw();
  const auto third = collected.order.draw();

  collected.order.complete(third, 3);
  collected.order.skip(first);
  EXPECT_TRUE(collected.results.empty());
  collected.order.skip(second);

  EXPECT_EQ(collected.results, (std::vector{3}));
}

TEST(InOrderPublisher, GivesOutNoMoreTicketsThanItsCapacity) {
  InOrderPublisher<int> order(2, [](int&) {});
  const auto first = order.draw();
  (void)order.draw();
  auto third = std::async(std::launch::async, [&] { return order.draw(); });

  EXPECT_EQ(third.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout);
  order.complete(first, 1);
  EXPECT_EQ(third.get(), 2U);
}

// Tickets are drawn ahead, then finished by threads in a random order, a tenth of them skipped.
class InOrderPublisherThreads : public testing::TestWithParam<int> {};

TEST_P(InOrderPublisherThreads, KeepTheOrderWhoeverFinishesFirst) {
  constexpr int frames = 1000;
  constexpr int block = 50;
  std::vector<int> published;
  InOrderPublisher<int> order(block, [&](int& frame) { published.push_back(frame); });
  std::vector<int> expected;
  std::mt19937 random(42);
  for (int begin = 0; begin < frames; begin += block) {
    std::vector<int> shuffled;
    for (int frame = begin; frame < begin + block; ++frame) {
      EXPECT_EQ(order.draw(), static_cast<std::uint64_t>(frame));
      if (frame % 10 != 3) expected.push_back(frame);
      shuffled.push_back(frame);
    }
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < GetParam(); ++i) {
      threads.emplace_back([&] {
        for (std::size_t j = next++; j < shuffled.size(); j = next++) {
          const auto ticket = static_cast<std::uint64_t>(shuffled[j]);
          if (ticket % 10 == 3) {
            order.skip(ticket);
          } else {
            order.complete(ticket, shuffled[j]);
          }
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
  }

  EXPECT_EQ(published, expected);
}

INSTANTIATE_TEST_SUITE_P(Counts, InOrderPublisherThreads, testing::Values(1, 2, 4));

}  // namespace
}  // namespace cleave::service
