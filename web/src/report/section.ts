// SPDX-License-Identifier: BSD-2-Clause
import { h, type Child, type View } from "../dom/view";

/** A part of a report, with its head. */
export function section(id: string, title: string, ...children: Child[]): View {
  return h("section.part", { attributes: { id, "aria-labelledby": `${id}-head` } }, h("h2", { attributes: { id: `${id}-head` } }, title), children);
}
