// SPDX-License-Identifier: BSD-3-Clause
// Types from the contract, then tsc, then what is bundled: dist/ is the package.
import { spawnSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

import { bundle_rtps } from "./bundle_rtps.mjs";
import { generate } from "./generate.mjs";

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const repository = join(root, "..", "..");
const idl = join(repository, "idl", "cleave_v1.idl");
const dist = join(root, "dist");

rmSync(dist, { recursive: true, force: true });
mkdirSync(join(dist, "vendor"), { recursive: true });
writeFileSync(join(root, "src", "contract.ts"), generate(readFileSync(idl, "utf8")));
copyFileSync(idl, join(dist, "cleave_v1.idl"));
copyFileSync(join(repository, "LICENSE"), join(root, "LICENSE"));
await bundle_rtps(root, join(dist, "vendor", "rtps.js"));
const tsc = join(root, "node_modules", "typescript", "bin", "tsc");
const { status } = spawnSync(process.execPath, [tsc, "-p", root], { stdio: "inherit" });
process.exitCode = status ?? 1;
