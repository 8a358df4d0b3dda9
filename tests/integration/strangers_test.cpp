// SPDX-License-Identifier: BSD-3-Clause
// What others put on the bus: named, limited, and survived.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "libcleave/sequence.hpp"
#include "libcleave/writer.hpp"
#include "tests/integration/support/daemons.hpp"
#include "tests/integration/support/monitor.hpp"
#include "tests/integration/support/small_clouds.hpp"

namespace cleave::test {
namespace {

constexpr std::uint32_t strangers_domain = 16;

std::size_t lines_with(const std::string& log, const std::string& text) {
  std::istringstream lines(log);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) count += line.find(text) != line.npos ? 1 : 0;
  return count;
}

// The domain's ports for discovery and data of the first participants, and those of the bulk
// domain.
std::vector<std::uint16_t> dds_ports() {
  std::vector<std::uint16_t> ports;
  for (const std::uint32_t domain : {strangers_domain, strangers_domain + 100}) {
    for (std::uint32_t i = 10; i < 20; ++i) {
      ports.push_back(static_cast<std::uint16_t>(7400 + 250 * domain + i));
    }
  }
  return ports;
}

class Attacker {
 public:
  Attacker() : descriptor_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  ~Attacker() { ::close(descriptor_); }
  Attacker(const Attacker&) = delete;
  Attacker& operator=(const Attacker&) = delete;

  void send(const std::vector<std::uint8_t>& datagram, std::uint16_t port) const {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    (void)::sendto(descriptor_, datagram.data(), datagram.size(), 0,
                   reinterpret_cast<const sockaddr*>(&to), sizeof to);
  }

 private:
  int descriptor_;
};

// A header of RTPS 2.1 and submessages of random kinds whose lengths mostly fit; some bytes are
// then changed, some datagrams cut off.
std::vector<std::uint8_t> mutated_datagram(std::mt19937& random) {
  static constexpr std::array<std::uint8_t, 20> header = {'R', 'T', 'P', 'S', 2, 1, 1,
                                                          16,  1,   2,   3,   4, 5};
  static constexpr std::array<std::uint8_t, 12> kinds = {1,   6,   7,   8,    9,    0xc,
                                                         0xd, 0xe, 0xf, 0x12, 0x15, 0x16};
  std::vector<std::uint8_t> bytes(header.begin(), header.end());
  for (auto count = 1 + random() % 3; count > 0; --count) {
    const auto length = static_cast<std::uint16_t>(4 * (random() % 40));
    bytes.insert(
        bytes.end(),
        {kinds.at(random() % kinds.size()), static_cast<std::uint8_t>(random() % 8 | 1U),
         static_cast<std::uint8_t>(length & 0xffU), static_cast<std::uint8_t>(length >> 8U)});
    // Small numbers hit entities and sequence numbers that exist.
    for (unsigned i = 0; i < length; ++i) {
      bytes.push_back(static_cast<std::uint8_t>(random() % 4 == 0 ? random() : random() % 4));
    }
  }
  if (random() % 4 == 0) bytes.at(random() % bytes.size()) = static_cast<std::uint8_t>(random());
  if (random() % 8 == 0) bytes.resize(random() % bytes.size());
  return bytes;
}

class Strangers : public testing::Test {
 protected:
  void SetUp() override {
    write_pcd(folder_.path() / "a.pcd", 80, 60);
    ASSERT_TRUE(segmenter_.logs("ready")) << segmenter_.log();
    camera_.emplace(daemons_.grabber("pcd:" + folder_.path().string(), {"--loop"}));
    ASSERT_TRUE(segments_flow()) << segmenter_.log();
  }
  bool segments_flow() { return monitor_.lists_flow(10); }
  [[nodiscard]] Process status() const { return daemons_.run("cleave", {"status"}); }

  TemporaryFolder folder_;
  Daemons daemons_{strangers_domain, false};
  Monitor monitor_{strangers_domain, "camera"};
  Process segmenter_ = daemons_.segmenter();
  std::optional<Process> camera_;
};

TEST_F(Strangers, AreNotSeenWhereThereAreNone) {
  Process shown = status();
  EXPECT_EQ(shown.wait(), 0) << shown.log();
  EXPECT_EQ(shown.output().find("Stranger"), std::string::npos) << shown.output();
}

TEST_F(Strangers, WhoPublishASensorsListsBesideItsSegmenterAreNamed) {
  const Writer<SegmentList> impostor(monitor_.stream(), "camera");
  Process shown = status();
  EXPECT_EQ(shown.wait(), 0) << shown.log();
  const std::string me = "(" + std::to_string(::getpid()) +
                         ") publishes cleave/camera/segments "
                         "and is not its segmenter, which is process " +
                         std::to_string(segmenter_.id());
  EXPECT_NE(shown.output().find(me), std::string::npos) << shown.output();
  EXPECT_NE(shown.output().find("2 programs publish cleave/camera/segments"), std::string::npos)
      << shown.output();
}

TEST_F(Strangers, ListsOfMoreThan4MBReachNobody) {
  Process echo = daemons_.run("cleave", {"echo", "--sensor", "flooded", "--no-shared-memory"});
  Writer<SegmentList> writer(monitor_.stream(), "flooded");
  ASSERT_TRUE(eventually([&] { return writer.matched_readers() == 1; })) << echo.log();
  SegmentList list{};
  std::vector<SegmentMessage> segments(20'000'000 / sizeof(SegmentMessage));
  lend(list.segments, segments);
  for (int i = 0; i < 3; ++i) (void)writer.publish(list);
  segments.resize(3);
  lend(list.segments, segments);
  list.header.frame_id = 7;
  ASSERT_TRUE(eventually([&] {
    (void)writer.publish(list);
    return echo.output().find("3 segments") != std::string::npos;
  })) << echo.output()
      << echo.log();
  EXPECT_EQ(echo.output().find("frame 0 "), std::string::npos) << "a large one came";
  EXPECT_TRUE(segments_flow()) << segmenter_.log();
}

TEST_F(Strangers, WhoSendMutatedDatagramsToAllPortsKillNobodyAndFillNoLog) {
  const char* const wanted = std::getenv("CLEAVE_FUZZ_DATAGRAMS");
  const int count = wanted != nullptr ? std::stoi(wanted) : 10'000;
  const std::vector<std::uint16_t> ports = dds_ports();
  const Attacker attacker;
  std::mt19937 random(1);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < count; ++i) {
    attacker.send(mutated_datagram(random), ports.at(random() % ports.size()));
  }
  EXPECT_TRUE(segments_flow()) << segmenter_.log() << camera_->log();
  EXPECT_TRUE(segmenter_.running()) << segmenter_.log();
  EXPECT_TRUE(camera_->running()) << camera_->log();
  const auto seconds =
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now() - begin)
          .count();
  EXPECT_GE(lines_with(segmenter_.log(), "DDS:"), 1U)
      << "the datagrams arrive, and are complained of";
  EXPECT_LE(lines_with(segmenter_.log(), "DDS:"), static_cast<std::size_t>(seconds) + 2);
}

}  // namespace
}  // namespace cleave::test
