// SPDX-License-Identifier: BSD-3-Clause
// What stands between a source and the grabber passes on all but frames.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "sensor/sources/source.hpp"

namespace cleave::sensor {

class WrappedSource : public Source {
 public:
  explicit WrappedSource(std::unique_ptr<Source> source) : source_(std::move(source)) {}

  [[nodiscard]] Failure open() override { return source_->open(); }
  [[nodiscard]] bool realtime() const override { return source_->realtime(); }
  [[nodiscard]] SourceCounts counts() const override { return source_->counts(); }
  [[nodiscard]] std::string last_error() const override { return source_->last_error(); }
  [[nodiscard]] bool in_use() const override { return source_->in_use(); }

 protected:
  [[nodiscard]] Source& source() { return *source_; }

 private:
  std::unique_ptr<Source> source_;
};

}  // namespace cleave::sensor
