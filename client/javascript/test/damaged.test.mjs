// SPDX-License-Identifier: BSD-3-Clause
// Bytes that are cut off, changed, or claim more than there is: a DecodeError or a value.
import assert from "node:assert/strict";
import { test } from "node:test";

import { DecodeError, decode, encode } from "cleave-client";

import { Dice, golden_files, is_bulk, topic_types, value_of } from "./samples.mjs";

const mutations = 1000;
const changed_at_most = 400;  // bytes at the front: where headers, counts and lengths are

const own = topic_types.map((type) => (
  { type, name: `a ${type}`, bytes: encode(type, value_of(type, new Dice(5))) }));

function survives(type, bytes) {
  try {
    decode(type, bytes);
  } catch (error) {
    assert.ok(error instanceof DecodeError, error);
  }
}

function mutate(bytes, dice) {
  const at = 4 + dice.below(Math.min(bytes.length - 4, changed_at_most));
  const old = bytes.slice(at, at + 4);
  const wrong = [0, 0x7f, 0x80, 0xff][dice.below(4)];
  for (let i = at; i < at + 1 + dice.below(4) && i < bytes.length; ++i) bytes[i] = wrong;
  return () => bytes.set(old, at);
}

for (const { type, name, bytes } of [...own, ...golden_files()]) {
  test(`${name}, damaged ${mutations} times, is an error or a value`, () => {
    const dice = new Dice(7);
    const copy = Uint8Array.from(bytes);
    const whole = is_bulk(type) ? 10 : mutations;  // of 23 MB each
    for (let i = 0; i < whole; ++i) {
      const undo = mutate(copy, dice);
      survives(type, copy);
      undo();
    }
    for (let i = 0; i < mutations; ++i) {
      const cut = copy.subarray(0, dice.below(copy.length));
      assert.throws(() => decode(type, cut), DecodeError, `cut at ${cut.length}`);
    }
  });
}

test("A count that claims 4 billion elements allocates nothing", () => {
  const list = value_of("SegmentList", new Dice(1));
  const bytes = encode("SegmentList", { ...list, segments: [], borders: [] });
  const count = bytes.length - 4 * 4;  // then the borders' count, and two floats
  new DataView(bytes.buffer).setUint32(count, 0xffffffff, true);
  assert.throws(() => decode("SegmentList", bytes),
    /SegmentList\.segments: claims 4294967295 elements, and 12 bytes are left/);
});

test("What is no plain CDR, or goes on behind its end, is refused", () => {
  const bytes = encode("SegmentList", value_of("SegmentList", new Dice(1)));
  assert.throws(() => decode("SegmentList", new Uint8Array(0)), DecodeError);
  assert.throws(() => decode("SegmentList", bytes.subarray(0, 3)), DecodeError);
  const other = Uint8Array.from(bytes);
  other[1] = 9;  // XCDR2
  assert.throws(() => decode("SegmentList", other), /does not begin as plain CDR does/);
  const longer = new Uint8Array(bytes.length + 8);
  longer.set(bytes);
  assert.throws(() => decode("SegmentList", longer), /8 bytes are left over/);
});
