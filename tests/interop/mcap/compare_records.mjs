// SPDX-License-Identifier: BSD-3-Clause
// Reads every .mcap file of a folder with MCAP's own reader, as a stream and by its index, checks every
// CRC, and compares its messages, attachments and metadata with the list of the same name in another
// folder, one by one. Prints how many files are equal.
// Usage: node compare_records.mjs FOLDER LISTS
import { open, readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { FileHandleReadable } from "@mcap/nodejs";
import { loadDecompressHandlers } from "@mcap/support";

const decompressHandlers = await loadDecompressHandlers();
const compared = ["Message", "Attachment", "Metadata"];

// As the lists have it: every number is text, names are in lower case with '_', fields are sorted.
function plain(value) {
  if (value instanceof Map) return Object.fromEntries(value);
  if (value instanceof Uint8Array) return [...value].map(String);
  return typeof value === "string" ? value : String(value);
}

function listed(record) {
  const fields = Object.entries(record)
    .filter(([name]) => name !== "type")
    .map(([name, value]) => [name.replace(/[A-Z]/g, (c) => "_" + c.toLowerCase()), plain(value)]);
  return JSON.stringify([record.type, Object.fromEntries(fields.sort())]);
}

function expected(record) {
  return JSON.stringify([record.type, Object.fromEntries(record.fields.sort())]);
}

async function streamed(file) {
  const records = [];
  const reader = new McapStreamReader({ decompressHandlers, validateCrcs: true });
  reader.append(await readFile(file));
  for (let record; (record = reader.nextRecord()); ) {
    if (compared.includes(record.type)) records.push(listed(record));
  }
  if (!reader.done()) throw new Error(`${file}: does not end`);
  return records;
}

async function checkIndex(file, records) {
  const handle = await open(file);
  const reader = await McapIndexedReader.Initialize({
    readable: new FileHandleReadable(handle),
    decompressHandlers,
  });
  const count = async (iterator) => {
    let found = 0;
    for await (const _ of iterator) ++found;
    return found;
  };
  const found = {
    Message: await count(reader.readMessages({ validateCrcs: true })),
    Attachment: await count(reader.readAttachments({ validateCrcs: true })),
    Metadata: await count(reader.readMetadata()),
  };
  for (const type of compared) {
    const wanted = records.filter((record) => record.startsWith(`["${type}"`)).length;
    if (found[type] !== wanted) throw new Error(`${file}: ${found[type]} of ${type} by the index`);
  }
  await handle.close();
}

const [folder, lists] = process.argv.slice(2);
let equal = 0;
for (const name of (await readdir(folder)).filter((entry) => entry.endsWith(".mcap"))) {
  const list = JSON.parse(await readFile(join(lists, name.replace(/mcap$/, "json"))));
  const wanted = list.records.filter((record) => compared.includes(record.type)).map(expected);
  const found = await streamed(join(folder, name));
  if (JSON.stringify(found) !== JSON.stringify(wanted)) {
    throw new Error(`${name}: ${found} instead of ${wanted}`);
  }
  await checkIndex(join(folder, name), found);
  ++equal;
}
console.log(`${equal} files are equal`);
