// SPDX-License-Identifier: BSD-3-Clause
#include "c/errors.hpp"

#include <algorithm>
#include <array>
#include <new>

#include "libcleave/cdr.hpp"

namespace cleave::c {
namespace {

constexpr std::size_t longest_text = 1023;
thread_local std::array<char, longest_text + 1> text_of_thread{};

}  // namespace

cleave_result fail(cleave_result result, std::string_view text) noexcept {
  const std::string_view kept = text.substr(0, longest_text);
  *std::ranges::copy(kept, text_of_thread.begin()).out = '\0';
  return result;
}

const char* error_text() noexcept {
  return text_of_thread.data();
}

cleave_result failure_of_exception() noexcept {
  try {
    throw;
  } catch (const Failure& failure) {
    return fail(failure.result, failure.what());
  } catch (const std::invalid_argument& error) {
    return fail(CLEAVE_BAD_ARGUMENT, error.what());
  } catch (const CdrError& error) {
    return fail(CLEAVE_BAD_DATA, error.what());
  } catch (const std::bad_alloc&) {
    return fail(CLEAVE_NO_MEMORY, "the machine has no memory left");
  } catch (const std::exception& error) {
    return fail(CLEAVE_FAILED, error.what());
  } catch (...) {
    return fail(CLEAVE_FAILED, "an unknown exception");
  }
}

}  // namespace cleave::c
