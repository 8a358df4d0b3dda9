// SPDX-License-Identifier: BSD-3-Clause
// What a reader does where nobody answers, and the parts that count and keep order.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

import { ContractError, TimeoutError, encode, segments, status, statuses } from "cleave-client";

import { InOrder } from "../dist/in_order.js";
import { Queue } from "../dist/queue.js";
import { FrameGaps } from "../dist/segments.js";
import { status_of } from "../dist/statuses.js";
import { Dice, value_of } from "./samples.mjs";

const domain = 98;  // of nobody
const first = async (iterator) => (await iterator.next()).value;

test("A sensor that is not there is named with its domain and what to do", async () => {
  await assert.rejects(first(segments("attic", { domain, timeout: 50 })), (error) =>
    error instanceof TimeoutError &&
    /no segment list of sensor 'attic' on domain 98 for 50 ms/.test(error.message) &&
    /start cleave-segmenter and cleave-grabber, .* CLEAVE_DOMAIN/.test(error.message));
  await assert.rejects(first(statuses({ domain, timeout: 50 })), TimeoutError);
  await assert.rejects(status({ domain, timeout: 50 }), /no status on domain 98/);
});

test("A wrong name, domain, interface or timeout is refused before anything is opened", () => {
  assert.throws(() => segments("a/b"), /sensor 'a\/b': expected 1 to 63 letters, digits or '_'/);
  assert.throws(() => segments("camera", { domain: 100 }), /domain: expected a number from 0 to 99/);
  assert.throws(() => segments("camera", { timeout: 0 }), /timeout: expected milliseconds above 0/);
  assert.throws(() => segments("camera", { interface: "nonsense0" }),
    /no network interface 'nonsense0'.* lo \(127\.0\.0\.1\)/);
});

test("CLEAVE_DOMAIN that is no domain is named", () => {
  process.env.CLEAVE_DOMAIN = "1e1";
  assert.throws(() => segments("camera"), /CLEAVE_DOMAIN: expected .* found '1e1'/);
  delete process.env.CLEAVE_DOMAIN;
});

test("An aborted signal ends the loop with its reason", async () => {
  const reason = new Error("enough");
  const controller = new AbortController();
  const waiting = first(segments("camera", { domain, signal: controller.signal }));
  setTimeout(() => controller.abort(reason), 20);
  await assert.rejects(waiting, reason);
  await assert.rejects(first(segments("camera", { domain, signal: controller.signal })), reason);
});

test("The process exits when its loop has ended", async () => {
  const script = `import { segments } from "cleave-client";
    const lists = segments("camera", { domain: ${domain} });
    setTimeout(() => lists.return(), 100);
    for await (const list of lists) console.log(list);
    console.log("ended");`;
  const { stdout } = await promisify(execFile)(process.execPath,
    ["--input-type=module", "--eval", script],
    { cwd: fileURLToPath(new URL("..", import.meta.url)), timeout: 60_000 });
  assert.equal(stdout, "ended\n");
});

test("A node of another contract is named and refused", () => {
  const good = value_of("NodeStatus", new Dice(2));
  const of = (contract) => encode("NodeStatus", { ...good, node: "segmenter/camera", contract });
  assert.equal(status_of(of("cleave_v1")).node, "segmenter/camera");
  assert.throws(() => status_of(of("cleave_v2")), (error) => error instanceof ContractError &&
    /segmenter\/camera speaks the contract 'cleave_v2', this package cleave_v1/.test(error.message));
  assert.throws(() => status_of(of("cleave_v1").subarray(0, 60)), ContractError);
});

test("Frames that no list came of are counted within an epoch", () => {
  const gaps = new FrameGaps();
  for (const [epoch, frame_id] of [[1, 5n], [1, 6n], [1, 9n], [1, 9n], [1, 8n], [2, 20n], [2, 22n]]) {
    gaps.show({ epoch, frame_id });
  }
  assert.equal(gaps.lost, 3);
});

test("A loop that is behind loses the oldest", async () => {
  const queue = new Queue(2);
  for (const item of [1, 2, 3]) queue.push(item);
  assert.deepEqual([await queue.take(), await queue.take()], [2, 3]);
  const waiting = queue.take();
  queue.fail(new Error("why"));
  await assert.rejects(waiting, /why/);
  assert.equal(await queue.take(), undefined);
});

test("What comes late or twice is delivered once and in order, and what never comes is skipped", () => {
  const delivered = [];
  const order = new InOrder((sample) => delivered.push(sample));
  for (const n of [3, 5, 3, 4, 4, 6, 2]) order.push(BigInt(n), n);
  assert.deepEqual(delivered, [3, 4, 5, 6]);
  for (const n of [8, 9, 10, 11, 12]) order.push(BigInt(n), n);
  assert.deepEqual(delivered, [3, 4, 5, 6, 8, 9, 10, 11, 12]);
  order.stop();
});
