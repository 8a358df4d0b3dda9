// SPDX-License-Identifier: BSD-3-Clause
import assert from "node:assert/strict";
import { test } from "node:test";

import { generate } from "../build/generate.mjs";
import { ContractError, contract, encode } from "../dist/index.js";
import { schema } from "../dist/contract.js";
import { status_of } from "../dist/statuses.js";
import { generator, sample } from "./support/samples.mjs";

const named = schema.structs.NodeStatus.fields.some(({ name }) => name === "contract");
const status = (change = {}) => ({ ...sample("NodeStatus", generator(4)), ...(named && { contract }), ...change });

test("a status of the same contract is read", () => {
  assert.deepEqual(status_of(encode("NodeStatus", status())), status());
});

test("a node of another contract is named and refused", { skip: !named && "the contract does not say which it is" }, () => {
  const other = status({ node: "segmenter/left", contract: "cleave_v2" });
  assert.throws(() => status_of(encode("NodeStatus", other)), (error) =>
    error instanceof ContractError && error.node === "segmenter/left" && /^segmenter\/left speaks .*cleave_v2.*cleave_v1/.test(error.message));
});

test("a status of another shape is refused as of another contract", () => {
  const bytes = encode("NodeStatus", status());
  const longer = new Uint8Array(bytes.length + 12);
  longer.set(bytes);
  for (const wrong of [longer, bytes.subarray(0, bytes.length - 20)]) {
    assert.throws(() => status_of(wrong), ContractError);
  }
});

const idl = (body) => `module lib { module v3 { ${body} }; };`;

test("another IDL gives other types and another contract", () => {
  const text = generate(idl(`
    enum Kind { KIND_A, KIND_B };
    @final struct Message {
      @key string name;  // who
      unsigned long long count;
      Kind kind;
      char text[8];
      octet raw[4];
      sequence<octet> bytes;
      sequence<float> numbers;
      sequence<string> words;
      boolean yes;
    };`));
  for (const line of ['contract = "lib_v3"', '"module": "lib::v3"', 'type Kind = "KIND_A" | "KIND_B"', "/** who */",
    "count: bigint;", "kind: Kind;", "text: string;", "raw: Uint8Array;", "bytes: Uint8Array;",
    "numbers: Float32Array;", "words: string[];", "yes: boolean;", '"keyed": true']) {
    assert.ok(text.includes(line), `${line}\n${text}`);
  }
});

test("what the codec cannot carry is refused when the types are generated", () => {
  for (const member of ["float grid[2][3];", "char letter;", "wstring wide;"]) {
    assert.throws(() => generate(idl(`struct Message { ${member} };`)), /Message\.\w+: .*not supported/);
  }
});
