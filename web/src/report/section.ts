// SPDX-License-Identifier: BSD-2-Clause
import { h, type Child, type View } from "../dom/view";

/** A part of a report, with its head. */
export function section(id: string, title: string, ...children: Child[]): View {
  return h("section.part", { attributes: { id, "aria-labelledby": `${id}-head` } }, h("h2", { attributes: { id: `${id}-head` } }, title), children);
}

/** The origin of a report, folded: files, program, machine. Reports of earlier versions have none. */
export function manifestOf(report: { manifest?: Readonly<Record<string, unknown>> }): Child {
  return report.manifest !== undefined && h("details", null, h("summary", null, "Manifest: what the runs were made from"), h("pre", null, JSON.stringify(report.manifest, null, 1)));
}
