// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { test } from "node:test";

import { DecodeError, EncodeError, decode, encode } from "../dist/index.js";
import { kinds, oracle_bytes, oracle_value, plain } from "./support/oracle.mjs";
import { generator, large_types, sample, small_types } from "./support/samples.mjs";

const content = (bytes) => Buffer.from(bytes.subarray(4));

for (const name of small_types) {
  test(`${name} is read as another implementation wrote it, in both byte orders`, () => {
    const random = generator(7);
    for (let i = 0; i < 50; ++i) {
      const value = sample(name, random);
      for (const kind of [kinds.little, kinds.big]) {
        assert.deepEqual(decode(name, oracle_bytes(name, value, kind)), value);
      }
    }
  });

  test(`${name} is written as another implementation writes and reads it`, () => {
    const random = generator(11);
    for (let i = 0; i < 50; ++i) {
      const value = sample(name, random);
      const bytes = encode(name, value);
      const expected = content(oracle_bytes(name, value, kinds.little));
      assert.deepEqual(content(bytes), expected);
      assert.deepEqual(oracle_value(name, bytes), plain(name, value));
    }
  });

  test(`${name} that ends early is refused at every length`, () => {
    const bytes = encode(name, sample(name, generator(3)));
    for (let length = 0; length < bytes.length; ++length) {
      assert.throws(() => decode(name, bytes.subarray(0, length)), DecodeError);
    }
  });

  test(`${name} with a word changed is read or refused, never more`, () => {
    const bytes = encode(name, sample(name, generator(5)));
    for (let at = 0; at + 4 <= bytes.length; ++at) {
      for (const word of [0, 0x7fffffff, 0xffffffff]) {
        const changed = bytes.slice();
        new DataView(changed.buffer).setUint32(at, word);
        try {
          decode(name, changed);
        } catch (error) {
          assert.ok(error instanceof DecodeError, error.stack);
        }
      }
    }
  });
}

for (const name of large_types) {
  test(`${name} comes back as it was`, () => {
    const value = sample(name, generator(1));
    assert.deepEqual(decode(name, encode(name, value)), value);
  });
}

const list = () => sample("SegmentList", generator(3));

test("a sequence that claims more than there is allocates nothing", () => {
  const bytes = encode("SegmentList", { ...list(), segments: [], borders: [] });
  const view = new DataView(bytes.buffer);
  let refused = 0;
  for (let at = 4; at + 4 <= bytes.length; at += 4) {
    if (view.getUint32(at, true) !== 0) continue;
    view.setUint32(at, 0xffffffff, true);
    const before = process.memoryUsage().arrayBuffers + process.memoryUsage().heapUsed;
    try {
      decode("SegmentList", bytes);
    } catch (error) {
      if (/claims 4294967295 elements/.test(error.message)) ++refused;
    }
    assert.ok(process.memoryUsage().arrayBuffers + process.memoryUsage().heapUsed - before < 10e6);
    view.setUint32(at, 0, true);
  }
  assert.ok(refused >= 2);
});

test("bytes left over are refused: another contract's message", () => {
  const bytes = encode("SegmentList", list());
  const longer = new Uint8Array(bytes.length + 4);
  longer.set(bytes);
  assert.throws(() => decode("SegmentList", longer), /left over/);
});

// The oracle counts letters where bytes are meant.
test("text keeps what is not ASCII", () => {
  const value = { cause: "Größe, 3 µs 😀", count: 1n };
  assert.deepEqual(decode("CauseCount", encode("CauseCount", value)), value);
});

test("another encapsulation than plain CDR is refused", () => {
  const bytes = encode("SegmentList", list());
  bytes[1] = 7;
  assert.throws(() => decode("SegmentList", bytes), /plain CDR/);
});

test("a view into a larger buffer is read at any offset", () => {
  const bytes = encode("SegmentList", list());
  for (let offset = 1; offset < 8; ++offset) {
    const buffer = new Uint8Array(bytes.length + offset);
    buffer.set(bytes, offset);
    assert.deepEqual(decode("SegmentList", buffer.subarray(offset)), list());
  }
});

test("a type that the contract does not have is refused by name", () => {
  assert.throws(() => decode("SegmentLists", new Uint8Array(8)), /no type 'SegmentLists'.*SegmentList/);
  assert.throws(() => encode("toString", {}), /no type 'toString'/);
});

test("what a field does not hold is refused by its path", () => {
  const wrong = (change, path) => {
    const value = list();
    value.segments = [sample("Segment", generator(2))];
    change(value);
    assert.throws(() => encode("SegmentList", value), (error) =>
      error instanceof EncodeError && error.message.startsWith(`SegmentList.${path}:`));
  };
  wrong((v) => { v.header.frame_id = 1; }, "header.frame_id");
  wrong((v) => { v.header.epoch = -1; }, "header.epoch");
  wrong((v) => { v.header.width = 1.5; }, "header.width");
  wrong((v) => { v.header.sensor = "x".repeat(64); }, "header.sensor");
  wrong((v) => { v.header.frame_id = 2n ** 64n; }, "header.frame_id");
  wrong((v) => { v.outcome = "SEGMENTED"; }, "outcome");
  wrong((v) => { delete v.segments[0].centroid.y; }, "segments[0].centroid.y");
  wrong((v) => { v.segments = undefined; }, "segments");
  wrong((v) => { v.header = null; }, "header");
});
