// SPDX-License-Identifier: BSD-3-Clause
// The contract's golden files: read to their JSON, and written back to their bytes.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { gunzipSync } from "node:zlib";

import { DecodeError, decode, encode } from "../dist/index.js";
import { generator } from "./support/samples.mjs";

const folder = new URL("../../../idl/golden/", import.meta.url);
const read = (name) => {
  const bytes = readFileSync(new URL(name, folder));
  return name.endsWith(".gz") ? gunzipSync(bytes) : bytes;
};
const words = { NaN: NaN, Infinity: Infinity, "-Infinity": -Infinity };

// That `value` is what the JSON says: integers of 64 bits are text there, and of an array's values
// those that are not 0.
function check(value, json, path) {
  if (typeof value === "bigint") return assert.equal(value.toString(), json, path);
  if (typeof value === "number") {
    const expected = typeof json === "string" ? words[json] : (json ?? NaN);
    const same = Object.is(value, expected) || Object.is(value, Math.fround(expected));
    return assert.ok(same || value === expected, `${path}: ${value}, not ${json}`);
  }
  if (typeof value === "string") return assert.equal(value, json, path);
  if (ArrayBuffer.isView(value)) {
    json.forEach((element, i) => check(value[i], element, `${path}[${i}]`));
    assert.ok(value.subarray(json.length).every((element) => element === 0), path);
    return undefined;
  }
  if (Array.isArray(value)) {
    assert.equal(value.length, json.length, path);
    return value.forEach((element, i) => check(element, json[i], `${path}[${i}]`));
  }
  assert.deepEqual(Object.keys(value), Object.keys(json), path);
  for (const [key, member] of Object.entries(value)) check(member, json[key], `${path}.${key}`);
  return undefined;
}

for (const type of readdirSync(folder).filter((name) => /^[A-Z]\w+$/.test(name))) {
  const files = readdirSync(new URL(`${type}/`, folder));
  for (const file of files.filter((name) => name.includes(".cdr"))) {
    const json = JSON.parse(read(`${type}/${file.split(".")[0]}.json`).toString());

    test(`golden ${type}/${file} is read as its JSON`, () => {
      check(decode(type, read(`${type}/${file}`)), json, type);
    });
    if (file.includes(".le.")) {
      test(`golden ${type}/${file} is written back to its bytes`, () => {
        const bytes = read(`${type}/${file}`);
        const again = encode(type, decode(type, bytes));
        assert.ok(Buffer.from(again).equals(bytes));
      });
    }
    if (!file.endsWith(".gz")) {
      test(`golden ${type}/${file}, damaged a thousand times, is an error or a value`, () => {
        const random = generator(5);
        const below = (limit) => Math.floor(random() * limit);
        for (let i = 0; i < 1000; ++i) {
          const bytes = Buffer.from(read(`${type}/${file}`));
          for (let n = 0; n < 3; ++n) bytes[below(bytes.length)] = below(256);
          try {
            decode(type, bytes.subarray(0, below(bytes.length + 1)));
          } catch (error) {
            assert.ok(error instanceof DecodeError, `${error}`);
          }
        }
      });
    }
  }
}
