// SPDX-License-Identifier: BSD-2-Clause
// The notices of a bundle: Soarbox's own licence, and that of each package with code in it.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

/** Separates two notices. */
export const RULE = `\n${"-".repeat(72)}\n\n`;

/** The folders of packages with code in a bundle, according to esbuild's metafile. */
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
  return [ours, ...packagesIn(metafile).map(noticeOf)].join(RULE);
}

/** The notices of the libraries that the engine as WebAssembly contains. Throws if one is missing.
 * `sources`: their folder; `emscripten`: the compiler's folder. */
export function noticesOfEngine(sources, emscripten) {
  const debian = (name) => `/usr/share/doc/${name}/copyright`;
  const files = {
    "Bullet": join(sources, "bullet/LICENSE.txt"), "Recast and Detour": join(sources, "recastnavigation/License.txt"), "Lua 5.1": join(sources, "lua5.1/COPYRIGHT"),
    "zstd": join(sources, "libzstd/LICENSE"), "zlib": join(sources, "zlib/LICENSE"), "musl (the C library)": join(emscripten, "system/lib/libc/musl/COPYRIGHT"),
    "fmt": debian("libfmt-dev"), "JSON for Modern C++": debian("nlohmann-json3-dev"), "toml++": debian("libtomlplusplus-dev"), "CLI11 (the command only)": debian("libcli11-dev"),
  };
  const texts = Object.entries(files).map(([name, file]) => {
    if (!existsSync(file)) throw new Error(`${file}: the licence of ${name} is not there, and it has to be passed on`);
    return `${name}\n\n${readFileSync(file, "utf8").trim()}\n`;
  });
  return [...texts, "Emscripten's runtime: Copyright (c) 2010 to 2014 Emscripten authors, under the MIT licence as above (musl).\n", "SQLite is in the public domain. LLVM's C++ library: Apache 2.0 with LLVM's exception.\n"].join(RULE);
}
