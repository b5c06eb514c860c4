// SPDX-License-Identifier: BSD-2-Clause

/** A storage that lasts as long as the page. */
class PageStorage {
  private readonly kept = new Map<string, string>();
  get length(): number {
    return this.kept.size;
  }
  key(index: number): string | null {
    return [...this.kept.keys()][index] ?? null;
  }
  getItem(name: string): string | null {
    return this.kept.get(name) ?? null;
  }
  setItem(name: string, value: string): void {
    this.kept.set(name, value);
  }
  removeItem(name: string): void {
    this.kept.delete(name);
  }
  clear(): void {
    this.kept.clear();
  }
}

/** In a frame without storage, as in a notebook, settings last as long as the page. */
export function keepInPage(): void {
  for (const name of ["localStorage", "sessionStorage"] as const) {
    try {
      void globalThis[name].length;
    } catch {
      Object.defineProperty(globalThis, name, { value: new PageStorage(), configurable: true });
    }
  }
}
