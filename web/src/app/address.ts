// SPDX-License-Identifier: BSD-2-Clause

/** The state of a page, as the part of its address after #: "#lesson=02-operators&t=4.3&file=mower.soar". */
export interface Address {
  /** "lesson:NAME", "scenario:NAME", "recording:NAME" or "match:ID" of the arena; empty: lessons and worlds. */
  what: string;
  /** The moment that is shown, in seconds of the world; null: the newest. */
  seconds: number | null;
  /** The file in the editor, by its name; empty: the first. */
  file: string;
  /** A shared text for that file, packed; empty: none. */
  text: string;
  /** The files of an experiment, packed; empty: a run in the user's place. The fields below are for experiments. */
  rules: string;
  /** The seed of the run; null: the seed in its scenario file. */
  seed: number | null;
  /** The agent that *Why* explains; empty: none. */
  agent: string;
}

const NAMES = [["lesson", "lesson:"], ["world", "scenario:"], ["recording", "recording:"], ["match", "match:"]] as const;
const LONGEST_S = 3600;

export function parseAddress(hash: string): Address {
  const fields = new URLSearchParams(hash.replace(/^#/, ""));
  const found = NAMES.map(([field, kind]) => [kind, fields.get(field) ?? ""] as const).find(([, name]) => name !== "");
  const seconds = Number(fields.get("t") ?? ""), seed = fields.get("seed") ?? "";
  return {
    what: found === undefined ? "" : found[0] + found[1], file: fields.get("file") ?? "", text: fields.get("text") ?? "",
    seconds: fields.has("t") && Number.isFinite(seconds) && seconds >= 0 && seconds <= LONGEST_S ? seconds : null,
    rules: fields.get("rules") ?? "", seed: /^\d{1,15}$/.test(seed) ? Number(seed) : null, agent: fields.get("agent") ?? "",
  };
}

/** The fragment with #; empty for lessons and worlds. */
export function formatAddress({ what, seconds, file, text, rules, seed, agent }: Address): string {
  const fields = new URLSearchParams();
  for (const [field, kind] of NAMES) if (what.startsWith(kind)) fields.set(field, what.slice(kind.length));
  if ([...fields].length === 0) return "";
  if (seconds !== null) fields.set("t", String(Math.round(seconds * 1000) / 1000));
  if (file !== "") fields.set("file", file);
  if (text !== "") fields.set("text", text);
  if (seed !== null) fields.set("seed", String(seed));
  if (agent !== "") fields.set("agent", agent);
  if (rules !== "") fields.set("rules", rules);
  return `#${fields.toString()}`;
}

export const NOWHERE: Address = { what: "", seconds: null, file: "", text: "", rules: "", seed: null, agent: "" };

/** A text as a part of an address. */
export async function packText(text: string): Promise<string> {
  const bytes = new Uint8Array(await new Response(new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"))).arrayBuffer());
  let letters = "";
  for (const byte of bytes) letters += String.fromCharCode(byte);
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

const LONGEST_TEXT = 500_000;

/** The text that was packed; null: it is damaged, or too long. */
export async function unpackText(packed: string): Promise<string | null> {
  try {
    const bytes = Uint8Array.from(atob(packed.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
    const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")).getReader(), decoder = new TextDecoder("utf-8", { fatal: true });
    let text = "";
    for (;;) {
      const { done, value } = await reader.read();
      if (done) return text + decoder.decode();
      text += decoder.decode(value, { stream: true });
      if (text.length > LONGEST_TEXT) {
        await reader.cancel();
        return null;
      }
    }
  } catch {
    return null;
  }
}

/** The files of a lesson or world that differ from the program's. */
export interface ChangedFiles {
  /** Their folder in the place, ending with /. */
  folder: string;
  /** Their texts, by name relative to the folder. */
  files: Readonly<Record<string, string>>;
  /** The files that are not text. */
  leftOut: readonly string[];
}

const MOST_FILES = 100;

export async function packFiles(files: ChangedFiles["files"]): Promise<string> {
  return packText(JSON.stringify(files));
}

/** The files that were packed; null: they are damaged, too long, or have names outside the folder. */
export async function unpackFiles(packed: string): Promise<Record<string, string> | null> {
  try {
    const value: unknown = JSON.parse((await unpackText(packed)) ?? "null");
    if (typeof value !== "object" || value === null || Array.isArray(value)) return null;
    const files = Object.entries(value as Record<string, unknown>);
    const isGood = ([name, text]: [string, unknown]): boolean => typeof text === "string" && name.split("/").every((part) => part !== "" && !part.startsWith(".") && !/[\\\0]/.test(part));
    return files.length <= MOST_FILES && files.every(isGood) ? (value as Record<string, string>) : null;
  } catch {
    return null;
  }
}
