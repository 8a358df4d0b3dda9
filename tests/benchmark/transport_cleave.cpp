// SPDX-License-Identifier: BSD-3-Clause
// A writer and a reader of clouds as a client of libcleave writes them. See transport.hpp.
#include "libcleave/reader.hpp"
#include "libcleave/wait_set.hpp"
#include "libcleave/writer.hpp"
#include "tests/benchmark/transport.hpp"

namespace {

using namespace cleave;
using namespace cleave::benchmark;

int write(Stream& stream, const TransportRole& role) {
  Writer<DepthCloud> writer(stream, "benchmark");
  while (writer.matched_readers() < role.readers) std::this_thread::sleep_for(transport_period);
  std::this_thread::sleep_for(connecting);
  for (int id = 0; id < role.clouds; ++id) {
    auto cloud = writer.loan();
    if (!cloud) return 1;
    stamp(**cloud, id);
    if (!writer.publish(std::move(*cloud))) return 1;
    std::this_thread::sleep_for(transport_period);
  }
  std::this_thread::sleep_for(connecting);  // let the readers take the last one
  return 0;
}

int read(Stream& stream, const TransportRole& role) {
  Reader<DepthCloud> reader(stream, "benchmark");
  WaitSet wait_set;
  wait_set.attach(reader);
  int left = role.clouds;
  while (left > 0 && wait_set.wait(transport_silence)) {
    while (const auto cloud = reader.take()) {
      say_latency(**cloud);
      --left;
    }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const auto role = transport_role(argc, argv);
  if (!role) return 2;
  Stream stream(with_environment({}));
  return role->writes ? write(stream, *role) : read(stream, *role);
}
