// SPDX-License-Identifier: BSD-3-Clause
#include "sensor/sources/make_source.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace cleave::sensor {
namespace {

std::string refusal(const std::string& uri) {
  try {
    (void)make_source(uri, {}, {});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(MakeSource, KnowsCamerasAndFiles) {
  EXPECT_TRUE(make_source("openni2:", {}, {})->realtime());
  EXPECT_TRUE(make_source("synthetic:medium", {}, {})->realtime());
  EXPECT_FALSE(make_source("pcd:scenes", {}, {})->realtime());
  EXPECT_FALSE(make_source("oni:table.oni", {}, {})->realtime());
}

TEST(MakeSource, ListsTheSourcesForAnUnknownOne) {
  for (const char* const uri : {"", "scenes", "ros:topic", "pcd:", "synthetic:"}) {
    const std::string message = refusal(uri);
    for (const char* const known :
         {"openni2:", "synthetic:medium", "pcd:recordings", "oni:table.oni", "mcap:run.mcap"}) {
      EXPECT_NE(message.find(known), std::string::npos) << uri << ": " << message;
    }
  }
}

}  // namespace
}  // namespace cleave::sensor
