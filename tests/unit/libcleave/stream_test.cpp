// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

#include "libcleave/discovery.hpp"
#include "libcleave/reader.hpp"
#include "libcleave/stream.hpp"
#include "libcleave/wait_set.hpp"
#include "libcleave/writer.hpp"
#include "tests/unit/libcleave/test_stream.hpp"

namespace cleave {
namespace {

using test::eventually;

class NetworkStream : public testing::Test {
 protected:
  Stream stream_{test::network_options()};
  std::string sensor_ = test::sensor_name();
};

TEST_F(NetworkStream, SaysWhyItUsesTheNetwork) {
  EXPECT_EQ(stream_.transport(), Transport::network);
  EXPECT_EQ(stream_.transport_reason(), "switched off by configuration");
}

TEST_F(NetworkStream, DeliversALoanedCloudUnchangedAndSaysThatItWasCopied) {
  Writer<DepthCloud> writer(stream_, sensor_);
  Reader<DepthCloud> reader(stream_, sensor_);
  ASSERT_TRUE(eventually([&] { return writer.matched_readers() == 1; }));
  ASSERT_TRUE(eventually([&] { return reader.live_writers() == 1; }));

  auto loan = writer.loan();
  ASSERT_TRUE(loan);
  (*loan)->header = FrameHeader{};
  (*loan)->header.frame_id = 7;
  (*loan)->xyz[0] = 1.5F;
  (*loan)->xyz[921599] = -2.5F;
  ASSERT_TRUE(writer.publish(std::move(*loan)));

  std::optional<Sample<DepthCloud>> sample;
  ASSERT_TRUE(eventually([&] { return (sample = reader.take()).has_value(); }));
  EXPECT_EQ((*sample)->header.frame_id, 7U);
  EXPECT_EQ((*sample)->xyz[0], 1.5F);
  EXPECT_EQ((*sample)->xyz[921599], -2.5F);
  EXPECT_FALSE(sample->zero_copy());
  EXPECT_FALSE(writer.zero_copy());
}

TEST_F(NetworkStream, ReusesALoanThatWasGivenBackUnused) {
  Writer<LabelMap> writer(stream_, sensor_);
  const LabelMap* first = nullptr;
  {
    auto loan = writer.loan();
    first = &**loan;
  }
  auto again = writer.loan();
  EXPECT_EQ(&**again, first);
}

TEST_F(NetworkStream, KeepsTheNewestSamplesOfItsHistory) {
  Writer<LabelMap> writer(stream_, sensor_);
  Reader<LabelMap> reader(stream_, sensor_);
  ASSERT_TRUE(eventually([&] { return writer.matched_readers() == 1; }));
  for (std::uint64_t id = 1; id <= 5; ++id) {
    auto loan = writer.loan();
    (*loan)->header = FrameHeader{};
    (*loan)->header.frame_id = id;
    ASSERT_TRUE(writer.publish(std::move(*loan)));
  }
  std::optional<Sample<LabelMap>> sample;
  ASSERT_TRUE(eventually([&] { return (sample = reader.take()).has_value(); }));
  EXPECT_EQ((*sample)->header.frame_id, 4U);
  ASSERT_TRUE(eventually([&] { return (sample = reader.take()).has_value(); }));
  EXPECT_EQ((*sample)->header.frame_id, 5U);
  EXPECT_FALSE(reader.take());
}

TEST_F(NetworkStream, ForgetsAWriterThatIsGone) {
  Reader<SegmentList> reader(stream_, sensor_);
  {
    const Writer<SegmentList> writer(stream_, sensor_);
    ASSERT_TRUE(eventually([&] { return reader.live_writers() == 1; }));
  }
  EXPECT_TRUE(eventually([&] { return reader.live_writers() == 0; }));
}

TEST_F(NetworkStream, WakesAWaitFromAnotherThread) {
  const Reader<SegmentList> reader(stream_, sensor_);
  WaitSet wait_set;
  wait_set.attach(reader);
  std::thread waker([&] { wait_set.wake(); });
  EXPECT_TRUE(wait_set.wait(std::chrono::seconds(30)));
  waker.join();
  EXPECT_FALSE(wait_set.wait(std::chrono::milliseconds(1)));  // one wake ends one wait
}

TEST_F(NetworkStream, EndsAWaitWhenASampleArrives) {
  Writer<SegmentList> writer(stream_, sensor_);
  Reader<SegmentList> reader(stream_, sensor_);
  WaitSet wait_set;
  wait_set.attach(reader);
  ASSERT_TRUE(eventually([&] { return writer.matched_readers() == 1; }));
  ASSERT_TRUE(writer.publish(SegmentList{}));
  EXPECT_TRUE(wait_set.wait(std::chrono::seconds(30)));
  EXPECT_TRUE(reader.take());
}

TEST_F(NetworkStream, DoesNotDiscoverItself) {
  const Writer<SegmentList> writer(stream_, sensor_);
  for (const Endpoint& endpoint : discover(stream_, std::chrono::milliseconds(50))) {
    EXPECT_NE(endpoint.topic, segments_topic(sensor_));
  }
}

TEST(StreamOptions, TakeTheDomainFromTheEnvironment) {
  ::setenv("CLEAVE_DOMAIN", "42", 1);
  EXPECT_EQ(with_environment({}).domain, 42U);
  for (const char* wrong : {"", "100", "-1", "4x", "99999999999"}) {
    ::setenv("CLEAVE_DOMAIN", wrong, 1);
    EXPECT_THROW((void)with_environment({}), std::invalid_argument) << wrong;
  }
  ::unsetenv("CLEAVE_DOMAIN");
  EXPECT_EQ(with_environment({}).domain, 0U);
}

TEST(StreamOptions, RefuseAnInterfaceThatDoesNotExistAndNameIt) {
  StreamOptions options = test::network_options();
  options.public_interface = "nosuch0";
  try {
    const Stream stream(options);
    FAIL() << "joined on an interface that does not exist";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("nosuch0"), std::string::npos);
  }
}

}  // namespace
}  // namespace cleave
