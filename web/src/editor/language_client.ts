// SPDX-License-Identifier: BSD-2-Clause
import type { Completion, CompletionContext, CompletionResult, CompletionSource } from "@codemirror/autocomplete";
import { hoverTooltip } from "@codemirror/view";
import type { Run } from "../run/run";
import type { LspDiagnostic } from "./problem_place";
import { wordAt } from "./soar_words";
import { pathOf, type TextEdit } from "./text_edits";

const ANSWER_MS = 8000;
const NO_HELP = "The help with rules does not answer. Try again when the page is connected.";

interface Answer { id?: number; result?: unknown; error?: unknown }
interface LspItem { label: string; kind?: number; detail?: string; documentation?: string | { value: string }; insertText?: string; textEdit?: { newText: string } }

const TYPES: Readonly<Record<number, string>> = { 3: "function", 5: "property", 6: "variable", 12: "constant", 14: "keyword", 21: "constant", 22: "class" };

/** The result of an answer. Throws an error with the server's text if the request was refused. */
function resultOf<T>(answer: Answer | null): T {
  if (answer === null) throw new Error(NO_HELP);
  if (answer.error !== undefined) throw new Error((answer.error as { message?: string }).message ?? "This was refused.");
  return answer.result as T;
}

/** Client of the language server, over the run's connection: problems in the text, and completions at the caret. */
export class LanguageClient {
  /** The problems of the current file; null: none were reported yet. */
  diagnostics: readonly LspDiagnostic[] | null = null;
  private next = 1;
  private readonly waiting = new Map<number, (answer: Answer) => void>();
  private started: Promise<boolean> | null = null;
  private uri = "";
  private version = 0;
  private told = "";

  constructor(private readonly run: Run, private readonly changed: () => void) {
    run.on("language", (content) => this.take(content as Answer & { method?: string; params?: { uri?: string; diagnostics?: LspDiagnostic[] } }));
    run.on("hello", () => {
      this.started = null;
      this.uri = "";
      this.diagnostics = null;
    });
  }

  /** Switches to another file. */
  look(file: string, text: string): void {
    const uri = `file://${encodeURI(file)}`;
    if (uri !== this.uri) {
      this.uri = uri;
      this.version = 0;
      this.told = "";
      this.diagnostics = null;
    }
    void this.tell(text);
  }

  /** The current text. */
  async tell(text: string): Promise<boolean> {
    if (this.uri === "" || !(await this.start())) return false;
    this.version += 1;
    this.told = text;
    if (this.version === 1) this.send({ method: "textDocument/didOpen", params: { textDocument: { uri: this.uri, languageId: "soar", version: 1, text } } });
    else this.send({ method: "textDocument/didChange", params: { textDocument: { uri: this.uri, version: this.version }, contentChanges: [{ text }] } });
    return true;
  }

  /** The completions at a position; null: no answer came, or there are none. */
  async complete(text: string, line: number, character: number): Promise<LspItem[] | null> {
    if (!(await this.tell(text))) return null;
    const answer = await this.ask("textDocument/completion", { textDocument: { uri: this.uri }, position: { line, character } });
    const result = answer?.result as LspItem[] | { items: LspItem[] } | null | undefined;
    if (result === null || result === undefined) return null;
    return Array.isArray(result) ? result : result.items;
  }

  /** The explanation of the word at a position, in the protocol's simple markdown; empty: none. */
  async hover(text: string, line: number, character: number): Promise<string> {
    if (text !== this.told && !(await this.tell(text))) return "";
    const answer = await this.ask("textDocument/hover", { textDocument: { uri: this.uri }, position: { line, character } });
    const contents = (answer?.result as { contents?: string | { value?: string } } | null | undefined)?.contents;
    return typeof contents === "string" ? contents : (contents?.value ?? "");
  }

  /** The changes that format the text. */
  async format(text: string): Promise<readonly TextEdit[]> {
    if (!(await this.tell(text))) throw new Error(NO_HELP);
    return resultOf<readonly TextEdit[] | null>(await this.ask("textDocument/formatting", { textDocument: { uri: this.uri }, options: { tabSize: 3, insertSpaces: true } })) ?? [];
  }

  /** The name at a place that can be renamed; null: there is none. */
  async nameAt(text: string, line: number, character: number): Promise<string | null> {
    if (!(await this.tell(text))) throw new Error(NO_HELP);
    return resultOf<{ placeholder: string } | null>(await this.ask("textDocument/prepareRename", { textDocument: { uri: this.uri }, position: { line, character } }))?.placeholder ?? null;
  }

  /** The changes of each file that rename the name at a position. */
  async rename(text: string, line: number, character: number, newName: string): Promise<{ path: string; edits: readonly TextEdit[] }[]> {
    if (!(await this.tell(text))) throw new Error(NO_HELP);
    const result = resultOf<{ changes?: Readonly<Record<string, readonly TextEdit[]>> } | null>(await this.ask("textDocument/rename", { textDocument: { uri: this.uri }, position: { line, character }, newName }));
    return Object.entries(result?.changes ?? {}).map(([uri, edits]) => ({ path: pathOf(uri), edits }));
  }

  /** The definition of the name at a position; lines count from 1. */
  async definition(text: string, line: number, character: number): Promise<{ path: string; line: number } | null> {
    if (!(await this.tell(text))) throw new Error(NO_HELP);
    const [first] = resultOf<readonly { uri: string; range: TextEdit["range"] }[] | null>(await this.ask("textDocument/definition", { textDocument: { uri: this.uri }, position: { line, character } })) ?? [];
    return first === undefined ? null : { path: pathOf(first.uri), line: first.range.start.line + 1 };
  }

  private take(content: Answer & { method?: string; params?: { uri?: string; diagnostics?: LspDiagnostic[] } }): void {
    if (content.method === "textDocument/publishDiagnostics" && content.params !== undefined) {
      if (decodeURI(content.params.uri ?? "") !== decodeURI(this.uri)) return;
      this.diagnostics = content.params.diagnostics ?? [];
      this.changed();
      return;
    }
    if (typeof content.id !== "number") return;
    this.waiting.get(content.id)?.(content);
    this.waiting.delete(content.id);
  }

  /** An earlier page may have started the server. Its refusal to start again is a valid answer. */
  private start(): Promise<boolean> {
    this.started ??= this.ask("initialize", { processId: null, rootUri: null, capabilities: {} }).then((answer) => {
      if (answer === null) return false;
      if (answer.result !== undefined) this.send({ method: "initialized", params: {} });
      return true;
    });
    return this.started;
  }

  private ask(method: string, params: unknown): Promise<Answer | null> {
    const id = this.next++;
    return new Promise((resolve) => {
      const timer = setTimeout(() => {
        this.waiting.delete(id);
        resolve(null);
      }, ANSWER_MS);
      this.waiting.set(id, (answer) => {
        clearTimeout(timer);
        resolve(answer);
      });
      this.send({ id, method, params });
    });
  }

  private send(message: object): void {
    if (this.run.connection === "open" && this.run.hello?.may_edit !== false) this.run.ask("language", { message: { jsonrpc: "2.0", ...message } });
  }
}

/** Start of the word that is being typed: after ^ and dots, or at the first character of a name. */
export function wordBefore(line: string): number {
  return line.length - (/[\w*<>-]*$/.exec(line)?.[0].length ?? 0);
}

export function completeWith(client: LanguageClient): CompletionSource {
  return async (context: CompletionContext): Promise<CompletionResult | null> => {
    const line = context.state.doc.lineAt(context.pos), typed = line.text.slice(0, context.pos - line.from), last = typed.at(-1) ?? "";
    const start = wordBefore(typed);
    if (!context.explicit && !/[\^.<]/.test(last) && start === typed.length) return null;
    const items = await client.complete(context.state.doc.toString(), line.number - 1, typed.length);
    if (items === null || context.aborted) return null;
    return {
      from: line.from + start, validFor: /^[\w*<>-]*$/,
      options: items.map((item): Completion => {
        const about = typeof item.documentation === "string" ? item.documentation : (item.documentation?.value ?? "");
        return {
          label: item.label, apply: item.textEdit?.newText ?? item.insertText ?? item.label, ...(item.detail === undefined ? {} : { detail: item.detail }),
          ...(about === "" ? {} : { info: about }), type: TYPES[item.kind ?? 0] ?? "text",
        };
      }),
    };
  };
}

/** A line of an explanation of the language server: **bold**, `code`, and text between them. */
export function wordsOf(line: string): { text: string; kind: "bold" | "code" | "" }[] {
  return line.split(/(\*\*[^*]+\*\*|`[^`]*`)/).filter((one) => one !== "").map((one) =>
    one.startsWith("**") && one.length > 4 ? { text: one.slice(2, -2), kind: "bold" } : one.startsWith("`") && one.length > 1 ? { text: one.slice(1, -1), kind: "code" } : { text: one, kind: "" });
}

/** Explains the word under the mouse. */
export function hoverWith(client: LanguageClient): ReturnType<typeof hoverTooltip> {
  return hoverTooltip(async (view, pos) => {
    const line = view.state.doc.lineAt(pos), word = view.state.wordAt(pos);
    // A beginner's word is explained here; names and percepts by the language server.
    const known = wordAt(line.text, pos - line.from), about = known?.about ?? (await client.hover(view.state.doc.toString(), line.number - 1, pos - line.from));
    if (about === "" || view.state.doc.length < pos) return null;
    return {
      pos: known === null ? (word?.from ?? pos) : line.from + known.from, end: known === null ? (word?.to ?? pos) : line.from + known.to, above: true,
      create: () => {
        const dom = document.createElement("div");
        dom.className = "about-word";
        for (const one of about.split(/\s*\n/)) {
          const row = dom.appendChild(document.createElement("div"));
          for (const { text, kind } of wordsOf(one)) row.appendChild(document.createElement(kind === "bold" ? "b" : kind === "code" ? "code" : "span")).textContent = text;
        }
        return { dom };
      },
    };
  }, { hoverTime: 350 });
}
