// SPDX-License-Identifier: BSD-3-Clause
// Bytes of DDS (plain CDR, either byte order) to values of the contract.
import { type Types, schema } from "./contract.js";
import {
  type Basic, type Field, type TypedArray, size_of, smallest_element, struct_of, to_byte_order,
  typed_array,
} from "./schema.js";

/** Bytes that are not a message of the type. */
export class DecodeError extends Error {
  override name = "DecodeError";
}

const header_bytes = 4;
const utf8 = new TextDecoder("utf-8", { ignoreBOM: true });  // else it takes one away

type Value = unknown;

/**
 * The value of the contract's type `type` in `bytes`: a message as it travels, or as a recording
 * holds it, with its 4 bytes of encapsulation. Throws a DecodeError that names the field when the
 * bytes end early, when a length claims more than there is, when a word of an enumeration is not
 * known, or when bytes are left over. Allocates nothing for what is not there.
 */
export function decode<Name extends keyof Types>(type: Name, bytes: Uint8Array): Types[Name] {
  struct_of(schema, type);
  const cursor = new Cursor(type, bytes);
  const value = read_struct(cursor, type, type);
  if (cursor.left() > 3) {
    throw new DecodeError(`${type}: ${cursor.left()} bytes are left over (another contract?)`);
  }
  return value as Types[Name];
}

class Cursor {
  readonly little: boolean;
  readonly view: DataView;
  private at = 0;

  constructor(type: string, readonly bytes: Uint8Array) {
    const [first, second] = bytes;
    if (bytes.length < header_bytes || first !== 0 || (second !== 0 && second !== 1)) {
      throw new DecodeError(`${type}: does not begin as plain CDR does (00 00 or 00 01)`);
    }
    this.little = second === 1;
    this.view = new DataView(bytes.buffer, bytes.byteOffset + header_bytes,
      bytes.byteLength - header_bytes);
  }

  left(): number {
    return this.view.byteLength - this.at;
  }

  /** Where `size` bytes of the alignment begin, which are then behind the cursor. */
  take(size: number, alignment: number, path: string): number {
    const begin = Math.ceil(this.at / alignment) * alignment;
    if (begin + size > this.view.byteLength) {
      throw new DecodeError(
        `${path}: needs ${size} bytes at ${begin}, the message has ${this.view.byteLength}`,
      );
    }
    this.at = begin + size;
    return begin;
  }

  count(path: string): number {
    return this.view.getUint32(this.take(4, 4, path), this.little);
  }

  slice(size: number, alignment: number, path: string): Uint8Array {
    const begin = this.take(size, alignment, path);
    return new Uint8Array(this.view.buffer, this.view.byteOffset + begin, size);
  }
}

function read_struct(cursor: Cursor, name: string, path: string): Value {
  const value: Record<string, Value> = {};
  for (const field of struct_of(schema, name).fields) {
    value[field.name] = read_field(cursor, field, `${path}.${field.name}`);
  }
  return value;
}

function read_field(cursor: Cursor, field: Field, path: string): Value {
  if (field.length === undefined && field.sequence === undefined) {
    return read_one(cursor, field, path);
  }
  const count = field.length ?? cursor.count(path);
  if (typeof field.sequence === "number" && count > field.sequence) {
    throw new DecodeError(`${path}: ${count} elements, and the contract allows ${field.sequence}`);
  }
  if (count * smallest_element(schema, field) > cursor.left()) {
    throw new DecodeError(`${path}: claims ${count} elements, and ${cursor.left()} bytes are left`);
  }
  if (field.text) return read_text(cursor.slice(count, 1, path));
  if (field.basic !== undefined && field.basic in typed_array) {
    return read_numbers(cursor, field.basic as keyof typeof typed_array, count, path);
  }
  const values: Value[] = [];
  for (let i = 0; i < count; ++i) values.push(read_one(cursor, field, `${path}[${i}]`));
  return values;
}

function read_one(cursor: Cursor, field: Field, path: string): Value {
  if (field.struct !== undefined) return read_struct(cursor, field.struct, path);
  if (field.enum !== undefined) return read_word(cursor, field.enum, path);
  if (field.basic === undefined) throw new TypeError(`${path} has no type`);
  return field.basic === "string"
    ? read_string(cursor, path)
    : read_number(cursor, field.basic, path);
}

function read_word(cursor: Cursor, name: string, path: string): string {
  const value = cursor.count(path);
  const found = schema.enums[name]?.find(([, number]) => number === value);
  if (found === undefined) throw new DecodeError(`${path}: ${name} has no value ${value}`);
  return found[0];
}

function read_text(bytes: Uint8Array): string {
  const end = bytes.indexOf(0);
  return utf8.decode(end < 0 ? bytes : bytes.subarray(0, end));
}

// A length that counts the NUL at the end; 0 is some vendors' empty string.
function read_string(cursor: Cursor, path: string): string {
  const length = cursor.count(path);
  if (length === 0) return "";
  const bytes = cursor.slice(length, 1, path);
  if (bytes[length - 1] !== 0) throw new DecodeError(`${path}: a string without its NUL`);
  return utf8.decode(bytes.subarray(0, length - 1));
}

function read_number(cursor: Cursor, basic: Exclude<Basic, "string">, path: string): Value {
  const { view, little } = cursor;
  const at = cursor.take(size_of[basic], size_of[basic], path);
  switch (basic) {
    case "int8": return view.getInt8(at);
    case "uint8": return view.getUint8(at);
    case "int16": return view.getInt16(at, little);
    case "uint16": return view.getUint16(at, little);
    case "int32": return view.getInt32(at, little);
    case "uint32": return view.getUint32(at, little);
    case "int64": return view.getBigInt64(at, little);
    case "uint64": return view.getBigUint64(at, little);
    case "float32": return view.getFloat32(at, little);
    case "float64": return view.getFloat64(at, little);
    case "bool": return view.getUint8(at) !== 0;
  }
}

function read_numbers(
  cursor: Cursor, basic: keyof typeof typed_array, count: number, path: string,
): TypedArray {
  const size = size_of[basic];
  if (count === 0) return new typed_array[basic](0);  // which is not aligned
  const bytes = cursor.slice(count * size, size, path).slice();
  to_byte_order(bytes, size, cursor.little);
  return new typed_array[basic](bytes.buffer, 0, count);
}
