// SPDX-License-Identifier: BSD-3-Clause
// How the stream behaves as rate, workers, queue and cameras grow: real processes, a RouDi of its
// own, a table. See --help.
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "tests/benchmark/stream_run.hpp"
#include "tests/integration/support/roudi_fixture.hpp"

namespace {

using namespace cleave::benchmark;

constexpr unsigned seconds_a_row = 12;

constexpr char usage[] =
    "usage: benchmark_stream rates|workers|queues|cameras [SOURCE]\n"
    "  rates    30, 60, 120 and 240 frames a second, 1 worker, live: is latency flat, what drops?\n"
    "  workers  1, 2 and 3 workers at 60, 120 and 240 frames a second: throughput or latency?\n"
    "  queues   1, 2, 4 and 8 frames that may wait, at 120 and 240 frames a second\n"
    "  cameras  1, 2 and 4 cameras of 30 frames a second, each with a worker\n"
    "SOURCE is the grabbers', default synthetic:medium.\n"
    "example: benchmark_stream rates pcd:recordings\n";

std::vector<StreamSetting> rows_of(const std::string& table, const std::string& source) {
  std::vector<StreamSetting> rows;
  const auto add = [&](unsigned cameras, unsigned fps, unsigned workers, unsigned queue) {
    rows.push_back({source, cameras, fps, workers, queue});
  };
  if (table == "rates") {
    for (const unsigned fps : {30, 60, 120, 240}) add(1, fps, 1, 2);
  } else if (table == "workers") {
    for (const unsigned fps : {60, 120, 240}) {
      for (const unsigned workers : {1, 2, 3}) add(1, fps, workers, 2);
    }
  } else if (table == "queues") {
    for (const unsigned fps : {120, 240}) {
      for (const unsigned queue : {1, 2, 4, 8}) add(1, fps, 1, queue);
    }
  } else if (table == "cameras") {
    for (const unsigned cameras : {1, 2, 4}) add(cameras, 30, 1, 2);
  }
  return rows;
}

void print(const StreamSetting& setting, const StreamFigures& f) {
  std::printf("%7u %4u %7u %5u | %9.1f %9llu %7llu | %6.1f %6.1f | %7.2f %7.2f | %6.2f %6.2f |",
              setting.cameras, setting.fps, setting.workers, setting.queue, f.segmented_hz,
              static_cast<unsigned long long>(f.published),
              static_cast<unsigned long long>(f.dropped), f.latency_median_ms, f.latency_p99_ms,
              f.stage_median_ms.at("waiting"), f.stage_median_ms.at("segmenting"), f.segmenter_cpu,
              f.grabber_cpu);
  for (const auto& [cause, count] : f.dropped_by_cause) {
    if (count > 0) std::printf(" %llu %s", static_cast<unsigned long long>(count), cause.c_str());
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string table = argc > 1 ? argv[1] : "";
  const std::vector<StreamSetting> rows = rows_of(table, argc > 2 ? argv[2] : "synthetic:medium");
  if (rows.empty()) {
    const bool asked = table == "--help" || table == "-h";
    (asked ? std::cout : std::cerr) << usage;
    return asked ? 0 : 2;
  }
  try {
    const cleave::test::RouDi roudi;
    std::printf(
        "                             | all cameras, live mode      | latency, ms   | median of, "
        "ms "
        "  | cores used    |\n"
        "cameras  fps workers queue | lists/s   published dropped | median    p99 | waiting "
        "segment "
        "| segmtr grabbr | dropped because\n");
    for (const StreamSetting& row : rows) print(row, run_stream(row, seconds_a_row));
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_stream: " << error.what() << '\n';
    return 1;
  }
}
