// SPDX-License-Identifier: BSD-3-Clause
// The contract's IDL as TypeScript: an interface a struct, a union of words an enumeration, and the
// table that the codec walks. A changed IDL gives changed types; nothing here knows a type by name.
import { parseIDL } from "@foxglove/omgidl-parser";

const integers = ["int8", "uint8", "int16", "uint16", "int32", "uint32"];
const numbers = [...integers, "float32", "float64"];

// What the IDL says of each field in its trailing comment: { "Struct.field": text }.
function comments(idl) {
  const found = {};
  let struct = "";
  for (const line of idl.split("\n")) {
    struct = /\bstruct (\w+)/.exec(line)?.[1] ?? struct;
    const field = /(\w+)(?:\[\d+\])?;\s*\/\/ (.*)$/.exec(line);
    if (field) found[`${struct}.${field[1]}`] = field[2];
  }
  return found;
}

const last = (name) => name.split("::").at(-1);

function field_of(definition, struct) {
  const { name, type, arrayLengths, isArray } = definition;
  const refuse = (what) => {
    throw new Error(`${struct}.${name}: ${what} is not supported by this package's codec`);
  };
  if ((arrayLengths?.length ?? 0) > 1) refuse("an array of several dimensions");
  const field = { name };
  if (definition.enumType) field.enum = last(definition.enumType);
  else if (definition.isComplex) field.struct = last(type);
  else if (type === "wchar") field.text = true;
  else if ([...numbers, "int64", "uint64", "bool", "string"].includes(type)) field.basic = type;
  else refuse(`the type ${type}`);
  if (arrayLengths) field.length = arrayLengths[0];
  else if (isArray) field.sequence = definition.arrayUpperBound ?? true;
  if (field.text && !field.length) refuse("a single char");
  return field;
}

const typed_arrays = {
  int8: "Int8Array", uint8: "Uint8Array", int16: "Int16Array", uint16: "Uint16Array",
  int32: "Int32Array", uint32: "Uint32Array", float32: "Float32Array", float64: "Float64Array",
  int64: "BigInt64Array", uint64: "BigUint64Array",
};

function type_of(field) {
  if (field.text) return "string";
  const many = field.length !== undefined || field.sequence !== undefined;
  if (many && typed_arrays[field.basic]) return typed_arrays[field.basic];
  let one = field.enum ?? field.struct;
  if (numbers.includes(field.basic)) one = "number";
  else if (field.basic === "int64" || field.basic === "uint64") one = "bigint";
  else if (field.basic === "bool") one = "boolean";
  else if (field.basic === "string") one = "string";
  return many ? `${one}[]` : one;
}

// The parser makes one a module of constants.
function is_enumeration({ aggregatedKind, definitions }) {
  return aggregatedKind === "module" &&
    definitions.every(({ type, isConstant }) => type === "uint32" && isConstant);
}

export function generate(idl) {
  // The parser makes char and octet one type, and text is not bytes. The contract has no wchar.
  const definitions = parseIDL(idl.replace(/\/\/.*$/gm, "").replace(/\bchar\b/g, "wchar"));
  const notes = comments(idl);
  const structs = {}, enums = {};
  let out = "// SPDX-License-Identifier: BSD-3-Clause\n" +
    "// Generated from the contract's IDL by build/generate.mjs: change that.\n" +
    'import type { Schema } from "./schema.js";\n\n';
  for (const definition of definitions) {
    const name = last(definition.name);
    if (definition.aggregatedKind === "struct") {
      const fields = definition.definitions.map((each) => field_of(each, name));
      const keyed = definition.definitions.some((each) => each.annotations?.key !== undefined);
      structs[name] = { keyed, fields };
      out += `export interface ${name} {\n`;
      for (const field of fields) {
        const note = notes[`${name}.${field.name}`];
        if (note) out += `  /** ${note.replace("*/", "")} */\n`;
        out += `  ${field.name}: ${type_of(field)};\n`;
      }
      out += "}\n\n";
    } else if (is_enumeration(definition)) {
      enums[name] = definition.definitions.map((each) => [each.name, Number(each.value)]);
      out += `export type ${name} = ${enums[name].map(([word]) => `"${word}"`).join(" | ")};\n\n`;
    } else {
      throw new Error(`${definition.name}: this package's codec has no ${definition.aggregatedKind}`);
    }
  }
  const module = definitions[0].name.split("::").slice(0, -1);
  out += "/** Every type of the contract, by its name. */\nexport interface Types {\n";
  out += Object.keys(structs).map((name) => `  ${name}: ${name};\n`).join("") + "}\n\n";
  out += "/** The version of the contract that this package speaks. */\n";
  out += `export const contract = "${module.join("_")}";\n\n`;
  const table = { module: module.join("::"), structs, enums };
  return `${out}export const schema: Schema = ${JSON.stringify(table, null, 1)};\n`;
}
