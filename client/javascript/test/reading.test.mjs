// SPDX-License-Identifier: BSD-3-Clause
// On a domain of its own, where no node is.
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { test } from "node:test";
import { promisify } from "node:util";

import { segments, status, statuses } from "../dist/index.js";
import { Socket } from "../dist/socket.js";
import { MessageView } from "../dist/vendor/rtps.js";

const domain = 99;

test("a sensor that is not there is named after the timeout, with its domain and what to do", async () => {
  await assert.rejects(segments("left", { domain, timeout: 20 }).next(), (error) => {
    assert.equal(error.name, "TimeoutError");
    for (const part of ["'left'", "domain 99", "20 ms", "cleave-segmenter", "CLEAVE_DOMAIN"]) {
      assert.ok(error.message.includes(part), error.message);
    }
    return true;
  });
});

test("statuses of nobody time out", async () => {
  await assert.rejects(statuses({ domain, timeout: 20 }).next(), /no status on domain 99 for 20 ms/);
  await assert.rejects(status({ domain, timeout: 20 }), { name: "TimeoutError" });
});

test("a loop that has thrown is over", async () => {
  const reading = segments("left", { domain, timeout: 20 });
  await assert.rejects(reading.next());
  assert.deepEqual(await reading.next(), { done: true, value: undefined });
});

test("an aborted signal ends what waits with its reason", async () => {
  const controller = new AbortController();
  const asked = segments("left", { domain, signal: controller.signal }).next();
  setTimeout(() => controller.abort(new Error("enough")), 20);
  await assert.rejects(asked, /enough/);
});

test("a signal that was aborted before opens nothing", async () => {
  const asked = segments("left", { domain, signal: AbortSignal.abort() }).next();
  await assert.rejects(asked, { name: "AbortError" });
});

test("return() ends what waits", async () => {
  const reading = segments("left", { domain });
  const asked = reading.next();
  setTimeout(() => void reading.return(), 20);
  assert.deepEqual(await asked, { done: true, value: undefined });
});

test("a datagram that is not RTPS ends nothing", async () => {
  const socket = new Socket({ address: "127.0.0.1", loopback: true });
  await socket.bind({});
  const { port } = await socket.localAddress();
  socket.on("message", (data) => new MessageView(data));
  const said = new Promise((resolve) => socket.on("error", resolve));
  await socket.send(new Uint8Array(3), 0, 3, port, "127.0.0.1");
  assert.match((await said).message, /invalid RTPS message/);
  await socket.close();
  await socket.send(new Uint8Array(3), 0, 3, port, "127.0.0.1");
});

test("what is wrong is refused at once, by name", () => {
  assert.throws(() => segments("front left"), /sensor 'front left'.*letters/);
  assert.throws(() => segments("left", { domain: 100 }), /domain: .*0 to 99, found 100/);
  assert.throws(() => segments("left", { timeout: 0 }), /timeout: .*found 0/);
  assert.throws(() => segments("left", { domain, interface: "none0" }), /no network interface 'none0'.*127\.0\.0\.1/);
});

test("CLEAVE_DOMAIN is honoured, and refused when it is no domain", () => {
  try {
    for (const text of ["", "-1", "100", "1x", " 7"]) {
      process.env.CLEAVE_DOMAIN = text;
      assert.throws(() => segments(), /CLEAVE_DOMAIN: expected a number from 0 to 99, found/);
    }
    process.env.CLEAVE_DOMAIN = "99";
    segments();
    process.env.CLEAVE_DOMAIN = "1x";
    segments("camera", { domain });
  } finally {
    delete process.env.CLEAVE_DOMAIN;
  }
});

// A process that ends by itself has no socket and no timer left.
const program = (body) => promisify(execFile)(process.execPath, ["--input-type=module", "--eval",
  `import { segments } from ${JSON.stringify(new URL("../dist/index.js", import.meta.url))};
   const options = { domain: ${domain}, timeout: 50 };
   ${body}`]);

test("a program whose loop has ended ends", { timeout: 30_000 }, async () => {
  const { stdout } = await program(`
    try { for await (const list of segments("left", options)); } catch (error) { console.log(error.name); }
    const reading = segments("left", options);
    reading.next().catch(() => {});
    await reading.return();
    segments("left", options);`);
  assert.equal(stdout, "TimeoutError\n");
});
