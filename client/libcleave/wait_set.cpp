// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/wait_set.hpp"

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "libcleave/internal/dds.hpp"

namespace cleave {

// Owned by the library, not by a participant: readers of both domains may be attached.
struct WaitSet::State {
  dds::Entity set{dds_create_waitset(DDS_CYCLONEDDS_HANDLE), "cannot create a wait set"};
  dds::Entity guard{dds_create_guardcondition(DDS_CYCLONEDDS_HANDLE),
                    "cannot create a guard condition"};
  std::vector<dds::Entity> conditions;

  void attach(dds_entity_t entity) const {
    const dds_return_t code = dds_waitset_attach(set.get(), entity, dds_attach_t{entity});
    if (code < 0) {
      throw std::runtime_error(std::string("cannot attach to a wait set: ") + dds_strretcode(code));
    }
  }
};

WaitSet::WaitSet() : state_(std::make_unique<State>()) {
  state_->attach(state_->guard.get());
}

WaitSet::~WaitSet() = default;

void WaitSet::attach(const RawReader& reader) {
  state_->conditions.emplace_back(dds_create_readcondition(reader.entity(), DDS_ANY_STATE),
                                  "cannot create a read condition");
  state_->attach(state_->conditions.back().get());
}

bool WaitSet::wait(std::chrono::milliseconds timeout) {
  std::array<dds_attach_t, 8> fired{};
  const dds_return_t count =
      dds_waitset_wait(state_->set.get(), fired.data(), fired.size(), DDS_MSECS(timeout.count()));
  bool triggered = false;
  (void)dds_take_guardcondition(state_->guard.get(), &triggered);
  return count > 0;
}

void WaitSet::wake() {
  (void)dds_set_guardcondition(state_->guard.get(), true);
}

}  // namespace cleave
