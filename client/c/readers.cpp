// SPDX-License-Identifier: BSD-3-Clause
#include <chrono>
#include <memory>
#include <string>

#include "c/any_reader.hpp"
#include "c/cleave.h"
#include "c/errors.hpp"
#include "c/handles.hpp"
#include "c/new_sample.hpp"

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

cleave_result cleave_take(cleave_reader* reader, cleave_sample** sample) {
  return guarded([&] {
    auto& shared = given(reader, "reader").reader;
    cleave_sample*& result = given(sample, "sample");
    auto taken = shared->take();
    if (!taken) return cleave::c::fail(CLEAVE_TIMEOUT, "no sample waits");
    result = cleave::c::new_sample(shared, std::move(*taken)).release();
    return CLEAVE_OK;
  });
}

cleave_result cleave_wait(cleave_reader* reader, int32_t timeout_ms) {
  return guarded([&] {
    auto& shared = *given(reader, "reader").reader;
    if (shared.wait(std::chrono::milliseconds(timeout_ms))) return CLEAVE_OK;
    return cleave::c::fail(CLEAVE_TIMEOUT, shared.live_writers() == 0
                                               ? "no sample came in time: nobody publishes them"
                                               : "no sample came in time");
  });
}

int cleave_reader_fd(const cleave_reader* reader) {
  return reader != nullptr ? reader->reader->descriptor() : -1;
}

uint32_t cleave_reader_writers(const cleave_reader* reader) {
  return reader != nullptr ? reader->reader->live_writers() : 0;
}
