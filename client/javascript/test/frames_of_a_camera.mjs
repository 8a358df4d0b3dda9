// SPDX-License-Identifier: BSD-3-Clause
// What frames are, beside a camera of 640 x 480 in shared memory; tests/interop runs it.
// Usage: node --expose-gc test/frames_of_a_camera.mjs [SENSOR]   (after `npm run build`)
import assert from "node:assert/strict";
import { test } from "node:test";

import { LibraryError, TimeoutError, frames } from "cleave-client/local";

const sensor = process.argv[2] ?? "camera";
const timeout = 60_000;
const open = () => frames(sensor, { timeout });
const turn = () => new Promise((done) => setTimeout(done, 10));

// Of each label from 0 on.
function counts_of(labels) {
  const counts = [];
  for (const label of labels) counts[label] = (counts[label] ?? 0) + 1;
  return counts;
}

test("What the library refuses it says in its words", () => {
  assert.throws(() => frames("camera", { interface: "nonsense0" }), (error) =>
    error instanceof LibraryError && error.code !== "OK" && /nonsense0/.test(error.message));
});

test("Frames are whole, in place and in order, and their labels count what the list says", async () => {
  const reading = open();
  assert.ok(reading.transport.shared_memory, reading.transport.reason);
  let seen = 0, last = -1n;
  for await (const frame of reading) {
    const { header, cloud, labels, segments } = frame;
    assert.ok(header.frame_id > last);
    last = header.frame_id;
    assert.equal(header.width * header.height, 640 * 480);
    assert.ok(cloud instanceof Float32Array && cloud.length === 3 * 640 * 480);
    assert.ok(labels instanceof Uint16Array && labels.length === 640 * 480);
    assert.ok(frame.zero_copy);
    assert.deepEqual(counts_of(labels).slice(1), segments.map((each) => each.point_count));
    for (const { label, point_count, centroid } of segments) {
      const points = frame.points(label);
      assert.equal(points.length, 3 * point_count);
      const mean_z = points.reduce((sum, value, i) => (i % 3 === 2 ? sum + value : sum), 0) /
        point_count;
      assert.ok(Math.abs(mean_z - centroid.z) < 1e-3);
    }
    if (++seen === 20) break;
  }
  assert.equal(reading.bad_samples, 0);
  assert.equal((await reading.next()).done, true);
});

test("The next frame takes the last one's arrays away, and its list stays", async () => {
  const reading = open();
  const first = (await reading.next()).value;
  const { cloud, labels } = first;
  const kept = cloud.slice();
  const second = (await reading.next()).value;
  assert.deepEqual([cloud.length, labels.length, kept.length], [0, 0, 3 * 640 * 480]);
  assert.throws(() => first.cloud, /the frame is closed.*frame\.cloud\.slice\(\)/);
  assert.throws(() => first.points(1), /the frame is closed/);
  assert.ok(first.segments.length > 0);
  const last = second.cloud;
  second.close();
  second[Symbol.dispose]();
  assert.equal(last.length, 0);
  await reading.return();
});

test("More loops than the camera has memory for frames can be left without an end", async () => {
  for (let i = 0; i < 60; ++i) {
    const frame = (await open().next()).value;
    assert.ok(frame.cloud.length > 0);
    global.gc();
    await turn();
    global.gc();
    await turn();
  }
});

test("An array whose frame and loop are forgotten keeps its memory", async () => {
  const cloud = await (async () => (await open().next()).value.cloud)();
  const copy = cloud.slice();
  for (let i = 0; i < 30; ++i) {
    global.gc();
    await turn();
  }
  assert.deepEqual(cloud, copy);
});

test("Two loops share the stream, of one domain", async () => {
  const [one, other] = [open(), open()];
  assert.throws(() => frames(sensor, { domain: 77 }), /can join one stream at a time/);
  const [a, b] = await Promise.all([one.next(), other.next()]);
  assert.ok(a.value.zero_copy && b.value.zero_copy);
  await one.return();
  assert.ok((await other.next()).value.cloud.length > 0);
  await other.return();
});

test("The event loop turns while frames are waited for, and one waits at a time", async () => {
  const nobody = frames("nobody", { timeout: 300 });
  let turns = 0;
  const timer = setInterval(() => ++turns, 5);
  const waiting = nobody.next();
  await assert.rejects(nobody.next(), /ask for one after the other/);
  await assert.rejects(waiting, (error) => error instanceof TimeoutError &&
    /sensor 'nobody' on domain \d+, for 300 ms: no frame came in time: nobody publishes/
      .test(error.message));
  clearInterval(timer);
  assert.ok(turns > 2);
  assert.equal((await nobody.next()).done, true);
});

test("A loop that waits ends at once by its signal's reason, or without one", async () => {
  const controller = new AbortController();
  const waiting = frames("nobody", { signal: controller.signal }).next();
  setTimeout(() => controller.abort(new Error("enough")), 20);
  await assert.rejects(waiting, /enough/);
  const nobody = frames("nobody");
  setTimeout(() => nobody.return(), 20);
  assert.equal((await nobody.next()).done, true);
});
