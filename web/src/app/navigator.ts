// SPDX-License-Identifier: BSD-2-Clause
import { formatAddress, NOWHERE, parseAddress, type Address } from "./address";

const SETTLED_AFTER_MS = 300;

/** The address of the page's state: Back and Forward move between states, and a bookmark or a reload restores the state.
 * `isOff`: the page watches another user's run, and the address does not change.
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

  /** The page shows something else; Back returns to the present state. */
  go(what: string): void {
    if (what === this.now.what && this.isHome === (what === "")) return;
    clearTimeout(this.timer);
    this.now = { ...NOWHERE, what };
    if (!this.isOff) history.pushState({ isHome: what === "" }, "", this.link);
  }

  /** Whether the user went to lessons and worlds. Otherwise an address without a run shows the existing run first. */
  get isHome(): boolean {
    return (history.state as { isHome?: boolean } | null)?.isHome === true;
  }

  /** The page shows something that the user did not choose, so there is nothing to go back to. */
  stay(what: string): void {
    if (what === this.now.what) return;
    this.now = { ...NOWHERE, what };
    this.write();
  }

  /** The position within the state. It changes without a new entry for Back. */
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
