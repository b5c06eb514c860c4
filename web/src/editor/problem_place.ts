// SPDX-License-Identifier: BSD-2-Clause
import type { Problem } from "../run/contents";

export interface Place { from: number; to: number }
/** A problem with its exact range in the text. */
export type PlacedProblem = Problem & { place?: Place };

/** A diagnostic of the Language Server Protocol: lines from 0, characters in UTF-16 units. */
export interface LspDiagnostic {
  range: { start: { line: number; character: number }; end: { line: number; character: number } };
  severity?: number;
  message: string;
  data?: { hint?: string };
}

export function problemOf(told: LspDiagnostic, text: string): PlacedProblem {
  const lines = text.split("\n"), hint = told.data?.hint ?? "";
  const offset = ({ line, character }: { line: number; character: number }): number => {
    const index = Math.min(line, lines.length - 1);
    return lines.slice(0, index).reduce((sum, one) => sum + one.length + 1, 0) + Math.min(character, lines[index]!.length);
  };
  const from = offset(told.range.start), message = hint !== "" && told.message.endsWith(hint) ? told.message.slice(0, -hint.length).trim() : told.message;
  return {
    severity: told.severity === 1 ? "error" : told.severity === 2 ? "warning" : "note", message, line: told.range.start.line + 1, column: told.range.start.character + 1,
    place: { from, to: Math.max(offset(told.range.end), from) }, ...(hint === "" ? {} : { hint }),
  };
}

/** Merges both lists. Problems with the same line and text appear once. */
export function merged(first: readonly PlacedProblem[], second: readonly Problem[]): PlacedProblem[] {
  return [...first, ...second.filter((one) => !first.some((other) => other.line === one.line && (other.message === one.message || other.severity === "error")))];
}

/** The suggested word of a hint: "range" for "did you mean ^range?". Empty: the hint has no such word. */
export function meantBy(hint: string): string {
  const begin = "did you mean ", at = hint.indexOf(begin);
  if (at < 0) return "";
  const rest = hint.slice(at + begin.length), end = rest.indexOf("?");
  if (end < 0) return "";
  let meant = rest.slice(0, end);
  if (meant.length > 1 && meant.startsWith("'") && meant.endsWith("'")) meant = meant.slice(1, -1);
  if (meant.startsWith("^")) meant = meant.slice(1);
  return /[\s,]/.test(meant) ? "" : meant;
}

/** The number of characters that an excerpt underlines; 0: it has no underline. */
function underlined(excerpt: string | undefined): number {
  return /\^~*\s*$/.exec(excerpt ?? "")?.[0].trim().length ?? 0;
}

/** Range of a problem in the text. Lines and columns (of bytes, from 1) may be from an older text and are clamped. */
export function placeOf(problem: PlacedProblem, text: string): Place {
  if (problem.place !== undefined && problem.place.to <= text.length) return problem.place;
  const lines = text.split("\n"), index = Math.min(Math.max((problem.line ?? 1) - 1, 0), lines.length - 1), line = lines[index] ?? "";
  const begin = lines.slice(0, index).reduce((sum, one) => sum + one.length + 1, 0);
  if (problem.column === undefined || problem.column < 1) {
    const indent = line.length - line.trimStart().length;
    return { from: begin + indent, to: begin + line.length };
  }
  const column = Math.min(fromBytes(line, problem.column - 1), line.length);
  const word = /^[^\s(){}]+/.exec(line.slice(column))?.[0].length ?? 0;
  const length = underlined(problem.excerpt) > 1 ? underlined(problem.excerpt) : word;
  return { from: begin + column, to: Math.min(begin + column + Math.max(length, 1), begin + line.length) };
}

function fromBytes(line: string, bytes: number): number {
  let at = 0;
  for (const c of line) {
    if (bytes <= 0) break;
    const code = c.codePointAt(0) ?? 0;
    bytes -= code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    at += c.length;
  }
  return at;
}

export interface Remedy { from: number; to: number; insert: string }

/** The edit that a hint offers; null: it offers none. */
export function remedyOf(problem: PlacedProblem, text: string): Remedy | null {
  const meant = meantBy(`${problem.message} ${problem.hint ?? ""}`);
  if (meant === "") return null;
  let { from, to } = placeOf(problem, text);
  const there = text.slice(from, to);
  if (there.startsWith("-^")) from += 2;
  else if (there.startsWith("^")) from += 1;
  else if (there.startsWith("<") && !meant.startsWith("<")) return null;
  const rest = text.slice(from, to);
  // Replaces only the wrong part of a path. If it is not marked, this is the last part.
  const dot = rest.lastIndexOf(".");
  if (dot >= 0 && !meant.includes(".")) from += dot + 1;
  return text.slice(from, to) === meant || from === to ? null : { from, to, insert: meant };
}
