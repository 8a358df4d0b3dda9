// SPDX-License-Identifier: BSD-3-Clause
// Readers in an event loop: a file descriptor that is readable while samples wait, for poll() and
// its like. Who does nothing else but wait has a WaitSet.
#pragma once

#include <chrono>
#include <utility>

#include "libcleave/internal/bulk_reader.hpp"
#include "libcleave/internal/raw_reader.hpp"
#include "libcleave/list_reader.hpp"
#include "libcleave/reader.hpp"

namespace cleave {

// Destroy after the attached readers. From one thread, but for the readers' own.
class ReadyDescriptor {
 public:
  // Throws std::system_error: the process has no descriptor left.
  ReadyDescriptor();
  ~ReadyDescriptor();
  ReadyDescriptor(const ReadyDescriptor&) = delete;
  ReadyDescriptor& operator=(const ReadyDescriptor&) = delete;

  // Makes the descriptor readable at once, for a sample may wait already.
  template <class T>
  void attach(const Reader<T>& reader) {
    reader.raw().notify(descriptor_);
  }
  template <class Kind, class SampleType>
  void attach(const BulkReader<Kind, SampleType>& reader) {
    reader.small().notify(descriptor_);
    reader.large().notify(descriptor_);
  }
  void attach(const ListReader& reader) { reader.raw().notify(descriptor_); }

  [[nodiscard]] int get() const { return descriptor_; }

  // What `take` returns, an optional of something out of an attached reader. The descriptor becomes
  // unreadable where that is empty, and only there, so that no sample's coming is missed.
  template <class Take>
  auto take(Take&& take) {
    if (auto found = take()) return found;
    drain();
    auto came_meanwhile = take();
    if (came_meanwhile) raise();  // there may be more behind it
    return came_meanwhile;
  }

  // Until the descriptor is readable, or `timeout` is over (a negative one never is), or a signal's
  // handler ran. True if it is readable.
  [[nodiscard]] bool wait(std::chrono::milliseconds timeout) const;
  // Makes the descriptor readable. From any thread.
  void raise() const;

 private:
  void drain() const;
  int descriptor_;
};

}  // namespace cleave
