// SPDX-License-Identifier: BSD-3-Clause
// Reads every message of a recording twice, by its index and as a stream, checks every CRC, and decodes
// each message by the schema in the file. Prints one JSON object: messages by topic.
// Usage: node read_all.mjs FILE
import { open } from "node:fs/promises";
import { createReadStream } from "node:fs";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { FileHandleReadable } from "@mcap/nodejs";
import { loadDecompressHandlers } from "@mcap/support";
import { parse } from "@foxglove/rosmsg";
import { MessageReader as RosReader } from "@foxglove/rosmsg2-serialization";
import { parseIDL } from "@foxglove/omgidl-parser";
import { MessageReader as IdlReader } from "@foxglove/omgidl-serialization";

function decoderOf(schema) {
  const text = new TextDecoder().decode(schema.data);
  if (schema.encoding === "ros2msg") return new RosReader(parse(text, { ros2: true }));
  if (schema.encoding === "omgidl") return new IdlReader(schema.name, parseIDL(text));
  throw new Error(`schema ${schema.name} has the encoding ${schema.encoding}`);
}

// What a viewer would trip over.
function check(topic, message) {
  const require = (holds, what) => {
    if (!holds) throw new Error(`${topic}: ${what}`);
  };
  if (topic.endsWith("/image")) {
    require(message.encoding === "16UC1", `encoding ${message.encoding}`);
    require(message.data.length === message.width * message.height * 2, "size of data");
    require(message.header.frame_id.length > 0, "no frame_id");
  } else if (topic.endsWith("/points")) {
    require(message.data.length === message.width * message.height * 12, "size of data");
  } else if (topic.endsWith("/camera_info")) {
    require(message.k[0] > 0 && message.p[0] === message.k[0], "no focal length");
  } else if (topic.endsWith("/segments")) {
    message.segments.forEach((s, i) => require(s.label === i + 1, `label ${s.label}`));
  } else if (topic.endsWith("/boxes")) {
    const [entity] = message.entities;
    require(entity.cubes.length === entity.texts.length, "cubes and texts");
    entity.cubes.forEach((c) => require(c.size.x >= 0 && c.color.a > 0, "a cube"));
  } else {
    require(message.header.width > 0, "no width");
  }
}

const file = process.argv[2];
const decompressHandlers = await loadDecompressHandlers();

const handle = await open(file);
const indexed = await McapIndexedReader.Initialize({
  readable: new FileHandleReadable(handle),
  decompressHandlers,
});
const decoders = new Map();
const counts = {};
for await (const message of indexed.readMessages({ validateCrcs: true })) {
  const channel = indexed.channelsById.get(message.channelId);
  if (!decoders.has(channel.schemaId)) {
    decoders.set(channel.schemaId, decoderOf(indexed.schemasById.get(channel.schemaId)));
  }
  check(channel.topic, decoders.get(channel.schemaId).readMessage(message.data));
  counts[channel.topic] = (counts[channel.topic] ?? 0) + 1;
}
const total = Object.values(counts).reduce((a, b) => a + b, 0);
if (BigInt(total) !== indexed.statistics.messageCount) {
  throw new Error(`${total} messages by the index, ${indexed.statistics.messageCount} announced`);
}
await handle.close();

let streamed = 0;
const stream = new McapStreamReader({ decompressHandlers, validateCrcs: true });
for await (const bytes of createReadStream(file)) {
  stream.append(bytes);
  for (let record; (record = stream.nextRecord()); ) {
    if (record.type === "Message") ++streamed;
  }
}
if (!stream.done() || streamed !== total) {
  throw new Error(`${streamed} messages as a stream, ${total} by the index`);
}
console.log(JSON.stringify(counts));
