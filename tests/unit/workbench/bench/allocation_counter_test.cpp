// SPDX-License-Identifier: BSD-3-Clause
#include "workbench/bench/allocation_counter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

namespace cleave::workbench {
namespace {

// So that the compiler cannot leave an allocation out.
void* volatile seen_by_all = nullptr;
void* keep(void* memory) {
  seen_by_all = memory;
  return memory;
}

class AllocationCounter : public testing::Test {
 protected:
  void SetUp() override {
    if (!allocations_of_this_thread()) GTEST_SKIP() << "a sanitizer has replaced malloc";
  }

  template <class Work>
  static std::uint64_t counted(const Work& work) {
    const std::uint64_t before = *allocations_of_this_thread();
    work();
    return *allocations_of_this_thread() - before;
  }
};

TEST_F(AllocationCounter, CountsEveryWayToAskForMemory) {
  EXPECT_EQ(counted([] { std::free(keep(std::malloc(100))); }), 1U);
  EXPECT_EQ(counted([] { std::free(keep(std::calloc(3, 100))); }), 1U);
  EXPECT_EQ(counted([] { std::free(keep(std::realloc(nullptr, 100))); }), 1U);
  EXPECT_EQ(counted([] { std::free(keep(std::aligned_alloc(64, 128))); }), 1U);
  EXPECT_EQ(counted([] {
              void* memory = nullptr;
              ASSERT_EQ(posix_memalign(&memory, 64, 100), 0);
              std::free(keep(memory));
            }),
            1U);
  EXPECT_EQ(counted([] { (void)keep(std::make_unique<int>(3).get()); }), 1U);
  EXPECT_EQ(counted([] { (void)keep(std::vector<double>(1000).data()); }), 1U);
  EXPECT_EQ(counted([] { (void)keep(Eigen::MatrixXd(100, 100).data()); }), 1U);
}

TEST_F(AllocationCounter, CountsNothingWhereMemoryIsReused) {
  std::vector<double> values;
  values.reserve(1000);

  EXPECT_EQ(counted([&] { values.assign(1000, 1.0); }), 0U);
}

TEST_F(AllocationCounter, LeavesOtherThreadsOut) {
  std::uint64_t of_other = 0;
  std::uint64_t here = 0;
  std::thread other([&] {
    of_other = counted([] {
      for (int i = 0; i < 500; ++i) std::free(keep(std::malloc(10)));
    });
  });
  here = counted([&] { other.join(); });

  EXPECT_EQ(of_other, 500U);
  EXPECT_LT(here, 10U);
}

}  // namespace
}  // namespace cleave::workbench
