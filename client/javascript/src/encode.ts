// SPDX-License-Identifier: BSD-3-Clause
// Values of the contract to bytes of DDS: plain CDR with its encapsulation.
import { type Types, schema } from "./contract.js";
import { type Basic, type Field, size_of, struct_of, to_byte_order, typed_array } from "./schema.js";

/** A value that the type does not hold; the message names the field. */
export class EncodeError extends Error {
  override name = "EncodeError";
}

const utf8 = new TextEncoder();
const ranges: Partial<Record<Basic, [number | bigint, number | bigint]>> = {
  int8: [-128, 127], uint8: [0, 255], int16: [-32768, 32767], uint16: [0, 65535],
  int32: [-2147483648, 2147483647], uint32: [0, 4294967295],
  int64: [-(2n ** 63n), 2n ** 63n - 1n], uint64: [0n, 2n ** 64n - 1n],
};

/**
 * The bytes of `value`, as they travel: what decode() reads. Throws an EncodeError when a field is
 * missing or holds what the contract's type does not.
 */
export function encode<Name extends keyof Types>(
  type: Name, value: Types[Name], byte_order: "little" | "big" = "little",
): Uint8Array {
  struct_of(schema, type);
  const sink = new Sink(byte_order === "little");
  write_struct(sink, type, value, type);
  return sink.finish();
}

class Sink {
  private bytes = new Uint8Array(1024);
  view = new DataView(this.bytes.buffer, 4);
  private at = 0;

  constructor(readonly little: boolean) {}

  /** Where `size` bytes of the alignment begin, zeroed. */
  room(size: number, alignment: number): number {
    const begin = Math.ceil(this.at / alignment) * alignment;
    this.at = begin + size;
    if (this.at > this.view.byteLength) {
      const larger = new Uint8Array(Math.max(2 * this.bytes.length, this.at + 8));
      larger.set(this.bytes);
      this.bytes = larger;
      this.view = new DataView(larger.buffer, 4);
    }
    return begin;
  }

  put(bytes: Uint8Array, size: number, alignment: number): void {
    const begin = this.room(size, alignment);
    this.bytes.set(bytes, begin + 4);
  }

  count(value: number): void {
    const at = this.room(4, 4);
    this.view.setUint32(at, value, this.little);
  }

  finish(): Uint8Array {
    this.bytes[1] = this.little ? 1 : 0;
    return this.bytes.slice(0, 4 + this.at);
  }
}

function write_struct(sink: Sink, name: string, value: unknown, path: string): void {
  if (typeof value !== "object" || value === null) {
    throw new EncodeError(`${path}: expected an object with the fields of ${name}`);
  }
  for (const field of struct_of(schema, name).fields) {
    const member = (value as Record<string, unknown>)[field.name];
    write_field(sink, field, member, `${path}.${field.name}`);
  }
}

function write_field(sink: Sink, field: Field, value: unknown, path: string): void {
  if (field.text) {
    write_text(sink, value, field.length ?? 0, path);
    return;
  }
  if (field.length === undefined && field.sequence === undefined) {
    write_one(sink, field, value, path);
    return;
  }
  if (!Array.isArray(value) && !ArrayBuffer.isView(value)) {
    throw new EncodeError(`${path}: expected an array`);
  }
  const values = value as ArrayLike<unknown>;
  if (field.length !== undefined && values.length !== field.length) {
    throw new EncodeError(`${path}: expected ${field.length} elements, found ${values.length}`);
  }
  if (typeof field.sequence === "number" && values.length > field.sequence) {
    throw new EncodeError(`${path}: ${values.length} elements, and ${field.sequence} are allowed`);
  }
  if (field.sequence !== undefined) sink.count(values.length);
  const own = typed_array[field.basic as keyof typeof typed_array];
  if (own !== undefined && value instanceof own && value.length > 0) {
    write_numbers(sink, value, value.BYTES_PER_ELEMENT);
    return;
  }
  for (let i = 0; i < values.length; ++i) write_one(sink, field, values[i], `${path}[${i}]`);
}

function write_one(sink: Sink, field: Field, value: unknown, path: string): void {
  if (field.struct !== undefined) write_struct(sink, field.struct, value, path);
  else if (field.enum !== undefined) write_word(sink, field.enum, value, path);
  else if (field.basic === "string") write_string(sink, value, path);
  else if (field.basic !== undefined) write_number(sink, field.basic, value, path);
}

function write_numbers(sink: Sink, numbers: ArrayBufferView, size: number): void {
  const bytes = new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength).slice();
  to_byte_order(bytes, size, sink.little);
  sink.put(bytes, bytes.length, size);
}

function write_word(sink: Sink, name: string, value: unknown, path: string): void {
  const words = schema.enums[name] ?? [];
  const found = words.find(([word]) => word === value);
  if (found === undefined) {
    throw new EncodeError(
      `${path}: expected one of ${words.map(([word]) => word).join(", ")}, found ${String(value)}`,
    );
  }
  sink.count(found[1]);
}

function utf8_without_nul(value: unknown, path: string): Uint8Array {
  if (typeof value !== "string" || value.includes("\0")) {
    throw new EncodeError(`${path}: expected a string without NUL`);
  }
  return utf8.encode(value);
}

function write_string(sink: Sink, value: unknown, path: string): void {
  const bytes = utf8_without_nul(value, path);
  sink.count(bytes.length + 1);
  sink.put(bytes, bytes.length + 1, 1);
}

function write_text(sink: Sink, value: unknown, length: number, path: string): void {
  const bytes = utf8_without_nul(value, path);
  if (bytes.length >= length) {
    throw new EncodeError(`${path}: at most ${length - 1} bytes, found ${bytes.length}`);
  }
  sink.put(bytes, length, 1);
}

function write_number(
  sink: Sink, basic: Exclude<Basic, "string">, value: unknown, path: string,
): void {
  check_number(basic, value, path);
  const at = sink.room(size_of[basic], size_of[basic]);
  const { view, little } = sink;
  switch (basic) {
    case "int8": return view.setInt8(at, value as number);
    case "uint8": return view.setUint8(at, value as number);
    case "bool": return view.setUint8(at, value === true ? 1 : 0);
    case "int16": return view.setInt16(at, value as number, little);
    case "uint16": return view.setUint16(at, value as number, little);
    case "int32": return view.setInt32(at, value as number, little);
    case "uint32": return view.setUint32(at, value as number, little);
    case "int64": return view.setBigInt64(at, value as bigint, little);
    case "uint64": return view.setBigUint64(at, value as bigint, little);
    case "float32": return view.setFloat32(at, value as number, little);
    case "float64": return view.setFloat64(at, value as number, little);
  }
}

function check_number(basic: Exclude<Basic, "string">, value: unknown, path: string): void {
  const big = basic === "int64" || basic === "uint64";
  const kind = basic === "bool" ? "boolean" : big ? "bigint" : "number";
  const range = ranges[basic];
  const whole = range === undefined || big || Number.isInteger(value);
  const inside = range === undefined ||
    ((value as number) >= range[0] && (value as number) <= range[1]);
  if (typeof value !== kind || !whole || !inside) {
    throw new EncodeError(`${path}: expected ${basic} (a ${kind}), found ${String(value)}`);
  }
}
