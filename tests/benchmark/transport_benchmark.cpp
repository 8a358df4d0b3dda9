// SPDX-License-Identifier: BSD-3-Clause
// Publication to a reader's hands for a full cloud (3.7 MB): libcleave beside bare Cyclone DDS, in
// one run, in turns, so that the machine's load meets both alike. Real processes and a RouDi of its
// own. Usage: benchmark_transport [READERS...], default 1
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <vector>

#include "tests/integration/support/process.hpp"
#include "tests/integration/support/roudi_fixture.hpp"

namespace {

using namespace cleave::test;

constexpr int rounds = 5;
constexpr int clouds = 150;  // a round
constexpr std::chrono::minutes round_patience{2};
constexpr double us_per_ns = 1e-3;

struct Measured {
  std::vector<double> latencies_us;
  std::size_t expected = 0;

  [[nodiscard]] double percentile(double share) {
    if (latencies_us.empty()) return 0;
    std::sort(latencies_us.begin(), latencies_us.end());
    return latencies_us.at(
        static_cast<std::size_t>(share * static_cast<double>(latencies_us.size() - 1)));
  }
};

// One round: a writer and so many readers, each a process.
void add_round(const std::string& name, unsigned readers, Measured& measured) {
  const std::map<std::string, std::string> domain = {{"CLEAVE_DOMAIN", "21"}};
  const std::string count = std::to_string(clouds);
  std::vector<Process> reading;
  for (unsigned i = 0; i < readers; ++i) {
    reading.emplace_back(std::vector<std::string>{program(name), "read", count}, domain);
  }
  Process writing({program(name), "write", std::to_string(readers), count}, domain);
  if (writing.wait(round_patience) != 0) throw std::runtime_error(name + ": " + writing.log());
  for (Process& reader : reading) {
    if (reader.wait(round_patience) != 0) throw std::runtime_error(name + ": " + reader.log());
    std::istringstream lines(reader.output());
    for (double latency_ns = 0; lines >> latency_ns;) {
      measured.latencies_us.push_back(latency_ns * us_per_ns);
    }
    measured.expected += clouds;
  }
}

void print(const char* name, unsigned readers, Measured& measured) {
  std::printf("%-10s %7u %12.0f %10.0f %10.0f %9zu\n", name, readers, measured.percentile(0.5),
              measured.percentile(0.9), measured.percentile(0.99),
              measured.expected - measured.latencies_us.size());
}

void compare(unsigned readers) {
  Measured ours, bare;
  for (int round = 0; round < rounds; ++round) {
    add_round("transport_cleave", readers, ours);
    add_round("transport_bare", readers, bare);
  }
  print("libcleave", readers, ours);
  print("bare DDS", readers, bare);
  std::printf("ratio of medians, %u reader%s: %.2f\n", readers, readers == 1 ? "" : "s",
              ours.percentile(0.5) / bare.percentile(0.5));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::vector<unsigned> reader_counts;
    for (int i = 1; i < argc; ++i) {
      reader_counts.push_back(static_cast<unsigned>(std::stoul(argv[i])));
    }
    if (reader_counts.empty()) reader_counts = {1};
    const RouDi roudi;
    std::printf("transport  readers  median [us]  p90 [us]   p99 [us]      lost\n");
    for (const unsigned readers : reader_counts) compare(readers);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_transport: " << error.what() << '\n';
    return 1;
  }
}
