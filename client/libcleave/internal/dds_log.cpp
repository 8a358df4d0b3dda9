// SPDX-License-Identifier: BSD-3-Clause
#include "libcleave/internal/dds_log.hpp"

#include <dds/ddsrt/log.h>
#include <spdlog/spdlog.h>

#include <cstdint>
#include <string_view>

#include "libcleave/process/logging.hpp"

namespace cleave::dds {
namespace {

// From any of Cyclone's threads.
void write_line(void* limiter, const dds_log_data_t* line) {
  std::uint64_t suppressed = 0;
  if (!static_cast<LogLimiter*>(limiter)->allow(suppressed)) return;
  std::string_view text(line->message, line->size);
  while (text.ends_with('\n')) text.remove_suffix(1);
  spdlog::log((line->priority & DDS_LC_WARNING) != 0 ? spdlog::level::warn : spdlog::level::err,
              "DDS: {} ({} more before)", text, suppressed);
}

}  // namespace

void log_through_ours() {
  static LogLimiter limiter;
  dds_set_log_sink(write_line, &limiter);
}

}  // namespace cleave::dds
