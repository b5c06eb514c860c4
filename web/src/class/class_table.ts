// SPDX-License-Identifier: BSD-2-Clause
import { button, h, patch, type Child } from "../dom/view";
import type { Api, ClassInfo, Learner } from "../app/api";
import { icon } from "../app/icons";
import { isDark, switchTheme } from "../app/theme";

const EVERY_MS = 5000;

/** How a learner stands in a lesson, in a few words. */
export function standing(learner: Learner, lesson: string): { text: string; says: string; kind: "done" | "begun" | "none" } {
  const done = learner.done[lesson];
  if (done === undefined) return { text: "", says: "not begun", kind: "none" };
  const tries = done.tries ?? 0, hints = done.hints ?? 0, of = done.of ?? 0, passed = done.passed ?? 0;
  const says = [done.is_done ? "passed" : "not passed", of > 0 ? `${passed} of ${of} checks` : "", tries === 1 ? "1 try" : `${tries} tries`, hints === 1 ? "1 hint" : `${hints} hints`].filter((one) => one !== "").join(", ");
  if (done.is_done) return { text: "✓", says, kind: "done" };
  if (tries === 0 && hints === 0 && passed === 0) return { text: "", says: "not begun", kind: "none" };
  return { text: of > 0 ? `${passed}/${of}` : `${tries}×`, says, kind: "begun" };
}

/** The teacher's table: learners by lessons. */
export class ClassTable {
  private readonly element = document.createElement("div");
  private info: ClassInfo | null = null;
  private trouble = "";

  constructor(root: HTMLElement, private readonly api: Api, private readonly key: string) {
    this.element.className = "class-page";
    root.replaceChildren(this.element);
    addEventListener("soarbox-theme", () => this.draw());
    void this.load();
  }

  private async load(): Promise<void> {
    try {
      this.info = await this.api.json<ClassInfo>(`/api/class/${encodeURIComponent(this.key)}`);
      this.trouble = "";
    } catch (error) {
      const told = error as { message: string; hint?: string };
      this.trouble = [told.message, told.hint ?? ""].join(" ").trim();
    }
    this.draw();
    setTimeout(() => void this.load(), EVERY_MS);
  }

  private draw(): void {
    document.title = "Class - Soarbox";
    patch(this.element, [
      h("header.head", null, h("span.brand", null, "Soarbox"), h("h1.run-title", null, "Your class"), h("span.space"),
        button("Table as CSV", () => void this.api.download(`/api/class/${encodeURIComponent(this.key)}.csv`, "class.csv").catch((error: unknown) => {
          this.trouble = (error as Error).message;
          this.draw();
        })),
        button(icon("sun"), switchTheme, { attributes: { "aria-label": isDark() ? "Light colours" : "Dark colours" } }, "button.tool")),
      this.trouble !== "" && h("p.warn.trouble", { attributes: { role: "alert" } }, this.trouble),
      h("main", { attributes: { tabindex: 0, "aria-label": "Learners by lessons" } }, this.table()),
    ]);
  }

  private table(): Child {
    const info = this.info;
    if (info === null) return this.trouble === "" && h("div.empty", null, h("p", null, "The table is loaded …"));
    if (info.learners.length === 0) return h("div.empty", null, h("p", null, "The class has no learners. The file that soarbox serve --class reads has one name on each line."));
    return h("table.class", null, h("thead", null, h("tr", null, h("th", { attributes: { scope: "col" } }, "Learner"), info.lessons.map((one, i) => h("th.number", { attributes: { scope: "col", title: one.title } }, String(i + 1))),
      h("th", { attributes: { scope: "col" } }, "Doing"), h("th", { attributes: { scope: "col" } }, "Links"))),
    h("tbody", null, info.learners.map((learner) => h("tr", { key: learner.place_link }, h("th", { attributes: { scope: "row" } }, h(`i.here${learner.is_here ? ".yes" : ""}`, { attributes: { title: learner.is_here ? "is here now" : "is not here" } }), learner.name),
      info.lessons.map((lesson) => {
        const { text, says, kind } = standing(learner, lesson.name);
        return h(`td.number.${kind}`, { attributes: { title: `${lesson.title}: ${says}` } }, text, h("span.hidden", null, ` ${says}`));
      }),
      h("td.quiet", null, (learner.doing ?? "").replace(/^\w+:/, ""), learner.last_hint !== undefined && learner.last_hint !== "" && h("div", null, learner.last_hint)),
      h("td", null, h("a", { attributes: { href: this.here(learner.watch_link) } }, "Watch"), " ", h("a", { attributes: { href: this.here(learner.place_link) } }, "Their link"))))));
  }

  /** Links lead to this server and to nothing else. */
  private here(link: string): string {
    return link.startsWith("/") && !link.startsWith("//") ? link : "#";
  }
}
