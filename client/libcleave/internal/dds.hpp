// SPDX-License-Identifier: BSD-3-Clause
// What libcleave's own files share of the DDS C API: owned handles, and errors with a reason.
#pragma once

#include <dds/dds.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "libcleave/internal/topic.hpp"
#include "libcleave/stream.hpp"

namespace cleave::dds {

// A DDS entity, deleted with this object.
class Entity {
 public:
  Entity() = default;
  // Throws std::runtime_error "<what>: <DDS's reason>" when `handle` is an error code.
  Entity(dds_entity_t handle, const std::string& what) : handle_(handle) {
    if (handle < 0) throw std::runtime_error(what + ": " + dds_strretcode(handle));
  }
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Entity() {
    if (handle_ > 0) dds_delete(handle_);
  }
  [[nodiscard]] dds_entity_t get() const { return handle_; }

 private:
  dds_entity_t handle_ = 0;
};

struct QosDeleter {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, QosDeleter>;

struct ListenerDeleter {
  void operator()(dds_listener_t* listener) const { dds_delete_listener(listener); }
};
using Listener = std::unique_ptr<dds_listener_t, ListenerDeleter>;

// The quality of service that every topic shares, with this topic's durability and `depth`.
[[nodiscard]] Qos qos_of(const Topic& topic, int depth);

// The standard's name of a policy, for logs.
[[nodiscard]] const char* policy_name(std::uint32_t policy_id);

// The participant of the topic's domain.
[[nodiscard]] dds_entity_t participant_of(const Stream& stream, const Topic& topic);

// Throws std::runtime_error that names the topic.
[[nodiscard]] Entity create_topic(dds_entity_t participant, const Topic& topic);

}  // namespace cleave::dds
