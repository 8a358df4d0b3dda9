// SPDX-License-Identifier: BSD-3-Clause
// A received or decoded sample into the caller's hands, if it makes sense.
#pragma once

#include <memory>

#include "c/any_reader.hpp"
#include "c/handles.hpp"

namespace cleave::c {

// Throws Failure(CLEAVE_BAD_DATA) for a header with a name that does not end: whoever prints it
// would read on and on. What else a header may claim is looked at where it is used.
[[nodiscard]] std::unique_ptr<cleave_sample> new_sample(std::shared_ptr<const void> owner,
                                                        AnySample sample);

// Of a cloud, a label map or a list; null for a status.
[[nodiscard]] const FrameHeader* header_of(const AnySample& sample);

}  // namespace cleave::c
