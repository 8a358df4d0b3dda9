// SPDX-License-Identifier: BSD-3-Clause
#include "segmenter/dds_sink.hpp"

#include <optional>
#include <utility>

namespace cleave::service {
namespace {

class WriterLoan : public LabelLoan {
 public:
  WriterLoan(Writer<LabelMap>& writer, Loan<LabelMap> loan)
      : writer_(writer), loan_(std::move(loan)) {}
  [[nodiscard]] LabelMap& map() override { return *loan_; }
  [[nodiscard]] bool publish() override { return writer_.publish(std::move(loan_)); }

 private:
  Writer<LabelMap>& writer_;
  Loan<LabelMap> loan_;
};

}  // namespace

std::unique_ptr<LabelLoan> DdsSink::loan_labels() {
  std::optional<Loan<LabelMap>> loan = labels_.loan();
  if (!loan) return nullptr;
  return std::make_unique<WriterLoan>(labels_, std::move(*loan));
}

}  // namespace cleave::service
