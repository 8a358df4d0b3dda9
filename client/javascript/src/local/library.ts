// SPDX-License-Identifier: BSD-3-Clause
// Finds libcleave-c and loads it by koffi.
import { existsSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { LibraryError } from "../errors.js";
import { type Functions, abi_version, declare } from "./functions.js";

export type Koffi = typeof import("koffi");

export interface Library extends Functions {
  readonly koffi: Koffi;
}

const name = `libcleave-c.so.${abi_version}`;
const advice = "build it with `cmake --build --preset release --target cleave-c`, install it, or " +
  "set CLEAVE_LIBRARY to its path";
const words = ["OK", "TIMEOUT", "BAD_ARGUMENT", "NO_MEMORY", "BAD_DATA", "FAILED"];

function load_koffi(): Koffi {
  try {
    return createRequire(import.meta.url)("koffi") as Koffi;
  } catch (error) {
    throw new Error(
      "clouds and label maps are read through koffi 3, which does not load here: `npm install " +
      `koffi\` (${(error as Error).message.split("\n")[0]})`,
      { cause: error },
    );
  }
}

// Where the library may be; one that CLEAVE_LIBRARY names is the only one.
function candidates(): string[] {
  const named = process.env["CLEAVE_LIBRARY"];
  if (named) return [named];
  const checkout = fileURLToPath(new URL("../../../../", import.meta.url));
  const builds = join(checkout, "build");
  if (!existsSync(join(checkout, "idl")) || !existsSync(builds)) return [name];
  // Of several builds the optimised one; the last: as ld.so finds it.
  const presets = readdirSync(builds).sort();
  presets.sort((a, b) => Number(b === "release") - Number(a === "release"));
  return [...presets.map((preset) => join(builds, preset, "lib", name)).filter(existsSync), name];
}

function load(): Library {
  const koffi = load_koffi();
  const tried: string[] = [];
  for (const path of candidates()) {
    let handle;
    try {
      handle = koffi.load(path);
    } catch (error) {
      tried.push(`  ${path}: ${(error as Error).message}`);
      continue;
    }
    let found: number;
    try {
      found = handle.func("uint32_t cleave_abi_version()")() as number;
      if (found === abi_version) return { koffi, ...declare(koffi, handle) };
    } catch (error) {
      throw new Error(`${path} is no libcleave-c (${(error as Error).message}); ${advice}`);
    }
    throw new Error(
      `${path} has the C interface's version ${found}, and this package is made for version ` +
      `${abi_version}: use the package and the library of one release; ${advice}`,
    );
  }
  throw new Error(`found no ${name} that loads; ${advice}. Looked at:\n${tried.join("\n")}`);
}

let loaded: Library | undefined;

/** Loaded at the first call. Throws an Error that says why not, and what to do. */
export function library(): Library {
  loaded ??= load();
  return loaded;
}

/** Throws the LibraryError of a result that is not CLEAVE_OK. On the thread that failed. */
export function check({ cleave_error }: Functions, result: number): void {
  if (result !== 0) throw new LibraryError(cleave_error(), words[result] ?? String(result));
}
