// SPDX-License-Identifier: BSD-2-Clause
import { formatAddress, NOWHERE, parseAddress, type Address } from "./address";

const SETTLED_AFTER_MS = 300;

/**
 * The address of what the page shows: Back and Forward go from one to the next, and a bookmark or a reload leads to the same.
 * `isOff`: the page watches somebody else's run, whose address stays as it is.
 */
export class Navigator {
  private now: Address;
  private timer: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly isOff: boolean, goTo: (address: Address) => void) {
    this.now = parseAddress(location.hash);
    if (isOff) return;
    addEventListener("popstate", () => {
      clearTimeout(this.timer);
      this.now = parseAddress(location.hash);
      goTo(this.now);
    });
  }

  get address(): Address {
    return this.now;
  }

  /** The page goes somewhere else; Back leads here. */
  go(what: string): void {
    if (what === this.now.what && this.isHome === (what === "")) return;
    clearTimeout(this.timer);
    this.now = { ...NOWHERE, what };
    if (!this.isOff) history.pushState({ isHome: what === "" }, "", this.link);
  }

  /** Whether the user went to lessons and worlds here. Otherwise, if the address names nothing else, the existing run is shown first. */
  get isHome(): boolean {
    return (history.state as { isHome?: boolean } | null)?.isHome === true;
  }

  /** The page shows something that the user did not choose, so there is nothing to go back to. */
  stay(what: string): void {
    if (what === this.now.what) return;
    this.now = { ...NOWHERE, what };
    this.write();
  }

  /** Where in it one is: that changes without a step for Back. */
  note(where: Partial<Pick<Address, "seconds" | "file" | "text">>): void {
    if (this.now.what === "") return;
    const next = { ...this.now, ...where };
    if (formatAddress(next) === formatAddress(this.now)) return;
    this.now = next;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.write(), SETTLED_AFTER_MS);
  }

  private get link(): string {
    return location.pathname + location.search + formatAddress(this.now);
  }

  private write(): void {
    clearTimeout(this.timer);
    if (!this.isOff) history.replaceState({ isHome: this.now.what === "" }, "", this.link);
  }
}
