// SPDX-License-Identifier: BSD-3-Clause
// On the camera's machine: prints the largest object of every frame, and the point of it that is
// nearest to the camera, read where the camera's grabber wrote it.
//
//   npm install koffi
//   node print_frames.mjs [SENSOR [FRAMES]]
import { frames } from "cleave-client/local";

const [sensor = "camera", count = "Infinity"] = process.argv.slice(2);
let left = Number(count);

for await (const frame of frames(sensor)) {
  // Labels go by size: the first is most often the table, the second the largest object.
  const object = frame.segments[1];
  if (object !== undefined) {
    const centre = [object.centroid.x, object.centroid.y, object.centroid.z];
    console.log(`frame ${frame.header.frame_id}: ${frame.segments.length} segments; the second ` +
      `has ${object.point_count} points around (${centre.map((c) => c.toFixed(2)).join(", ")}) m`);
    let nearest = Infinity;
    frame.labels.forEach((label, i) => {
      if (label === object.label) nearest = Math.min(nearest, frame.cloud[3 * i + 2]);
    });
    console.error(`frame ${frame.header.frame_id}: nearest point at ${nearest.toFixed(3)} m ` +
      `(${frame.zero_copy ? "zero copy" : "copied"})`);
  }
  if (--left <= 0) break;
}
