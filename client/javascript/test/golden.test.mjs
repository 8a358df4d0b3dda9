// SPDX-License-Identifier: BSD-3-Clause
// The golden files of idl/golden, which every language reads and writes alike.
import assert from "node:assert/strict";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { gunzipSync } from "node:zlib";

import { schema } from "../dist/contract.js";
import { DecodeError, decode, encode } from "../dist/index.js";
import { typed_array } from "../dist/schema.js";
import { generator } from "./support/samples.mjs";

const folder = process.env.CLEAVE_GOLDEN ?? new URL("../../../idl/golden", import.meta.url).pathname;
const mutations = 1000;

function cdr(type, sample, byte_order) {
  const file = `${folder}/${type}/${sample}.${byte_order}.cdr`;
  const bytes = existsSync(file) ? readFileSync(file) : gunzipSync(readFileSync(`${file}.gz`));
  return new Uint8Array(bytes);
}

// The contract's value for the JSON of a golden file.
function value_of(type, json) {
  const value = {};
  for (const field of schema.structs[type].fields) {
    value[field.name] = field_of(field, json[field.name]);
  }
  return value;
}

function field_of(field, json) {
  if (field.text || field.enum) return field.sequence ? json.map(String) : json;
  if (field.length) {  // behind the values that are given all are 0
    const values = new typed_array[field.basic](field.length);
    values.set(json.map((each) => one(field, each)));
    return values;
  }
  return field.sequence ? json.map((each) => one(field, each)) : one(field, json);
}

function one(field, json) {
  if (field.struct) return value_of(field.struct, json);
  if (field.basic === "int64" || field.basic === "uint64") return BigInt(json);
  if (field.basic === "float32") return Math.fround(Number(json));
  return field.basic === "float64" ? Number(json) : json;
}

for (const type of readdirSync(folder)) {
  for (const sample of ["empty", "extreme", "typical"]) {
    const value = value_of(type, JSON.parse(readFileSync(`${folder}/${type}/${sample}.json`, "utf8")));
    const little = cdr(type, sample, "le");
    const big = cdr(type, sample, "be");

    test(`golden ${type}, ${sample}: both byte orders are read as its JSON`, () => {
      assert.deepStrictEqual(decode(type, little), value);
      assert.deepStrictEqual(decode(type, big), value);
    });

    test(`golden ${type}, ${sample}: is written as the same bytes`, () => {
      assert.equal(Buffer.compare(encode(type, value), little), 0);
    });

    test(`golden ${type}, ${sample}: damaged, it is read or refused`, () => {
      const random = generator(9);
      const below = (limit) => Math.floor(random() * limit);
      for (const whole of [little, big]) {
        for (let i = 0; i < mutations; ++i) {
          // Of megabytes of numbers the header, for the sake of time.
          const bytes = whole.slice(0, whole.length > 100_000 ? below(400) : whole.length - below(9));
          for (let changes = below(4); changes > 0 && bytes.length > 0; --changes) {
            bytes[below(bytes.length)] = [0, 1, 0x7f, 0x80, 0xff, below(256)][below(6)];
          }
          try {
            decode(type, bytes);
          } catch (error) {
            assert.ok(error instanceof DecodeError, error.stack);
          }
        }
      }
    });
  }
}
