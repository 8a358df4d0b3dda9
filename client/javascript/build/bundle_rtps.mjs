// SPDX-License-Identifier: BSD-3-Clause
// @foxglove/rtps as one ES module, from its TypeScript sources: compiled as CommonJS it looks for
// default exports that `avl` and `eventemitter3` do not have. Whoever installs the package gets no
// dependencies at all.
import { build } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";

// A keyed topic needs a reader that says that it is keyed, which version 1.6.0 cannot.
const changes = {
  "src/Participant.ts": [
    ["makeEntityId(subscriptionId, EntityKind.AppdefReaderNoKey)",
     "makeEntityId(subscriptionId, (opts as { keyed?: boolean }).keyed === true" +
     " ? EntityKind.AppdefReaderWithKey : EntityKind.AppdefReaderNoKey)"],
  ],
};

export async function bundle_rtps(root, outfile) {
  const require = createRequire(join(root, "package.json"));
  const rtps = dirname(dirname(require.resolve("@foxglove/rtps")));
  const applied = new Set();
  const patch = {
    name: "patch",
    setup(esbuild) {
      esbuild.onLoad({ filter: /Participant\.ts$/ }, ({ path }) => {
        const file = path.slice(rtps.length + 1);
        let contents = readFileSync(path, "utf8");
        for (const [from, to] of changes[file] ?? []) {
          if (!contents.includes(from)) {
            throw new Error(`${path} has no "${from}": another version?`);
          }
          contents = contents.replace(from, to);
          applied.add(file);
        }
        return { contents, loader: "ts" };
      });
    },
  };
  const { metafile } = await build({
    entryPoints: [join(rtps, "src/index.ts")], outfile, bundle: true, platform: "node",
    format: "esm", target: "node18", metafile: true, absWorkingDir: root, plugins: [patch],
    logLevel: "warning",
  });
  for (const file of Object.keys(changes)) {
    if (!applied.has(file)) throw new Error(`${file} of @foxglove/rtps is not in the bundle`);
  }
  writeFileSync(`${outfile}.LICENSES.txt`, licences(root, Object.keys(metafile.inputs)));
}

// What is bundled keeps its authors' terms beside it.
function licences(root, inputs) {
  const folders = new Set(inputs.map((file) =>
    /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(file)?.[0]).filter(Boolean));
  let text = "rtps.js holds these packages:\n";
  for (const folder of [...folders].sort()) {
    const read = (file) => readFileSync(join(root, folder, file), "utf8");
    const { name, version, license } = JSON.parse(read("package.json"));
    text += `\n---- ${name} ${version} (${license})\n\n${read("LICENSE")}`;
  }
  return text;
}
