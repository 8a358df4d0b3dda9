// SPDX-License-Identifier: BSD-3-Clause
// What is called of cleave.h. Segment lists cross as CDR, so none of its structs is mirrored here
// but the options.
import type { LibraryHandle } from "koffi";

import type { Koffi } from "./library.js";

/** CLEAVE_ABI_VERSION of the cleave.h that this file follows. */
export const abi_version = 1;

/** A handle or an address. */
export type Pointer = bigint;
/** Where the library writes a result. */
export type Place<Value> = [Value | null];

/** As cleave_options. */
export interface OpenOptions {
  domain: number;
  shared_memory: 0 | 1;
  interface: string | null;
}

export interface Functions {
  cleave_open(options: OpenOptions, stream: Place<Pointer>): number;
  cleave_error(): string;
  cleave_close(stream: Pointer): void;
  cleave_uses_shared_memory(stream: Pointer, reason: Place<string>): number;
  cleave_frames_open(stream: Pointer, sensor: string, frames: Place<Pointer>): number;
  cleave_frames_close(frames: Pointer): void;
  cleave_frames_next(
    frames: Pointer, timeout_ms: number,
    cloud: Place<Pointer>, labels: Place<Pointer>, segments: Place<Pointer>,
  ): number;
  cleave_frames_fd(frames: Pointer): number;
  cleave_frames_given_up(frames: Pointer): number | bigint;
  cleave_release(sample: Pointer): void;
  cleave_sample_zero_copy(sample: Pointer): number;
  cleave_sample_cloud(sample: Pointer, xyz: Place<Pointer>, count: Place<number>): number;
  cleave_sample_labels(
    sample: Pointer, labels: Place<Pointer>, count: Place<number>, published_ns: null,
  ): number;
  cleave_encode(sample: Pointer, bytes: Place<Pointer>, size: Place<number>): number;
}

const prototypes = [
  "const char *cleave_error()",
  "void cleave_close(void *)",
  "int cleave_uses_shared_memory(void *, _Out_ const char **)",
  "int cleave_frames_open(void *, const char *, _Out_ void **)",
  "void cleave_frames_close(void *)",
  "int cleave_frames_next(void *, int32_t, _Out_ void **, _Out_ void **, _Out_ void **)",
  "int cleave_frames_fd(void *)",
  "uint64_t cleave_frames_given_up(void *)",
  "void cleave_release(void *)",
  "int cleave_sample_zero_copy(void *)",
  "int cleave_sample_cloud(void *, _Out_ void **, _Out_ size_t *)",
  "int cleave_sample_labels(void *, _Out_ void **, _Out_ size_t *, void *)",
  "int cleave_encode(void *, _Out_ void **, _Out_ size_t *)",
];

/** Throws where the library lacks one. */
export function declare(koffi: Koffi, library: LibraryHandle): Functions {
  // Without a name, for names are the process's, which may hold this package twice.
  const options = koffi.struct({
    domain: "int32_t", shared_memory: "int32_t", interface: "const char *",
  });
  const declared = new Map<string, unknown>();
  declared.set("cleave_open", library.func("cleave_open", "int",
    [koffi.pointer(options), koffi.out(koffi.pointer("void *"))]));
  for (const prototype of prototypes) {
    declared.set(/cleave_\w+/.exec(prototype)?.[0] ?? "", library.func(prototype));
  }
  return Object.fromEntries(declared) as unknown as Functions;
}
