// SPDX-License-Identifier: BSD-2-Clause

/** Thrown by readers if bytes are invalid. */
export class BadBytes extends Error {}

const decoder = new TextDecoder("utf-8");

/** Reads the values of docs/dev/stream.md one after another. */
export class ByteReader {
  private at = 0;
  private readonly view: DataView;

  constructor(private readonly bytes: Uint8Array) {
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  atEnd(): boolean {
    return this.at >= this.bytes.length;
  }

  byte(): number {
    const value = this.bytes[this.at];
    if (value === undefined) throw new BadBytes("the bytes end too early");
    this.at += 1;
    return value;
  }

  /** A non-negative integer. Throws if it has more than 53 bits. */
  number(): number {
    const first = this.bytes[this.at];
    if (first !== undefined && first < 0x80) {
      this.at += 1;
      return first;
    }
    let value = 0;
    for (let factor = 1; factor < 2 ** 56; factor *= 128) {
      const byte = this.byte();
      value += (byte & 0x7f) * factor;
      if (value > Number.MAX_SAFE_INTEGER) break;
      if (byte < 0x80) return value;
    }
    throw new BadBytes("a number is too large");
  }

  signed(): number {
    const n = this.number();
    return n % 2 === 0 ? n / 2 : -(n + 1) / 2;
  }

  /** Reads the number of following entries, each of which has at least this many bytes. */
  count(leastBytes = 1): number {
    const count = this.number();
    if (count * leastBytes > this.bytes.length - this.at) throw new BadBytes("a count is too large");
    return count;
  }

  float(): number {
    return this.view.getFloat32(this.after(4), true);
  }

  double(): number {
    return this.view.getFloat64(this.after(8), true);
  }

  /** Reads the size of a piece. Returns the position of its end, for skipTo(). */
  endOfPiece(): number {
    return this.count() + this.at;
  }

  /** Skips the rest of a piece. Throws if more than the piece was read. */
  skipTo(end: number): void {
    if (this.at > end) throw new BadBytes("a piece ends too early");
    this.at = end;
  }

  /** Reads a number, and then this many bytes. */
  piece(): Uint8Array {
    const size = this.count();
    this.at += size;
    return this.bytes.subarray(this.at - size, this.at);
  }

  text(): string {
    return decoder.decode(this.piece());
  }

  /** Skips some bytes. Returns the position before them. */
  private after(bytes: number): number {
    const at = this.at;
    if (at + bytes > this.bytes.length) throw new BadBytes("the bytes end too early");
    this.at = at + bytes;
    return at;
  }
}
