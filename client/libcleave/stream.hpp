// SPDX-License-Identifier: BSD-3-Clause
// A process's membership of the stream: one bulk domain (shared memory) and one public (RTPS).
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace cleave {

enum class Transport { shared_memory, network };

struct StreamOptions {
  // Public domain id, 0 to 99; the bulk domain is 100 above it, with a shared-memory prefix of its
  // own, because shared memory ignores domain ids.
  std::uint32_t domain = 0;
  // Off: clouds and label maps travel over loopback, copied.
  bool shared_memory = true;
  // Network interface of the public domain, by name or address. The bulk domain never leaves "lo".
  std::string public_interface = "lo";
};

// The options with `domain` taken from the environment's CLEAVE_DOMAIN, and `public_interface` from
// its CLEAVE_INTERFACE, where these are set. Throws std::invalid_argument when the former is not a
// number from 0 to 99, or the latter no name or address.
[[nodiscard]] StreamOptions with_environment(StreamOptions options);

// Both domains, open from construction to destruction. Readers, writers and wait sets must be gone
// before it. One a process: iceoryx knows processes, not objects.
class Stream {
 public:
  // Throws std::runtime_error that says what failed and what to do. Never blocks on a missing
  // RouDi: it is probed first, and without one the bulk domain uses the network, said in the log.
  explicit Stream(const StreamOptions& options);
  ~Stream();
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  // What carries clouds and label maps, and why: "RouDi answers", "switched off by configuration",
  // or what obstacle_to_roudi() and obstacle_of_pools() say, with what to do about it.
  [[nodiscard]] Transport transport() const;
  [[nodiscard]] const std::string& transport_reason() const;
  [[nodiscard]] const StreamOptions& options() const;

  // DDS entity handles, for libcleave's own readers and writers.
  [[nodiscard]] std::int32_t bulk_participant() const;
  [[nodiscard]] std::int32_t public_participant() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cleave
