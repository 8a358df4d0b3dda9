// SPDX-License-Identifier: BSD-3-Clause
// Frames where there is no library and no camera, and how memory is taken away from arrays.
import assert from "node:assert/strict";
import { test } from "node:test";

import { frames } from "cleave-client/local";
import koffi from "koffi";

import { buffer_of, detach, shows_memory } from "../dist/local/memory.js";

test("Without a library it says where it looked and what to do", () => {
  process.env.CLEAVE_LIBRARY = "/nowhere/libcleave-c.so.1";
  assert.throws(() => frames(), (error) =>
    /found no libcleave-c\.so\.1 that loads; build it with .*--target cleave-c/.test(error.message) &&
    /\n {2}\/nowhere\/libcleave-c\.so\.1: .*cannot open/.test(error.message));
});

test("Another library is named", () => {
  process.env.CLEAVE_LIBRARY = "libc.so.6";
  assert.throws(() => frames(), /libc\.so\.6 is no libcleave-c .*CLEAVE_LIBRARY/);
});

test("A wrong name, domain or timeout is refused before the library is looked for", () => {
  process.env.CLEAVE_LIBRARY = "/nowhere/libcleave-c.so.1";
  assert.throws(() => frames("a/b"), /sensor 'a\/b': expected 1 to 63 letters, digits or '_'/);
  assert.throws(() => frames("camera", { domain: 100 }), /domain: expected a number from 0 to 99/);
  assert.throws(() => frames("camera", { timeout: 0 }), /timeout: expected milliseconds above 0/);
});

test("Memory is shown in place until it is taken away, and then no array reads it", () => {
  assert.ok(shows_memory(koffi));
  const memory = koffi.alloc("float", 4);
  const buffer = buffer_of(koffi, memory, 16, true);
  const [numbers, bytes] = [new Float32Array(buffer), Buffer.from(buffer)];
  koffi.encode(memory, "float", 1.5);
  assert.equal(numbers[0], 1.5);
  detach(buffer);
  koffi.free(memory);
  assert.deepEqual([numbers.length, bytes.length, buffer.byteLength], [0, 0, 0]);
  assert.equal(numbers[0], undefined);
  assert.throws(() => numbers.slice(), TypeError);
  detach(buffer);
});

test("Where memory cannot be shown it is copied, and taken away as well", () => {
  const memory = koffi.alloc("float", 4);
  const buffer = buffer_of(koffi, memory, 16, false);
  const numbers = new Float32Array(buffer);
  koffi.encode(memory, "float", 1.5);
  assert.equal(numbers[0], 0);
  assert.equal(numbers.length, 4);
  detach(buffer);
  koffi.free(memory);
  assert.equal(numbers.length, 0);
});
