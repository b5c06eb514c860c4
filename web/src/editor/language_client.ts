// SPDX-License-Identifier: BSD-2-Clause
import type { Completion, CompletionContext, CompletionResult, CompletionSource } from "@codemirror/autocomplete";
import type { Run } from "../run/run";

const ANSWER_MS = 2500;

interface Answer { id?: number; result?: unknown; error?: unknown }
interface LspItem { label: string; kind?: number; detail?: string; documentation?: string | { value: string }; insertText?: string; textEdit?: { newText: string } }

const TYPES: Readonly<Record<number, string>> = { 3: "function", 5: "property", 6: "variable", 12: "constant", 14: "keyword", 21: "constant", 22: "class" };

/** Talks the language server's protocol through the run: what may stand where the caret is. */
export class LanguageClient {
  private next = 1;
  private readonly waiting = new Map<number, (answer: Answer) => void>();
  private started: Promise<boolean> | null = null;
  private file = "";
  private version = 0;

  constructor(private readonly run: Run) {
    run.on("language", (content) => {
      const answer = content as Answer;
      if (typeof answer.id !== "number") return;
      this.waiting.get(answer.id)?.(answer);
      this.waiting.delete(answer.id);
    });
    run.on("hello", () => {
      this.started = null;
      this.file = "";
    });
  }

  look(file: string): void {
    if (file === this.file) return;
    this.file = file;
    this.version = 0;
  }

  /** Null: no answer came, or none is known. */
  async complete(text: string, line: number, character: number): Promise<LspItem[] | null> {
    if (this.file === "" || !(await this.start())) return null;
    const uri = `file://${encodeURI(this.file)}`;
    this.version += 1;
    if (this.version === 1) this.send({ method: "textDocument/didOpen", params: { textDocument: { uri, languageId: "soar", version: 1, text } } });
    else this.send({ method: "textDocument/didChange", params: { textDocument: { uri, version: this.version }, contentChanges: [{ text }] } });
    const answer = await this.ask("textDocument/completion", { textDocument: { uri }, position: { line, character } });
    const result = answer?.result as LspItem[] | { items: LspItem[] } | null | undefined;
    if (result === null || result === undefined) return null;
    return Array.isArray(result) ? result : result.items;
  }

  private start(): Promise<boolean> {
    this.started ??= this.ask("initialize", { processId: null, rootUri: null, capabilities: {} }).then((answer) => {
      if (answer?.result === undefined) return false;
      this.send({ method: "initialized", params: {} });
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
    if (this.run.connection === "open") this.run.ask("language", { message: { jsonrpc: "2.0", ...message } });
  }
}

/** Where the word begins that is being typed: behind ^ and dots, or at a sign that may stand in a name. */
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
