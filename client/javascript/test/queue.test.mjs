// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { test } from "node:test";

import { InOrder } from "../dist/in_order.js";
import { Queue } from "../dist/queue.js";
import { FrameGaps } from "../dist/segments.js";

const never = () => assert.fail("nothing is late");

test("a queue gives what came first, whether it came before or after it was asked for", async () => {
  const queue = new Queue(4);
  const asked = [queue.take(undefined, never), queue.take(undefined, never)];
  for (const item of [1, 2, 3]) queue.push(item);
  assert.deepEqual(await Promise.all(asked), [1, 2]);
  assert.equal(await queue.take(undefined, never), 3);
});

test("a full queue drops the oldest", async () => {
  const queue = new Queue(2);
  for (const item of [1, 2, 3]) queue.push(item);
  assert.equal(await queue.take(undefined, never), 2);
});

test("a queue that ends lets go who waits, and who comes later", async () => {
  const queue = new Queue(2);
  const asked = queue.take(undefined, never);
  queue.end();
  queue.push(1);
  assert.equal(await asked, undefined);
  assert.equal(await queue.take(undefined, never), undefined);
});

test("a queue that fails says so once, to who waits or to the next one", async () => {
  const waited = new Queue(2);
  const asked = waited.take(undefined, never);
  waited.fail(new Error("gone"));
  await assert.rejects(asked, /gone/);
  assert.equal(await waited.take(undefined, never), undefined);
  const later = new Queue(2);
  later.fail(new Error("gone"));
  await assert.rejects(later.take(undefined, never), /gone/);
  assert.equal(await later.take(undefined, never), undefined);
});

test("who waits too long is told so, and the next one still gets what comes", async () => {
  const queue = new Queue(2);
  await assert.rejects(queue.take(1, () => "too late"), { name: "TimeoutError", message: "too late" });
  const asked = queue.take(undefined, never);
  queue.push(1);
  assert.equal(await asked, 1);
});

function delivered(sequences) {
  const order = [];
  const in_order = new InOrder((sample) => order.push(sample));
  for (const sequence of sequences) in_order.push(BigInt(sequence), sequence);
  return { order, in_order };
}

test("samples that come twice or late are delivered once and in order", () => {
  assert.deepEqual(delivered([7, 8, 8, 10, 7, 9, 9, 11]).order, [7, 8, 9, 10, 11]);
});

test("what is before the first sample is not waited for", () => {
  assert.deepEqual(delivered([7, 5, 6, 8]).order, [7, 8]);
});

test("a sample that its writer has no more is given up", () => {
  const { order, in_order } = delivered([1, 3, 4, 5, 6]);
  assert.deepEqual(order, [1]);
  in_order.push(7n, 7);
  assert.deepEqual(order, [1, 3, 4, 5, 6, 7]);
});

test("a sample that is the last for a while is not held back for a lost one", async () => {
  const order = [];
  await new Promise((resolve) => {
    const in_order = new InOrder((sample) => {
      order.push(sample);
      if (sample === 3) resolve();
    });
    in_order.push(1n, 1);
    in_order.push(3n, 3);
  });
  assert.deepEqual(order, [1, 3]);
});

test("lost frames are those that are missing between two of one grabber", () => {
  const gaps = new FrameGaps();
  for (const frame_id of [5n, 6n, 9n, 3n, 4n, 6n]) gaps.show({ frame_id });
  assert.equal(gaps.lost, 3);
});
