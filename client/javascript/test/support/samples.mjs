// SPDX-License-Identifier: BSD-3-Clause
// A value of every type of the contract, whatever the contract holds, from a seed.
import { schema } from "../../dist/contract.js";
import { typed_array } from "../../dist/schema.js";

const limits = {
  int8: [-128, 127], uint8: [0, 255], int16: [-32768, 32767], uint16: [0, 65535],
  int32: [-2147483648, 2147483647], uint32: [0, 4294967295],
  int64: [-(2n ** 63n), 2n ** 63n - 1n], uint64: [0n, 2n ** 64n - 1n],
};

function one(field, random) {
  if (field.struct) return sample(field.struct, random);
  if (field.enum) return pick(schema.enums[field.enum].map(([word]) => word), random);
  if (field.basic === "string") return pick(["", "a", "no RouDi answers"], random);
  if (field.basic === "bool") return random() < 0.5;
  if (field.basic in limits) return pick(limits[field.basic], random);
  return pick([0, -1.5, 2 ** -20, 1e30, Infinity], random, field.basic);
}

function pick(choices, random, basic) {
  const choice = choices[Math.floor(random() * choices.length)];
  return basic === "float32" ? Math.fround(choice) : choice;
}

function many(field, random) {
  const count = field.length ?? Math.floor(random() * 4);
  const Typed = typed_array[field.basic];
  const values = Array.from({ length: count }, () => one(field, random));
  return Typed ? Typed.from(values) : values;
}

export function sample(name, random) {
  const value = {};
  for (const field of schema.structs[name].fields) {
    if (field.text) value[field.name] = pick(["", "camera", "x".repeat(field.length - 1)], random);
    else value[field.name] = field.length || field.sequence ? many(field, random) : one(field, random);
  }
  return value;
}

export function generator(seed) {
  let state = seed;
  return () => (state = (state * 1103515245 + 12345) % 2 ** 31) / 2 ** 31;
}

// Clouds of megabytes say nothing that a smaller type does not, and would slow the tests.
const bytes_of = (name) => schema.structs[name].fields.reduce((sum, field) =>
  sum + (field.struct ? bytes_of(field.struct) : 8) * (field.length ?? 1), 0);
export const small_types = Object.keys(schema.structs).filter((name) => bytes_of(name) < 100_000);
export const large_types = Object.keys(schema.structs).filter((name) => bytes_of(name) >= 100_000);
