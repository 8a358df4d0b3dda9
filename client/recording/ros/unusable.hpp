// SPDX-License-Identifier: BSD-3-Clause
// Why a message gives no cloud, although its bytes are in order.
#pragma once

#include <string>
#include <utility>

#include "recording/error.hpp"

namespace cleave::recording::ros {

class Unusable : public DataError {
 public:
  // `cause`, a few words, is what frames are counted by; `why` says all.
  Unusable(std::string cause, const std::string& why) : DataError(why), cause_(std::move(cause)) {}
  [[nodiscard]] const std::string& cause() const { return cause_; }

 private:
  std::string cause_;
};

}  // namespace cleave::recording::ros
