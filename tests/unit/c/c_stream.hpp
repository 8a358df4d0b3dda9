// SPDX-License-Identifier: BSD-3-Clause
// A stream through the C interface, over the network path, and what its tests share.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>

#include <array>
#include <cstdint>
#include <string>

#include "c/cleave.h"
#include "c/handles.hpp"
#include "tests/unit/libcleave/test_stream.hpp"

namespace cleave::test {

inline cleave_options c_options() {
  return {static_cast<std::int32_t>(network_options().domain), 0, nullptr};
}

inline bool is_readable(int descriptor) {
  pollfd entry{descriptor, POLLIN, 0};
  return ::poll(&entry, 1, 0) == 1;
}

class CStream : public testing::Test {
 protected:
  CStream() {
    const cleave_options options = c_options();
    EXPECT_EQ(cleave_open(&options, &stream_), CLEAVE_OK) << cleave_error();
  }
  ~CStream() override {
    cleave_close(stream_);
    EXPECT_FALSE(is_open()) << "something of the stream is left open";
  }
  static bool is_open() {
    const cleave_options options = c_options();
    cleave_stream* another = nullptr;
    const bool opened = cleave_open(&options, &another) == CLEAVE_OK;
    cleave_close(another);
    return !opened;
  }
  // For what the C interface does not publish.
  [[nodiscard]] Stream& cpp_stream() const { return *stream_->stream; }

  cleave_reader* reader(cleave_kind kind) {
    cleave_reader* result = nullptr;
    EXPECT_EQ(cleave_reader_open(stream_, kind, sensor_.c_str(), 0, &result), CLEAVE_OK)
        << cleave_error();
    return result;
  }
  // Of 4 x 2 points; its principal point is pixel (1, 1).
  [[nodiscard]] cleave_camera camera() const {
    cleave_camera result{};
    result.sensor = sensor_.c_str();
    result.width = 4;
    result.height = 2;
    result.fx = result.fy = 2;
    result.cx = result.cy = 1;
    return result;
  }
  // With a reader that is matched.
  cleave_publisher* publisher() {
    const cleave_camera settings = camera();
    cleave_publisher* result = nullptr;
    EXPECT_EQ(cleave_publisher_open(stream_, &settings, &result), CLEAVE_OK) << cleave_error();
    EXPECT_TRUE(eventually([&] { return cleave_publisher_readers(result) >= 1; }));
    return result;
  }

  cleave_stream* stream_ = nullptr;
  std::string sensor_ = sensor_name();
  // 1, 2, 3, ...: x, y and z of 8 points.
  std::array<float, 24> points_ = [] {
    std::array<float, 24> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(i + 1);
    return values;
  }();
};

}  // namespace cleave::test
