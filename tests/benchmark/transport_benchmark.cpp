// SPDX-License-Identifier: BSD-3-Clause
// Publication to a reader's hands for a full cloud (3.7 MB): libcleave, in C++ and from Python,
// beside bare Cyclone DDS, in one run, in turns, so that the machine's load meets all alike. Real
// processes and a RouDi of its own. Usage: benchmark_transport [READERS...], default 1
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/support/process.hpp"
#include "tests/integration/support/roudi_fixture.hpp"

namespace {

using namespace cleave::test;

constexpr int rounds = 5;
constexpr int clouds = 150;  // a round
constexpr std::chrono::minutes round_patience{2};
constexpr double us_per_ns = 1e-3;

using Command = std::vector<std::string>;

// Who writes and who reads: the first words of their commands.
struct Pair {
  std::string title;
  Command write;
  Command read;
};

// The C library is the build's, the package the checkout's.
const std::map<std::string, std::string> environment = {{"CLEAVE_DOMAIN", "21"},
                                                        {"CLEAVE_LIBRARY", CLEAVE_C_LIBRARY},
                                                        {"PYTHONPATH", PYTHON_PACKAGE},
                                                        {"PYTHONDONTWRITEBYTECODE", "1"}};

Command operator+(Command command, const Command& words) {
  command.insert(command.end(), words.begin(), words.end());
  return command;
}

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
void add_round(const Pair& pair, unsigned readers, Measured& measured) {
  const std::string count = std::to_string(clouds);
  std::vector<Process> reading;
  for (unsigned i = 0; i < readers; ++i) {
    reading.emplace_back(pair.read + Command{"read", count}, environment);
  }
  Process writing(pair.write + Command{"write", std::to_string(readers), count}, environment);
  if (writing.wait(round_patience) != 0)
    throw std::runtime_error(pair.title + ": " + writing.log());
  for (Process& reader : reading) {
    if (reader.wait(round_patience) != 0)
      throw std::runtime_error(pair.title + ": " + reader.log());
    std::istringstream lines(reader.output());
    for (double latency_ns = 0; lines >> latency_ns;) {
      measured.latencies_us.push_back(latency_ns * us_per_ns);
    }
    measured.expected += clouds;
  }
}

void print(const std::string& title, unsigned readers, Measured& measured) {
  std::printf("%-10s %7u %12.0f %10.0f %10.0f %9zu\n", title.c_str(), readers,
              measured.percentile(0.5), measured.percentile(0.9), measured.percentile(0.99),
              measured.expected - measured.latencies_us.size());
}

void compare(unsigned readers) {
  const Command cleave = {program("transport_cleave")};
  const Command bare = {program("transport_bare")};
  const std::vector<Pair> pairs = {{"libcleave", cleave, cleave},
                                   {"Python", cleave, {TRANSPORT_PYTHON}},
                                   {"bare DDS", bare, bare}};
  std::vector<Measured> measured(pairs.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < pairs.size(); ++i) add_round(pairs[i], readers, measured[i]);
  }
  const double ours = measured.front().percentile(0.5);
  for (std::size_t i = 0; i < pairs.size(); ++i) print(pairs[i].title, readers, measured[i]);
  std::printf("medians, %u reader%s: libcleave %.2f of bare DDS, Python %.2f of libcleave\n",
              readers, readers == 1 ? "" : "s", ours / measured[2].percentile(0.5),
              measured[1].percentile(0.5) / ours);
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
