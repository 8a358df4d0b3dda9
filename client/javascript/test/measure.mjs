// SPDX-License-Identifier: BSD-3-Clause
// Lists a second, how many were lost, and what it costs; until none comes for 3 s.
// Usage: node test/measure.mjs [SENSOR]   (after `npm run build`)
import { segments } from "cleave-client";

const lists = segments(process.argv[2] ?? "camera");
const first = (await lists.next()).value;
const [begin, cpu] = [performance.now(), process.cpuUsage()];
let [count, end] = [1, begin];
const idle = setInterval(() => {
  if (performance.now() - end > 3000) void lists.return();
}, 100);
for await (const _ of lists) {
  ++count;
  end = performance.now();
}
clearInterval(idle);
const seconds = (end - begin) / 1000;
const { user, system } = process.cpuUsage(cpu);
console.log(JSON.stringify({
  first: String(first.header.frame_id), lists: count, lost: lists.lost,
  lists_a_second: Number(((count - 1) / seconds).toFixed(1)),
  share_of_a_core: Number(((user + system) / 1e6 / ((performance.now() - begin) / 1000)).toFixed(3)),
  memory_mb: Math.round(process.memoryUsage().rss / 1e6),
}));
