// SPDX-License-Identifier: BSD-2-Clause

/** The contents "assets:KEY". */
export interface AssetContent { bytes: string }

export function bytesOf(content: AssetContent): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(content.bytes), (letter) => letter.charCodeAt(0));
}

/** Images and sounds that scripts show and play, as the run has sent them. */
export class Assets {
  private readonly known = new Map<string, Uint8Array<ArrayBuffer>>();
  private readonly urls = new Map<string, string>();

  add(key: string, content: AssetContent): void {
    if (!this.known.has(key)) this.known.set(key, bytesOf(content));
  }

  bytes(key: string): Uint8Array<ArrayBuffer> | null {
    return this.known.get(key) ?? null;
  }

  /** The address of an image; null: it was not received yet, or is not an image. */
  url(key: string): string | null {
    const made = this.urls.get(key);
    if (made !== undefined) return made;
    const bytes = this.known.get(key);
    if (bytes === undefined) return null;
    const url = URL.createObjectURL(new Blob([bytes], { type: "image/png" }));
    this.urls.set(key, url);
    return url;
  }

  clear(): void {
    for (const url of this.urls.values()) URL.revokeObjectURL(url);
    this.urls.clear();
    this.known.clear();
  }
}
