// SPDX-License-Identifier: BSD-3-Clause
// What Cyclone has to say, in our log.
#pragma once

namespace cleave::dds {

// Cyclone's errors and warnings go into our log from now on, one a second at most, with a count of
// those that were left out: whoever can send datagrams to a process makes it complain as often. For
// all domains of the process.
void log_through_ours();

}  // namespace cleave::dds
