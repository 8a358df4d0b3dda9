// SPDX-License-Identifier: BSD-3-Clause
// A reader of any kind, with its file descriptor.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "c/cleave.h"
#include "libcleave/cloud_reader.hpp"
#include "libcleave/list_reader.hpp"
#include "libcleave/reader.hpp"
#include "libcleave/ready_descriptor.hpp"
#include "libcleave/stream.hpp"
#include "libcleave/types.hpp"

namespace cleave::c {

// Both in the order of cleave_kind.
using AnySample = std::variant<CloudSample, LabelSample, ListSample, Sample<NodeStatus>>;
using ReaderOfKind = std::variant<CloudReader, LabelReader, ListReader, Reader<NodeStatus>>;

class AnyReader {
 public:
  // `kind`: a cleave_kind, or any number that a caller took for one. `depth` 0: the contract's.
  // Throws std::invalid_argument, std::runtime_error.
  AnyReader(std::shared_ptr<Stream> stream, std::uint32_t kind, const std::string& sensor,
            std::uint32_t depth);

  [[nodiscard]] std::optional<AnySample> take();
  // Whether a sample waits before `timeout` (a negative one is never over). A signal's handler ends
  // it early.
  [[nodiscard]] bool wait(std::chrono::milliseconds timeout);
  [[nodiscard]] int descriptor() const { return ready_.get(); }
  [[nodiscard]] unsigned live_writers() const;

 private:
  [[nodiscard]] std::optional<AnySample> take_from_dds();

  std::shared_ptr<Stream> stream_;
  ReadyDescriptor ready_;
  ReaderOfKind reader_;
  // What wait() has found: DDS cannot be asked without taking.
  std::optional<AnySample> next_;
};

}  // namespace cleave::c
