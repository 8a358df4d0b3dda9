// SPDX-License-Identifier: BSD-3-Clause
// What writers of clouds and of label maps share: both topics of the kind, and loans in place.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "libcleave/internal/bulk_kinds.hpp"
#include "libcleave/internal/large_chunks.hpp"
#include "libcleave/internal/raw_writer.hpp"
#include "libcleave/internal/topic.hpp"
#include "libcleave/stream.hpp"
#include "libcleave/types.hpp"

namespace cleave {

// Memory for one sample: a chunk of shared memory, or of the heap when the network carries it.
// Goes back unused unless it is published. Must not outlive its writer. Contents start undefined.
template <class Kind>
class BulkLoan {
 public:
  BulkLoan(RawWriter* writer, void* memory, bool large)
      : writer_(writer), memory_(memory), large_(large) {}
  BulkLoan(BulkLoan&& other) noexcept
      : writer_(other.writer_),
        memory_(std::exchange(other.memory_, nullptr)),
        large_(other.large_) {}
  BulkLoan& operator=(BulkLoan&& other) noexcept {
    std::swap(writer_, other.writer_);
    std::swap(memory_, other.memory_);
    std::swap(large_, other.large_);
    return *this;
  }
  ~BulkLoan() {
    if (memory_ != nullptr) writer_->give_back(memory_);
  }

  [[nodiscard]] FrameHeader& header() const { return *static_cast<FrameHeader*>(memory_); }
  // Room for as many points as were asked for, and more.
  [[nodiscard]] std::span<typename Kind::Value> room() const {
    auto* const first =
        reinterpret_cast<typename Kind::Value*>(static_cast<std::byte*>(memory_) + Kind::offset);
    return {first, capacity_of(large_) * Kind::values_a_point};
  }
  // Once. False when DDS refused the sample (it is lost): said in the log, once a second at most.
  [[nodiscard]] bool publish() && { return writer_->publish_loan(std::exchange(memory_, nullptr)); }

 protected:
  [[nodiscard]] void* memory() const { return memory_; }

 private:
  RawWriter* writer_;
  void* memory_;
  bool large_;
};

// Has both topics of a kind open, so that readers have found it before the first sample, and
// publishes on the one that a frame's size asks for. Safe to use from several threads.
template <class Kind, class LoanType>
class BulkWriter {
 public:
  // Throws std::runtime_error.
  BulkWriter(Stream& stream, std::string_view sensor)
      : BulkWriter(stream, sensor,
                   WriterDepth{topic_of<typename Kind::Small>(sensor).history_depth}) {}
  BulkWriter(Stream& stream, std::string_view sensor, WriterDepth depth)
      : small_(stream, topic_of<typename Kind::Small>(sensor), depth),
        large_(stream, topic_of<typename Kind::Large>(sensor), depth),
        chunks_(stream, sizeof(typename Kind::Large)) {}

  // For a frame of so many points, at most capacity_points. Empty: the pool is exhausted, because
  // readers hoard, or obstacle() says what is in the way. Drop the frame and count it.
  [[nodiscard]] std::optional<LoanType> loan(std::uint64_t points) {
    const bool large = is_large(points);
    in_use_ = large ? &large_ : &small_;
    if (points > capacity_points || (large && !chunks_.there())) return std::nullopt;
    RawWriter& writer = large ? large_ : small_;
    void* const memory = writer.loan();
    if (memory == nullptr) return std::nullopt;
    return LoanType(&writer, memory, large);
  }
  // Why large frames cannot be loaned, and what to do about it; empty while none was asked for.
  [[nodiscard]] std::string obstacle() const { return chunks_.obstacle(); }

  // Readers that get what is published now; see RawWriter. Of the topic that was last loaned for.
  [[nodiscard]] unsigned matched_readers() const {
    const RawWriter* const writer = in_use_;
    return writer != nullptr ? writer->matched_readers()
                             : std::max(small_.matched_readers(), large_.matched_readers());
  }
  // Whether loans are chunks of shared memory.
  [[nodiscard]] bool zero_copy() const { return small_.zero_copy(); }

 private:
  RawWriter small_;
  RawWriter large_;
  LargeChunks chunks_;
  std::atomic<RawWriter*> in_use_{nullptr};
};

}  // namespace cleave
