// SPDX-License-Identifier: BSD-3-Clause
// Another implementation of CDR, by the IDL alone, for what this package decodes and encodes.
import { readFileSync } from "node:fs";
import parser from "@foxglove/omgidl-parser";
import serialization from "@foxglove/omgidl-serialization";

import { schema } from "../../dist/contract.js";

const idl = readFileSync(new URL("../../dist/cleave_v1.idl", import.meta.url), "utf8");
const definitions = parser.parseIDL(idl);

// EncapsulationKind.CDR_BE and CDR_LE
export const kinds = { big: 0, little: 1 };

export function oracle_bytes(name, value, kind) {
  const writer = new serialization.MessageWriter(`${schema.module}::${name}`, definitions, { kind });
  return writer.writeMessage(plain(name, value));
}

export function oracle_value(name, bytes) {
  const reader = new serialization.MessageReader(`${schema.module}::${name}`, definitions);
  return reader.readMessage(bytes);
}

// As the oracle has values: words of enumerations are numbers, text is an array of bytes.
export function plain(name, value) {
  const result = {};
  for (const field of schema.structs[name].fields) {
    const member = value[field.name];
    if (field.text) {
      const bytes = new Uint8Array(field.length);
      bytes.set(new TextEncoder().encode(member));
      result[field.name] = bytes;
    } else if (Array.isArray(member)) {
      result[field.name] = member.map((each) => plain_one(field, each));
    } else {
      result[field.name] = plain_one(field, member);
    }
  }
  return result;
}

function plain_one(field, value) {
  if (field.struct) return plain(field.struct, value);
  return field.enum ? schema.enums[field.enum].find(([word]) => word === value)[1] : value;
}
