// SPDX-License-Identifier: BSD-3-Clause
// The contract as a table, generated from the IDL: what the codec walks.
export type Basic =
  | "int8" | "uint8" | "int16" | "uint16" | "int32" | "uint32" | "int64" | "uint64"
  | "float32" | "float64" | "bool" | "string";

/** One of `basic`, `struct`, `enum` and `text` (an array of char) is there. */
export interface Field {
  name: string;
  basic?: Basic;
  struct?: string;
  enum?: string;
  text?: true;
  /** Of an array. */
  length?: number;
  /** A sequence, at most so long if a number. */
  sequence?: true | number;
}

export interface Struct {
  keyed: boolean;
  fields: Field[];
}

export interface Schema {
  module: string;
  structs: Record<string, Struct>;
  enums: Record<string, [word: string, value: number][]>;
}

export const size_of: Record<Exclude<Basic, "string">, number> = {
  int8: 1, uint8: 1, bool: 1, int16: 2, uint16: 2, int32: 4, uint32: 4, float32: 4,
  int64: 8, uint64: 8, float64: 8,
};

export const typed_array = {
  int8: Int8Array, uint8: Uint8Array, int16: Int16Array, uint16: Uint16Array, int32: Int32Array,
  uint32: Uint32Array, float32: Float32Array, float64: Float64Array, int64: BigInt64Array,
  uint64: BigUint64Array,
};
export type TypedArray = InstanceType<(typeof typed_array)[keyof typeof typed_array]>;

const little_endian_machine = new Uint8Array(new Uint16Array([1]).buffer)[0] === 1;

/** To or from this machine's byte order, in place: numbers of `size` bytes each. */
export function to_byte_order(bytes: Uint8Array, size: number, little: boolean): void {
  if (little === little_endian_machine) return;
  const view = Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (size === 2) view.swap16();
  if (size === 4) view.swap32();
  if (size === 8) view.swap64();
}

/** Fewest bytes that one element of the field takes: a length that claims more elements lies. */
export function smallest_element(schema: Schema, field: Field): number {
  if (field.struct !== undefined) return smallest(schema, field.struct);
  if (field.enum !== undefined) return 4;
  if (field.text) return 1;
  return field.basic === undefined || field.basic === "string" ? 4 : size_of[field.basic];
}

const sizes = new WeakMap<Struct, number>();

function smallest(schema: Schema, name: string): number {
  const struct = struct_of(schema, name);
  let size = sizes.get(struct);
  if (size === undefined) {
    size = 0;
    for (const field of struct.fields) {
      const many = field.length ?? 1;
      size += field.sequence !== undefined ? 4 : many * smallest_element(schema, field);
    }
    sizes.set(struct, size);
  }
  return size;
}

export function struct_of(schema: Schema, name: string): Struct {
  const struct = Object.hasOwn(schema.structs, name) ? schema.structs[name] : undefined;
  if (struct === undefined) {
    throw new TypeError(
      `the contract has no type '${name}'; it has ${Object.keys(schema.structs).join(", ")}`,
    );
  }
  return struct;
}
