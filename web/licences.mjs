// SPDX-License-Identifier: BSD-2-Clause
// The notices of a bundle: Soarbox's own licence, and that of each package with code in it.
import { existsSync, readFileSync, readdirSync } from "node:fs";

/** Folders of the packages from which a bundle took code, by esbuild's metafile. */
export function packagesIn(metafile) {
  const folders = new Set();
  for (const output of Object.values(metafile.outputs))
    for (const [path, { bytesInOutput }] of Object.entries(output.inputs)) {
      const folder = /^(?:.*\/)?node_modules\/(?:@[^/]+\/)?[^/]+/.exec(path);
      if (folder && bytesInOutput > 0) folders.add(folder[0]);
    }
  return [...folders].sort();
}

/** Name, version and licence of a package, and the text of its licence. Throws if the package has none. */
function noticeOf(folder) {
  const { name, version, license } = JSON.parse(readFileSync(`${folder}/package.json`, "utf8"));
  const file = readdirSync(folder).find((entry) => /^licen[cs]e(\.|$)/i.test(entry));
  if (!license || !file) throw new Error(`${folder}: this package has no licence that could be passed on`);
  return `${name} ${version} (${license})\n\n${readFileSync(`${folder}/${file}`, "utf8").trim()}\n`;
}

/** All notices for this bundle, as plain text. `own`: the file with Soarbox's licence. */
export function noticesFor(metafile, own = "../LICENSE") {
  if (!existsSync(own)) throw new Error(`${own}: there is no such file`);
  const ours = `Soarbox (BSD-2-Clause)\n\n${readFileSync(own, "utf8").trim()}\n`;
  return [ours, ...packagesIn(metafile).map(noticeOf)].join(`\n${"-".repeat(72)}\n\n`);
}
