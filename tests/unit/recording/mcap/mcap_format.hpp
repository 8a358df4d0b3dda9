// SPDX-License-Identifier: BSD-3-Clause
// A file of McapBytes, as it is read and as recover() copies it.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "recording/mcap/reader.hpp"
#include "recording/mcap/recover.hpp"
#include "tests/unit/recording/mcap/mcap_bytes.hpp"
#include "tests/unit/recording/recording_files.hpp"

namespace cleave::recording {

using Numbers = std::vector<std::uint32_t>;

class McapFormat : public testing::Test {
 protected:
  // What is read of a file with these bytes, in this order.
  Numbers read(const McapBytes& bytes, Order order = Order::file) {
    write_all(file_, bytes.bytes());
    McapReader reader(file_, order);
    Numbers numbers;
    while (const auto message = reader.next()) numbers.push_back(message->sequence);
    reader.check_attachments();
    reader.check_totals(numbers.size());
    contents_ = reader.contents();
    return numbers;
  }

  // What is read after recover() has copied it.
  Numbers read_recovered(const McapBytes& bytes) {
    write_all(file_, bytes.bytes());
    recovery_ = recover(file_, copy_);
    McapReader reader(copy_, Order::file);
    Numbers numbers;
    while (const auto message = reader.next()) numbers.push_back(message->sequence);
    reader.check_attachments();
    reader.check_totals(numbers.size());
    EXPECT_TRUE(reader.problems().empty()) << reader.problems().front();
    EXPECT_TRUE(reader.contents().closed);
    contents_ = reader.contents();
    return numbers;
  }

  void expect_whole() const {
    EXPECT_TRUE(contents_.closed);
    EXPECT_TRUE(contents_.problems.empty()) << contents_.problems.texts().front();
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.path() / "a.mcap";
  const std::filesystem::path copy_ = folder_.path() / "copy.mcap";
  Contents contents_;
  Recovery recovery_;
};

}  // namespace cleave::recording
