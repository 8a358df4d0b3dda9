// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/raw_reader.hpp"

#include <dds/ddsi/ddsi_serdata.h>
#include <spdlog/spdlog.h>
#include <sys/eventfd.h>

#include <atomic>
#include <cstdint>
#include <string>

#include "libcleave/internal/dds.hpp"

namespace cleave {
namespace {

constexpr std::int64_t liveliness_lease_ns = DDS_SECS(1);  // as in qos_of()

ddsi_serdata* serdata_of(void* opaque) {
  return static_cast<ddsi_serdata*>(opaque);
}

}  // namespace

RawSample& RawSample::operator=(RawSample&& other) noexcept {
  std::swap(serdata_, other.serdata_);
  std::swap(data_, other.data_);
  std::swap(owned_, other.owned_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

void RawSample::release() noexcept {
  if (owned_ != nullptr) dds_sample_free(owned_, descriptor_, DDS_FREE_ALL);
  if (serdata_ != nullptr) ddsi_serdata_unref(serdata_of(serdata_));
}

struct RawReader::State {
  explicit State(const Topic& t) : topic(t) {}
  Topic topic;
  int event_descriptor = -1;
  std::atomic<std::int64_t> last_chunk_ns{-liveliness_lease_ns};
  dds::Entity dds_topic, reader;

  [[nodiscard]] dds::Listener listener() {
    dds::Listener result(dds_create_listener(this));
    dds_lset_subscription_matched(result.get(), on_matched);
    dds_lset_requested_incompatible_qos(result.get(), on_incompatible);
    return result;
  }
  static void on_matched(dds_entity_t /*reader*/, const dds_subscription_matched_status_t status,
                         void* state) {
    spdlog::debug("{}: a writer {}, {} now", static_cast<const State*>(state)->topic.name,
                  status.current_count_change > 0 ? "joined" : "left", status.current_count);
  }
  static void on_incompatible(dds_entity_t /*reader*/,
                              const dds_requested_incompatible_qos_status_t status, void* state) {
    spdlog::warn(
        "{}: a writer cannot be heard: its {} policy does not match what this reader needs",
        static_cast<const State*>(state)->topic.name, dds::policy_name(status.last_policy_id));
  }
  [[nodiscard]] bool matched() const {
    dds_subscription_matched_status_t status;
    return dds_get_subscription_matched_status(reader.get(), &status) == 0 &&
           status.current_count > 0;
  }
  // On whichever thread of DDS or iceoryx brings a sample.
  static void on_data(dds_entity_t /*reader*/, void* state) {
    (void)::eventfd_write(static_cast<const State*>(state)->event_descriptor, 1);
  }
};

RawReader::RawReader(Stream& stream, const Topic& topic, ReaderDepth depth)
    : state_(std::make_unique<State>(topic)) {
  State& s = *state_;
  const dds_entity_t participant = dds::participant_of(stream, topic);
  s.dds_topic = dds::create_topic(participant, topic);
  const dds::Listener listener = s.listener();
  s.reader = {dds_create_reader(participant, s.dds_topic.get(),
                                dds::qos_of(topic, depth.samples).get(), listener.get()),
              "cannot create a reader of " + topic.name};
}

RawReader::~RawReader() = default;

// dds_take would copy even out of shared memory; dds_takecdr hands over the received sample, whose
// iox_chunk (semi-internal in Cyclone 0.10) is the writer's own memory.
std::optional<RawSample> RawReader::take() {
  const dds_topic_descriptor_t* const descriptor = state_->topic.descriptor;
  for (;;) {
    ddsi_serdata* serdata = nullptr;
    dds_sample_info_t info;
    if (dds_takecdr(state_->reader.get(), &serdata, 1, &info, DDS_ANY_STATE) <= 0) {
      return std::nullopt;
    }
    if (!info.valid_data) {  // an instance that ended, not a sample
      ddsi_serdata_unref(serdata);
      continue;
    }
    if (serdata->iox_chunk != nullptr) {
      state_->last_chunk_ns = monotonic_now_ns();
      return RawSample(serdata, serdata->iox_chunk, nullptr, descriptor);
    }
    void* const copy = dds_alloc(descriptor->m_size);  // zeroed, as deserialisation needs it
    const bool complete = ddsi_serdata_to_sample(serdata, copy, nullptr, nullptr);
    ddsi_serdata_unref(serdata);
    if (complete) return RawSample(nullptr, copy, copy, descriptor);
    dds_sample_free(copy, descriptor, DDS_FREE_ALL);
    spdlog::error("{}: a sample could not be deserialised and was dropped", state_->topic.name);
  }
}

// By liveliness, not by matching: a killed process stays matched for its participant's lease of 10
// s. A writer that was suspended for longer than its lease comes alive again when the network
// brings something of it, and so never where all goes through shared memory: then its samples are
// the proof.
unsigned RawReader::live_writers() const {
  dds_liveliness_changed_status_t status;
  const bool known = dds_get_liveliness_changed_status(state_->reader.get(), &status) == 0;
  if (known && status.alive_count > 0) return status.alive_count;
  return monotonic_now_ns() - state_->last_chunk_ns < liveliness_lease_ns && state_->matched() ? 1
                                                                                               : 0;
}

void RawReader::notify(int event_descriptor) const {
  State& s = *state_;
  s.event_descriptor = event_descriptor;
  const dds::Listener listener = s.listener();
  dds_lset_data_available(listener.get(), State::on_data);
  if (const dds_return_t code = dds_set_listener(s.reader.get(), listener.get()); code < 0) {
    throw std::runtime_error("cannot listen to " + s.topic.name + ": " + dds_strretcode(code));
  }
  State::on_data(s.reader.get(), &s);
}

std::int32_t RawReader::entity() const {
  return state_->reader.get();
}

}  // namespace cleave
