// SPDX-License-Identifier: BSD-2-Clause

/** The part of a browser's storage that is used; tests give their own. */
export interface Store {
  getItem(key: string): string | null;
  setItem(key: string, value: string): void;
  removeItem(key: string): void;
}

interface Kept {
  text: string;
  /** The server's text when typing began. */
  base: string;
}

const PREFIX = "soarbox.typed.";

/** Text that was typed and that the server has not confirmed yet. It is in the browser's storage from the first letter
 * on, so it survives a reload, a closed tab and a server that is gone. Each file has one entry. */
export class KeptText {
  constructor(private readonly place: string, private readonly store: Store | null) {}

  /** Stores the text typed into a file; `base` is its text at the server. */
  keep(file: string, text: string, base: string): void {
    const known = this.read(file);
    try {
      this.store?.setItem(this.key(file), JSON.stringify({ text, base: known?.base ?? base } satisfies Kept));
    } catch {
      // A full or forbidden storage: the server has the text after a moment.
    }
  }

  /** The server has this text: there is nothing to keep if it is the newest. */
  confirm(file: string, text: string): void {
    if (this.read(file)?.text === text) this.drop(file);
  }

  drop(file: string): void {
    this.store?.removeItem(this.key(file));
  }

  /** The typed text that the server does not have (its text is `current`); null if there is none. `isOlder`: the server's
   * text has changed since, elsewhere. */
  find(file: string, current: string): { text: string; isOlder: boolean } | null {
    const known = this.read(file);
    if (known === null) return null;
    if (known.text === current) {
      this.drop(file);
      return null;
    }
    return { text: known.text, isOlder: known.base !== current };
  }

  private key(file: string): string {
    return `${PREFIX}${this.place}.${file}`;
  }

  private read(file: string): Kept | null {
    try {
      const value: unknown = JSON.parse(this.store?.getItem(this.key(file)) ?? "null");
      const { text, base } = (value ?? {}) as Partial<Kept>;
      return typeof text === "string" && typeof base === "string" ? { text, base } : null;
    } catch {
      return null;
    }
  }
}

/** The storage of this browser; null if it allows none. */
export function browserStore(): Store | null {
  try {
    return globalThis.localStorage ?? null;
  } catch {
    return null;
  }
}
