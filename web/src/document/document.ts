// SPDX-License-Identifier: BSD-2-Clause
import type { DocumentNode } from "./nodes";

/** The document of a panel, as written by src/workbench/document/document_json.cpp: roles and keys, no colours or sizes. */
export type Document = readonly DocumentNode[];
export type * from "./nodes";

/** A request with its fields, and the panel that then comes to the front. */
export type Action = readonly [{ readonly request: string } & Readonly<Record<string, unknown>>, string?];

/** A plain text, or [text, role, action, hint]. A tick instead of the text is shown as a time that leads to the moment. */
export type Span = string | readonly [string | number, string?, (Action | null)?, string?];
export type Spans = string | readonly Span[];

/** The text of spans, without their actions and without times. */
export function plainText(spans: Spans): string {
  if (typeof spans === "string") return spans;
  return spans.map((span) => (typeof span === "string" ? span : typeof span[0] === "string" ? span[0] : "")).join("");
}
