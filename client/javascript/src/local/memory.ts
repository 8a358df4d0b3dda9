// SPDX-License-Identifier: BSD-3-Clause
// Memory of the library as arrays of JavaScript, and their end.
import type { Pointer } from "./functions.js";
import type { Koffi } from "./library.js";

// A reader of bytes takes the buffer that it is given away from all who look at it, at once; one
// at its end puts nothing in. ArrayBuffer.prototype.transfer, made for that, came with Node 22, and
// structuredClone copies such memory instead of moving it in Node 18.
const taker = new ReadableStream({
  type: "bytes", start: (controller) => controller.close(),
}).getReader({ mode: "byob" });

/** Leaves the buffer, and each array over it, empty: none reads its memory any more. */
export function detach(buffer: ArrayBuffer): void {
  if (buffer.byteLength > 0) void taker.read(new Uint8Array(buffer));
}

/** Whether the runtime lets arrays show foreign memory, and lets that be taken away from them. */
export function shows_memory(koffi: Koffi): boolean {
  const memory = koffi.alloc("uint8_t", 8) as Pointer;
  try {
    const buffer = koffi.view(memory, 8);
    detach(buffer);
    return buffer.byteLength === 0;
  } catch {
    return false;  // Electron refuses
  } finally {
    koffi.free(memory);
  }
}

/** The memory's buffer: the memory itself, or a copy of it. */
export function buffer_of(
  koffi: Koffi, address: Pointer, bytes: number, in_place: boolean,
): ArrayBuffer {
  if (bytes === 0) return new ArrayBuffer(0);
  if (in_place) return koffi.view(address, bytes);
  return (koffi.decode(address, "uint8_t", bytes) as Uint8Array).buffer as ArrayBuffer;
}
