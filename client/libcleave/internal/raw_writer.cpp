// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/raw_writer.hpp"

#include <dds/ddsc/dds_loan_api.h>
#include <spdlog/spdlog.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <vector>

#include "libcleave/internal/dds.hpp"
#include "libcleave/process/logging.hpp"
#include "libcleave/types.hpp"

namespace cleave {
namespace {

// Loans of a writer that the network carries: heap buffers, reused.
class HeapLoans {
 public:
  explicit HeapLoans(std::size_t size) : size_(size) {}

  void* take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) {
      all_.push_back(std::make_unique<std::max_align_t[]>((size_ + sizeof(std::max_align_t) - 1) /
                                                          sizeof(std::max_align_t)));
      return all_.back().get();
    }
    void* const memory = free_.back();
    free_.pop_back();
    return memory;
  }
  void give_back(void* memory) {
    const std::lock_guard lock(mutex_);
    free_.push_back(memory);
  }

 private:
  std::size_t size_;
  std::mutex mutex_;  // guards the two below
  std::vector<std::unique_ptr<std::max_align_t[]>> all_;
  std::vector<void*> free_;
};

// RouDi connects what has matched in DDS at its next round, every 100 ms; what is written before is
// lost.
constexpr std::int64_t connection_time_ns = 250'000'000;

}  // namespace

struct RawWriter::State {
  explicit State(const Topic& t) : topic(t), heap(t.descriptor->m_size) {}
  Topic topic;
  HeapLoans heap;
  LogLimiter failures;
  bool zero_copy = false;
  std::atomic<std::int64_t> first_match_ns{0};  // when the first of the readers came
  dds::Entity dds_topic, writer;

  static void on_matched(dds_entity_t /*writer*/, const dds_publication_matched_status_t status,
                         void* state) {
    State& s = *static_cast<State*>(state);
    const bool joined = status.current_count_change > 0;
    if (joined && status.current_count == 1) s.first_match_ns = monotonic_now_ns();
    spdlog::debug("{}: a reader {}, {} now", s.topic.name, joined ? "joined" : "left",
                  status.current_count);
  }
  static void on_incompatible(dds_entity_t /*writer*/,
                              const dds_offered_incompatible_qos_status_t status, void* state) {
    spdlog::warn(
        "{}: a reader cannot be served: its {} policy does not match what this writer offers",
        static_cast<const State*>(state)->topic.name, dds::policy_name(status.last_policy_id));
  }
};

RawWriter::RawWriter(Stream& stream, const Topic& topic, WriterDepth depth)
    : state_(std::make_unique<State>(topic)) {
  State& s = *state_;
  const dds_entity_t participant = dds::participant_of(stream, topic);
  s.dds_topic = dds::create_topic(participant, topic);
  const dds::Listener listener(dds_create_listener(&s));
  dds_lset_publication_matched(listener.get(), State::on_matched);
  dds_lset_offered_incompatible_qos(listener.get(), State::on_incompatible);
  s.writer = {dds_create_writer(participant, s.dds_topic.get(),
                                dds::qos_of(topic, depth.samples).get(), listener.get()),
              "cannot create a writer of " + topic.name};
  s.zero_copy = dds_is_loan_available(s.writer.get());
  if (topic.domain == Domain::bulk && stream.transport() == Transport::shared_memory &&
      !s.zero_copy) {
    throw std::runtime_error("cannot loan shared memory for " + topic.name +
                             ": DDS refuses it for this type or quality of service");
  }
}

RawWriter::~RawWriter() = default;

void* RawWriter::loan() {
  if (!state_->zero_copy) return state_->heap.take();
  void* sample = nullptr;
  return dds_loan_sample(state_->writer.get(), &sample) == DDS_RETCODE_OK ? sample : nullptr;
}

void RawWriter::give_back(void* loan) {
  if (!state_->zero_copy) {
    state_->heap.give_back(loan);
  } else if (const dds_return_t code = dds_return_loan(state_->writer.get(), &loan, 1); code < 0) {
    spdlog::error("{}: cannot return a loan: {}", state_->topic.name, dds_strretcode(code));
  }
}

bool RawWriter::publish_loan(void* loan) {
  const bool published = publish(loan);
  if (!state_->zero_copy) state_->heap.give_back(loan);
  return published;
}

bool RawWriter::publish(const void* sample) {
  const dds_return_t code = dds_write(state_->writer.get(), sample);
  if (code == DDS_RETCODE_OK) return true;
  if (std::uint64_t suppressed = 0; state_->failures.allow(suppressed)) {
    spdlog::error("{}: a sample was not published: {} ({} more like this before)",
                  state_->topic.name, dds_strretcode(code), suppressed);
  }
  return false;
}

unsigned RawWriter::matched_readers() const {
  dds_publication_matched_status_t status;
  const bool known = dds_get_publication_matched_status(state_->writer.get(), &status) == 0;
  if (!known || status.current_count == 0) return 0;
  const bool connected =
      !state_->zero_copy || monotonic_now_ns() - state_->first_match_ns >= connection_time_ns;
  return connected ? status.current_count : 0;
}

bool RawWriter::zero_copy() const {
  return state_->zero_copy;
}

}  // namespace cleave
