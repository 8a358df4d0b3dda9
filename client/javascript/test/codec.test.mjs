// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { MessageReader } from "@foxglove/omgidl-serialization";
import { parseIDL } from "@foxglove/omgidl-parser";
import { EncodeError, decode, encode } from "cleave-client";

import { schema } from "../dist/contract.js";
import { typed_array } from "../dist/schema.js";
import { Dice, golden_files, is_bulk, topic_types, value_of } from "./samples.mjs";

const byte_orders = ["little", "big"];
const seeds = (type) => (is_bulk(type) ? [1] : [1, 2, 3, 4, 5, 6, 7, 8]);

for (const type of topic_types) {
  test(`A ${type} survives both byte orders`, () => {
    for (const seed of seeds(type)) {
      const value = value_of(type, new Dice(seed));
      for (const byte_order of byte_orders) {
        assert.deepEqual(decode(type, encode(type, value, byte_order)), value);
      }
    }
  });
}

test("A text keeps its byte order mark", () => {
  const status = { ...value_of("NodeStatus", new Dice(1)), last_error: "\ufeffwhy" };
  assert.equal(decode("NodeStatus", encode("NodeStatus", status)).last_error, "\ufeffwhy");
});

// As the other reader has it: an enumeration is a number, and an array of char is bytes.
function plain(field, value) {
  if (Array.isArray(value)) return value.map((each) => plain(field, each));
  if (field.enum) return schema.enums[field.enum].find(([word]) => word === value)[1];
  if (field.struct) return plain_struct(field.struct, value);
  if (!field.text) return value;
  const bytes = new Uint8Array(field.length);
  bytes.set(new TextEncoder().encode(value));
  return bytes;
}
const plain_struct = (type, value) => Object.fromEntries(
  schema.structs[type].fields.map((field) => [field.name, plain(field, value[field.name])]));

test("Another reader of the IDL finds the same values", () => {
  const idl = readFileSync(new URL(import.meta.resolve?.("cleave-client/cleave_v1.idl") ??
    "../dist/cleave_v1.idl", import.meta.url), "utf8");
  for (const type of topic_types) {
    const reader = new MessageReader(`${schema.module}::${type}`, parseIDL(idl));
    const value = value_of(type, new Dice(11));
    for (const byte_order of byte_orders) {
      const read = reader.readMessage(encode(type, value, byte_order));
      assert.deepEqual(read, plain_struct(type, value), `${type}, ${byte_order}`);
    }
  }
});

// The JSON of a golden file as a value: texts are 64-bit numbers, NaN and the infinities, and an
// array is filled up with 0.
function number(basic, json) {
  return basic.endsWith("64") && basic !== "float64" ? BigInt(json) : Number(json);
}
function from_json(field, json) {
  if (field.text || field.enum || field.basic === "string") return json;
  if (field.length !== undefined) {
    const array = new typed_array[field.basic](field.length);
    array.set(json.map((each) => number(field.basic, each)));
    return array;
  }
  if (Array.isArray(json)) return json.map((each) => from_json({ ...field, sequence: undefined }, each));
  if (field.struct) return struct_from_json(field.struct, json);
  return field.basic === "float32" ? Math.fround(Number(json)) : number(field.basic, json);
}
const struct_from_json = (type, json) => Object.fromEntries(
  schema.structs[type].fields.map((field) => [field.name, from_json(field, json[field.name])]));

test("Golden files say what their JSON says, and are written so again", () => {
  const files = [...golden_files()];
  assert.ok(files.length > 0);
  for (const { type, name, bytes, json, byte_order } of files) {
    const value = decode(type, bytes);
    assert.deepEqual(value, struct_from_json(type, json), name);
    assert.ok(bytes.equals(encode(type, value, byte_order)), `${name} is written otherwise`);
  }
  assert.deepEqual(new Set(files.map(({ type }) => type)), new Set(topic_types));
  return undefined;
});

test("A value that the type does not hold is refused by the name of its field", () => {
  const list = value_of("SegmentList", new Dice(3));
  const refused = (change, text) => {
    const wrong = structuredClone(list);
    change(wrong);
    assert.throws(() => encode("SegmentList", wrong), (error) =>
      error instanceof EncodeError && error.message.includes(text));
  };
  refused((l) => { l.header.frame_id = 1; }, "SegmentList.header.frame_id: expected uint64");
  refused((l) => { l.header.width = -1; }, "SegmentList.header.width");
  refused((l) => { l.header.sensor = "s".repeat(64); }, "at most 63 bytes");
  refused((l) => { l.header.sensor = "a\0b"; }, "without NUL");
  refused((l) => { l.outcome = "GOOD"; }, "OUTCOME_SEGMENTED");
  refused((l) => { l.borders = [{ first: 1, second: 65536, kind: "BORDER_CONVEX" }]; },
    "SegmentList.borders[0].second");
  refused((l) => { delete l.header.pose; }, "SegmentList.header.pose");
  assert.throws(() => encode("Nonsense", {}), /the contract has no type 'Nonsense'/);
  assert.throws(() => decode("toString", new Uint8Array(8)), /the contract has no type/);
});
