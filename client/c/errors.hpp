// SPDX-License-Identifier: BSD-3-Clause
// What stands between C++ and whoever calls: every exception becomes a code and a text.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "c/cleave.h"

namespace cleave::c {

// A failure whose code is known where it is found. Of others, std::invalid_argument is
// CLEAVE_BAD_ARGUMENT, std::bad_alloc CLEAVE_NO_MEMORY, CdrError CLEAVE_BAD_DATA, all else
// CLEAVE_FAILED.
struct Failure : std::runtime_error {
  Failure(cleave_result code, const std::string& what) : std::runtime_error(what), result(code) {}
  cleave_result result;
};

// Sets this thread's text, cut where it is too long, and returns the code. Allocates nothing.
cleave_result fail(cleave_result result, std::string_view text) noexcept;
// This thread's text.
[[nodiscard]] const char* error_text() noexcept;
// Call it where an exception is caught.
[[nodiscard]] cleave_result failure_of_exception() noexcept;

// Runs what a function of the header does; `body` returns the code.
template <class Body>
[[nodiscard]] cleave_result guarded(Body&& body) noexcept {
  try {
    return body();
  } catch (...) {
    return failure_of_exception();
  }
}

// What a pointer of the caller's points at. Throws std::invalid_argument where that is nothing.
template <class T>
[[nodiscard]] T& given(T* pointer, const char* name) {
  if (pointer == nullptr) throw std::invalid_argument(std::string(name) + " is a null pointer");
  return *pointer;
}

}  // namespace cleave::c
