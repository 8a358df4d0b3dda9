// SPDX-License-Identifier: BSD-3-Clause
// Clouds go from process to process without a copy; without RouDi they go all the same. Each half
// counts its own large copies, and the test itself joins nothing: RouDi ends whoever joined it.
#include <gtest/gtest.h>

#include "tests/integration/support/process.hpp"
#include "tests/integration/support/roudi_fixture.hpp"

namespace cleave::test {
namespace {

struct Outputs {
  std::string publisher, receiver;
};

Outputs pass_30_clouds(const std::string& transport) {
  const std::map<std::string, std::string> domain = {{"CLEAVE_DOMAIN", "7"}};
  Process receiver({program("cloud_receiver"), transport, "zero_copy"}, domain);
  Process publisher({program("cloud_publisher"), transport, "zero_copy"}, domain);
  EXPECT_EQ(publisher.wait(), 0) << publisher.log();
  EXPECT_EQ(receiver.wait(), 0) << receiver.log();
  return {publisher.output(), receiver.output()};
}

TEST(ZeroCopy, ThirtyCloudsPassThroughSharedMemoryWithoutACopyOf100KilobytesOrMore) {
  const RouDi roudi;
  const Outputs outputs = pass_30_clouds("shared");
  EXPECT_EQ(outputs.publisher, "in_shared_mapping 1 copies 0\n");
  EXPECT_EQ(outputs.receiver, "clouds 30 intact 30 zero_copy 30 in_shared_mapping 30 copies 0\n");
}

TEST(ZeroCopy, ThirtyCloudsPassOverTheNetworkWithoutRouDiAndTheCopiesAreCounted) {
  const Outputs outputs = pass_30_clouds("network");
  EXPECT_EQ(outputs.publisher.find("in_shared_mapping 0 copies "), 0U) << outputs.publisher;
  EXPECT_EQ(outputs.receiver.find("clouds 30 intact 30 zero_copy 0 in_shared_mapping 0 copies "),
            0U)
      << outputs.receiver;
  EXPECT_EQ(outputs.receiver.find("copies 0\n"), std::string::npos) << "the counter does not count";
}

}  // namespace
}  // namespace cleave::test
