// SPDX-License-Identifier: BSD-3-Clause
// Whole frames a second, how many were lost, and what it costs.
// Usage: node test/measure_frames.mjs [FRAMES [SENSOR]]   (after `npm run build`)
import { frames } from "cleave-client/local";

const [count = "600", sensor = "camera"] = process.argv.slice(2);
const reading = frames(sensor);
let last = (await reading.next()).value.header.frame_id;
const [begin, cpu] = [performance.now(), process.cpuUsage()];
let [seen, lost, read] = [0, 0n, 0];
for await (const { header, cloud, labels } of reading) {
  lost += header.frame_id - last - 1n;
  last = header.frame_id;
  if (cloud.length === 3 * labels.length) ++read;
  if (++seen === Number(count)) break;
}
const seconds = (performance.now() - begin) / 1000;
const { user, system } = process.cpuUsage(cpu);
console.log(JSON.stringify({
  node: process.version, frames: seen, read, lost: Number(lost),
  frames_a_second: Number((seen / seconds).toFixed(1)),
  share_of_a_core: Number(((user + system) / 1e6 / seconds).toFixed(3)),
  memory_mb: Math.round(process.memoryUsage().rss / 1e6),
}));
