// SPDX-License-Identifier: BSD-2-Clause
import { HighlightStyle, StreamLanguage, syntaxHighlighting } from "@codemirror/language";
import { Tag, tags } from "@lezer/highlight";
import { soarToken, startState, type SoarState } from "./soar_tokens";

const arrow = Tag.define();

export const soarLanguage = StreamLanguage.define<SoarState>({
  name: "soar",
  startState,
  copyState: (state) => ({ ...state }),
  token: (stream, state) => soarToken(stream as unknown as Parameters<typeof soarToken>[0], state),
  languageData: { commentTokens: { line: "#" }, closeBrackets: { brackets: ["(", "{", "|"] }, wordChars: "*-_" },
  tokenTable: {
    arrow, brace: tags.brace, bracket: tags.paren, function: tags.function(tags.name),
  },
});

/** Class names of tokens. The page's style sheet defines their colours, for light and dark. */
export const soarColors = syntaxHighlighting(HighlightStyle.define([
  { tag: tags.comment, class: "tok-comment" }, { tag: tags.string, class: "tok-string" }, { tag: tags.number, class: "tok-number" },
  { tag: tags.keyword, class: "tok-keyword" }, { tag: tags.variableName, class: "tok-variable" }, { tag: tags.attributeName, class: "tok-attribute" },
  { tag: tags.operator, class: "tok-operator" }, { tag: arrow, class: "tok-arrow" }, { tag: tags.definition(tags.variableName), class: "tok-name" },
  { tag: tags.function(tags.name), class: "tok-function" }, { tag: tags.modifier, class: "tok-modifier" },
]));
