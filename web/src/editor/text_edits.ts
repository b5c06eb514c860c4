// SPDX-License-Identifier: BSD-2-Clause

interface Position { line: number; character: number }
/** A change of a text as in the Language Server Protocol. Lines and characters count from 0. */
export interface TextEdit { range: { start: Position; end: Position }; newText: string }

/** The changes with offsets in the text. Positions beyond the end of a line or of the text are clamped. */
export function changesOf(text: string, edits: readonly TextEdit[]): { from: number; to: number; insert: string }[] {
  const lines = text.split("\n"), begins: number[] = [];
  let at = 0;
  for (const line of lines) {
    begins.push(at);
    at += line.length + 1;
  }
  const offset = ({ line, character }: Position): number => line >= lines.length ? text.length : begins[line]! + Math.min(character, lines[line]!.length);
  return edits.map(({ range, newText }) => ({ from: offset(range.start), to: offset(range.end), insert: newText })).sort((a, b) => a.from - b.from);
}

/** The text after the changes. */
export function edited(text: string, edits: readonly TextEdit[]): string {
  return changesOf(text, edits).reduceRight((result, { from, to, insert }) => result.slice(0, from) + insert + result.slice(to), text);
}

/** "/work/a b.soar" for "file:///work/a%20b.soar". */
export function pathOf(uri: string): string {
  return decodeURIComponent(uri.replace(/^file:\/\//, ""));
}
