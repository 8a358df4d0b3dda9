// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/view/storage_order.hpp"

#include <gtest/gtest.h>

#include <set>

#include "stored_scene.hpp"

namespace cleave::segmentation {
namespace {

TEST(StorageOrder, FindsEveryStoredPixelOnce) {
  for (const StorageOrder& order : all_storage_orders()) {
    const UprightImage image(order, 5, 3);
    std::set<std::size_t> found;
    for (std::uint32_t row = 0; row < image.height(); ++row) {
      for (std::uint32_t column = 0; column < image.width(); ++column) {
        found.insert(image.index(column, row));
      }
    }
    EXPECT_EQ(image.width() * image.height(), 15U);
    EXPECT_EQ(found.size(), 15U);
    EXPECT_EQ(*found.rbegin(), 14U);
  }
}

TEST(StorageOrder, TurnsRectanglesAsItTurnsPixels) {
  for (const StorageOrder& order : all_storage_orders()) {
    const UprightImage image(order, 5, 3);
    const ImageRectangle stored = image.stored({1, 0, 2, 1});
    EXPECT_EQ(stored.right - stored.left, 1U);
    EXPECT_EQ(stored.bottom - stored.top, 1U);
    EXPECT_EQ(std::size_t{stored.top} * 5 + stored.left, image.index(1, 0));
  }
}

}  // namespace
}  // namespace cleave::segmentation
