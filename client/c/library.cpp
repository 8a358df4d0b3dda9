// SPDX-License-Identifier: BSD-3-Clause
// What needs no stream: versions, the last error, names.
#include <string>

#include "c/cleave.h"
#include "c/errors.hpp"
#include "idl/outcome_name.hpp"
#include "idl/topics.hpp"
#include "libcleave/status.hpp"

static_assert(cleave::c_abi_version == CLEAVE_ABI_VERSION);

uint32_t cleave_abi_version(void) {
  return CLEAVE_ABI_VERSION;
}

const char* cleave_version(void) {
  static const std::string text = cleave::version_text(CLEAVE_VERSION);
  return text.c_str();
}

const char* cleave_error(void) {
  return cleave::c::error_text();
}

const char* cleave_outcome_name(uint32_t outcome) {
  return cleave::outcome_name(outcome);
}

const char* cleave_state_name(uint32_t state) {
  return cleave::to_string(static_cast<cleave::NodeState>(state));
}
