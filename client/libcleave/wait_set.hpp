// SPDX-License-Identifier: BSD-3-Clause
// Sleeping until a reader has samples, or until another thread says that it is time to stop.
#pragma once

#include <chrono>
#include <memory>

#include "libcleave/internal/bulk_reader.hpp"
#include "libcleave/internal/raw_reader.hpp"
#include "libcleave/list_reader.hpp"
#include "libcleave/reader.hpp"

namespace cleave {

// Attach before the first wait; destroy before the attached readers.
class WaitSet {
 public:
  WaitSet();
  ~WaitSet();
  WaitSet(const WaitSet&) = delete;
  WaitSet& operator=(const WaitSet&) = delete;

  template <class T>
  void attach(const Reader<T>& reader) {
    attach(reader.raw());
  }
  void attach(const ListReader& reader) { attach(reader.raw()); }
  template <class Kind, class SampleType>
  void attach(const BulkReader<Kind, SampleType>& reader) {
    attach(reader.small());
    attach(reader.large());
  }

  // Returns when an attached reader has samples, after wake(), or after `timeout`; true if not the
  // timeout. May return early: check the readers.
  bool wait(std::chrono::milliseconds timeout);

  // Ends the current wait, or the next one. From any thread.
  void wake();

 private:
  void attach(const RawReader& reader);
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cleave
