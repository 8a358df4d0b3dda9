// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/dds_sink.hpp"

#include <optional>
#include <utility>

namespace cleave::service {
namespace {

class LoanedMemory : public LabelMemory {
 public:
  explicit LoanedMemory(LabelLoan loan) : loan_(std::move(loan)) {}
  [[nodiscard]] FrameHeader& header() override { return loan_.header(); }
  [[nodiscard]] std::int64_t& cloud_publication_time_ns() override {
    return loan_.cloud_publication_time_ns();
  }
  [[nodiscard]] std::span<std::uint16_t> room() override { return loan_.room(); }
  [[nodiscard]] bool publish() override { return std::move(loan_).publish(); }

 private:
  LabelLoan loan_;
};

}  // namespace

std::unique_ptr<LabelMemory> DdsSink::loan_labels(std::uint64_t points) {
  std::optional<LabelLoan> loan = labels_.loan(points);
  if (!loan) return nullptr;
  return std::make_unique<LoanedMemory>(std::move(*loan));
}

std::string DdsSink::no_memory() const {
  std::string obstacle = labels_.obstacle();
  if (!obstacle.empty()) return obstacle;
  return "no chunk is free for its label map; some reader holds too many samples";
}

}  // namespace cleave::service
