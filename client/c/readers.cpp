// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <memory>
#include <string>

#include "c/any_reader.hpp"
#include "c/cleave.h"
#include "c/errors.hpp"
#include "c/handles.hpp"
#include "c/new_sample.hpp"

using cleave::c::AnyReader;
using cleave::c::given;
using cleave::c::guarded;

cleave_result cleave_reader_open(cleave_stream* stream, cleave_kind kind, const char* sensor,
                                 uint32_t depth, cleave_reader** reader) {
  const auto number = static_cast<std::uint32_t>(kind);
  return guarded([&] {
    const auto& shared = given(stream, "stream").stream;
    cleave_reader*& result = given(reader, "reader");
    const std::string name = number == CLEAVE_STATUS ? "" : &given(sensor, "sensor");
    result = new cleave_reader{std::make_shared<cleave::c::AnyReader>(shared, number, name, depth)};
    return CLEAVE_OK;
  });
}

void cleave_reader_close(cleave_reader* reader) {
  delete reader;
}

namespace {

cleave_result take(const std::shared_ptr<AnyReader>& reader, cleave_sample*& sample,
                   const char* otherwise) {
  auto taken = reader->take();
  if (!taken) return cleave::c::fail(CLEAVE_TIMEOUT, otherwise);
  sample = cleave::c::new_sample(reader, std::move(*taken)).release();
  return CLEAVE_OK;
}

cleave_result wait(AnyReader& reader, int32_t timeout_ms) {
  if (reader.wait(std::chrono::milliseconds(timeout_ms))) return CLEAVE_OK;
  return cleave::c::fail(CLEAVE_TIMEOUT, reader.live_writers() == 0
                                             ? "no sample came in time: nobody publishes them"
                                             : "no sample came in time");
}

}  // namespace

cleave_result cleave_take(cleave_reader* reader, cleave_sample** sample) {
  return guarded([&] {
    return take(given(reader, "reader").reader, given(sample, "sample"), "no sample waits");
  });
}

cleave_result cleave_wait(cleave_reader* reader, int32_t timeout_ms) {
  return guarded([&] { return wait(*given(reader, "reader").reader, timeout_ms); });
}

cleave_result cleave_next(cleave_reader* reader, int32_t timeout_ms, cleave_sample** sample) {
  return guarded([&] {
    const auto& shared = given(reader, "reader").reader;
    cleave_sample*& result = given(sample, "sample");
    const cleave_result waited = wait(*shared, timeout_ms);
    return waited == CLEAVE_OK ? take(shared, result, "no sample waits") : waited;
  });
}

int cleave_reader_fd(const cleave_reader* reader) {
  return reader != nullptr ? reader->reader->descriptor() : -1;
}

uint32_t cleave_reader_writers(const cleave_reader* reader) {
  return reader != nullptr ? reader->reader->live_writers() : 0;
}
