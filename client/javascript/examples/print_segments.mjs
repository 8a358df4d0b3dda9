// SPDX-License-Identifier: BSD-3-Clause
// A planner's first client: prints the largest object of every frame.
//
//   node print_segments.mjs [SENSOR]
import { segments } from "cleave-client";

for await (const list of segments(process.argv[2] ?? "camera")) {
  // Labels go by size: the first is most often the table, the second the largest object.
  const object = list.segments[1];
  if (object === undefined) continue;
  const centre = [object.centroid.x, object.centroid.y, object.centroid.z];
  console.log(`frame ${list.header.frame_id}: ${list.segments.length} segments; the second has ` +
    `${object.point_count} points around (${centre.map((c) => c.toFixed(2)).join(", ")}) m`);
}
