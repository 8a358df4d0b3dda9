// SPDX-License-Identifier: BSD-3-Clause
// Values of every type that travels, and the golden files.
import { readFileSync, readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { gunzipSync } from "node:zlib";

import { schema } from "../dist/contract.js";
import { typed_array } from "../dist/schema.js";

// Those that no other type has as a field.
const parts = Object.values(schema.structs).flatMap(({ fields }) => fields.map((f) => f.struct));
export const topic_types = Object.keys(schema.structs).filter((name) => !parts.includes(name));
export const is_bulk = (type) => /Cloud|Map/.test(type);

// Pseudo-random and the same on every run.
export class Dice {
  constructor(seed) {
    this.state = seed;
  }
  below(limit) {
    this.state = (Math.imul(this.state, 1664525) + 1013904223) >>> 0;
    return Math.floor((this.state / 2 ** 32) * limit);
  }
}

function one(field, dice) {
  if (field.struct) return value_of(field.struct, dice);
  if (field.enum) return schema.enums[field.enum][dice.below(schema.enums[field.enum].length)][0];
  if (field.basic === "string") return [..."Küche 深度 🎥"].slice(0, dice.below(11)).join("");
  if (field.basic === "bool") return dice.below(2) === 1;
  if (field.basic.startsWith("float")) return Math.fround((dice.below(2000) - 1000) / 64);
  if (field.basic === "uint64") return 2n ** 64n - 1n - BigInt(dice.below(1000));
  if (field.basic === "int64") return -(2n ** 63n) + BigInt(dice.below(1000));
  const bits = Number(field.basic.replace(/\D/g, ""));
  return dice.below(2 ** bits) - (field.basic.startsWith("u") ? 0 : 2 ** (bits - 1));
}

function value_of_field(field, dice) {
  if (field.text) return "sensor_1/深度".slice(0, dice.below(11));
  if (field.length === undefined && field.sequence === undefined) return one(field, dice);
  const values = Array.from({ length: field.length ?? dice.below(5) }, () => one(field, dice));
  return field.basic in typed_array ? typed_array[field.basic].from(values) : values;
}

export function value_of(type, dice) {
  const { fields } = schema.structs[type];
  return Object.fromEntries(fields.map((field) => [field.name, value_of_field(field, dice)]));
}

const golden = fileURLToPath(new URL("../../../idl/golden/", import.meta.url));

// { type, name, bytes, json } of each golden file.
export function* golden_files() {
  for (const type of readdirSync(golden)) {
    const folder = `${golden}${type}/`;
    for (const file of readdirSync(folder).filter((each) => /\.cdr(\.gz)?$/.test(each))) {
      const read = readFileSync(folder + file);
      yield {
        type, name: `${type}/${file}`, byte_order: file.includes(".be.") ? "big" : "little",
        bytes: file.endsWith(".gz") ? gunzipSync(read) : read,
        json: JSON.parse(readFileSync(folder + file.replace(/\..*/, ".json"), "utf8")),
      };
    }
  }
}
