// SPDX-License-Identifier: BSD-3-Clause
// Who runs, and how well: a line for each node that answers.
//
//   node print_status.mjs
import { status } from "cleave-client";

for (const node of await status()) {
  console.log(`${node.node}: ${node.state}, ${node.frames_out} of ${node.frames_in} frames, ` +
    `${node.frames_dropped} dropped, ${node.rate_hz.toFixed(1)} Hz`);
}
