// SPDX-License-Identifier: BSD-3-Clause
// Exact accounting: received = published + dropped + rejected + in flight, at every moment.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <vector>

#include "idl/frame_key.hpp"
#include "segmenter/pipeline/causes.hpp"

namespace cleave::service {

struct FrameCounts {
  std::uint64_t received = 0;  // by the sensor published, those lost in transport included
  std::uint64_t published = 0;
  std::uint64_t in_flight = 0;
  std::array<std::uint64_t, drop_cause_names.size()> dropped{};
  std::array<std::uint64_t, reject_cause_names.size()> rejected{};
  std::uint64_t zero_copy = 0;  // of the received, handed over in shared memory
  std::uint64_t duplicates =
      0;  // resends of frames that were already counted; in none of the above

  [[nodiscard]] std::uint64_t dropped_total() const;
  [[nodiscard]] std::uint64_t rejected_total() const;
};

enum class Arrival {
  fresh,     // counted as received and in flight until it is published, dropped or rejected
  again,     // answered before; its answer was lost: answer it again, nothing is counted
  in_flight  // its answer is on the way: nothing to do
};

struct Arrived {
  Arrival arrival = Arrival::fresh;
  std::uint64_t missed = 0;  // frames before it that never came: counted as dropped in transport
};

// A frame is its epoch and id, whatever else is wrong with it. Ids rise by one for every frame that
// a grabber publishes, and go on when its epoch rises by one. Any other epoch is another grabber,
// whose ids start anew: what came before its first frame is not missed.
//
// The lossless grabber publishes a frame again, under the same id, until its segment list comes
// back. A resend of a frame that was counted as dropped takes that back: the frame is in flight
// again. A resend of an answered frame counts as a duplicate only.
//
// Safe to use from several threads.
class FrameLedger {
 public:
  [[nodiscard]] Arrived arrive(FrameKey key, bool zero_copy);

  // How a frame ended. For a frame that arrived `again` these count nothing.
  void publish(FrameKey key);
  void drop(FrameKey key, DropCause cause);
  void reject(FrameKey key, RejectCause cause);

  // All counts of one moment.
  [[nodiscard]] FrameCounts snapshot() const;

 private:
  struct Dropped {
    FrameKey key;
    DropCause cause;
  };
  std::uint64_t count_gap(FrameKey key);
  std::optional<DropCause> take_back_drop(FrameKey key);
  void enter_flight(FrameKey key);
  bool leave_flight(FrameKey key);
  void remember_drop(FrameKey key, DropCause cause);

  mutable std::mutex mutex_;  // guards all below
  FrameCounts counts_;
  std::optional<FrameKey> newest_;
  std::vector<FrameKey> flight_;
  std::deque<Dropped> recent_drops_;
};

}  // namespace cleave::service
