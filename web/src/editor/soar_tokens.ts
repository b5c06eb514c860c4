// SPDX-License-Identifier: BSD-2-Clause

/** Kinds of tokens, for colouring Soar text. There is no grammar, so incomplete rules are coloured, too. */
export interface SoarState { inRule: boolean; depth: number; expectsName: boolean; quote: string; atHead: boolean }

export const startState = (): SoarState => ({ inRule: false, depth: 0, expectsName: false, quote: "", atHead: false });

/** The parts of a line reader that are used (CodeMirror's StringStream has them). */
export interface Line {
  sol(): boolean;
  eatSpace(): boolean;
  match(pattern: RegExp): unknown;
  next(): string | void;
  skipToEnd(): void;
}

const FUNCTIONS = /^(?:write|crlf|halt|interrupt|make-constant-symbol|cmd|exec|log|concat|div|mod|abs|sqrt|sin|cos|atan2|int|float|deep-copy|timestamp|ifeq|strlen|force-learn|dont-learn)(?=[\s)])/;

function inQuotes(line: Line, state: SoarState): string {
  for (let c = line.next(); c !== undefined; c = line.next()) {
    if (c === "\\") line.next();
    else if (c === state.quote) {
      state.quote = "";
      break;
    }
  }
  return "string";
}

/** Reads one token and returns its kind; null: nothing to colour. */
export function soarToken(line: Line, state: SoarState): string | null {
  if (state.quote !== "") return inQuotes(line, state);
  const isStart = line.sol();
  if (line.eatSpace()) return null;
  const wasHead = state.atHead;
  state.atHead = false;
  if (line.match(/^#.*/) !== null) return "comment";
  if (line.match(/^\|/) !== null || (state.inRule && line.match(/^"/) !== null)) {
    state.quote = "|";
    return inQuotes(line, state);
  }
  if (!state.inRule) {
    if (line.match(/^(?:sp|gp)(?=\s*[{"\s])/) !== null) {
      state.inRule = state.expectsName = true;
      state.depth = 0;
      return "keyword";
    }
    if (isStart && line.match(/^[a-zA-Z][\w-]*/) !== null) return "keyword";
    if (line.match(/^[+-]?\d+(?:\.\d+)?(?![\w*-])/) !== null) return "number";
    if (line.match(/^[^\s#|]+/) === null) line.next();
    return null;
  }
  if (line.match(/^\{/) !== null) {
    state.depth += 1;
    return "brace";
  }
  if (line.match(/^\}/) !== null) {
    state.depth -= 1;
    if (state.depth <= 0) state.inRule = false;
    return "brace";
  }
  if (state.expectsName) {
    state.expectsName = false;
    if (line.match(/^[^\s({"}]+/) !== null) return "def";
  }
  if (line.match(/^-->/) !== null) return "arrow";
  if (line.match(/^\(/) !== null) {
    state.atHead = true;
    return "bracket";
  }
  if (line.match(/^\)/) !== null) return "bracket";
  if (wasHead && line.match(/^(?:state|impasse)(?![\w*-])/) !== null) return "keyword";
  if (wasHead && line.match(FUNCTIONS) !== null) return "function";
  if (line.match(/^:(?:o-support|i-support|template|chunk|default|interrupt)\b/) !== null) return "modifier";
  if (line.match(/^<[A-Za-z0-9_*$%&?/:+-]+>/) !== null) return "variable";
  if (line.match(/^-?\^(?:[A-Za-z0-9_*$%&?/:.-]|<[A-Za-z0-9_*-]+>|\|[^|]*\|)+/) !== null) return "attribute";
  if (line.match(/^(?:<<|>>|<=>|<>|<=|>=)/) !== null) return "operator";
  if (line.match(/^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?(?![\w*])/) !== null) return "number";
  if (line.match(/^[<>=!~&@+-](?![\w*-])/) !== null || line.match(/^[<>=!~&@]/) !== null) return "operator";
  if (line.match(/^[^\s(){}<>^|"#]+/) === null) line.next();
  return null;
}

/** A line of text that is read from left to right. */
export class TextLine implements Line {
  private at = 0;

  constructor(private readonly text: string) {}

  sol(): boolean {
    return this.at === 0;
  }

  eatSpace(): boolean {
    return this.match(/^\s+/) !== null;
  }

  match(pattern: RegExp): unknown {
    const found = pattern.exec(this.text.slice(this.at));
    if (found === null || found.index !== 0) return null;
    this.at += found[0].length;
    return found;
  }

  next(): string | undefined {
    const c = this.text[this.at];
    if (c !== undefined) this.at += 1;
    return c;
  }

  skipToEnd(): void {
    this.at = this.text.length;
  }

  get place(): number {
    return this.at;
  }

  get isDone(): boolean {
    return this.at >= this.text.length;
  }
}

/** Splits a text into pieces with their kinds, for colouring outside of an editor. Joined, the pieces are the text. */
export function soarPieces(text: string): { kind: string | null; text: string }[] {
  const state = startState(), pieces: { kind: string | null; text: string }[] = [];
  text.split("\n").forEach((one, i) => {
    if (i > 0) pieces.push({ kind: null, text: "\n" });
    for (const line = new TextLine(one); !line.isDone;) {
      const begin = line.place, kind = soarToken(line, state);
      pieces.push({ kind: kind === "def" ? "name" : kind, text: one.slice(begin, line.place) });
    }
  });
  return pieces;
}
