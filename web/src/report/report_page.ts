// SPDX-License-Identifier: BSD-2-Clause
import { icon } from "../app/icons";
import { isDark, switchTheme } from "../app/theme";
import { button, clear, h, patch, type Child } from "../dom/view";
import { seconds } from "./chart";
import type { Report, RunReport } from "./data";
import { runSections } from "./run_sections";
import { sweepSections } from "./sweep_sections";
import { OwnTime, type Time } from "./time";

/** A recorded run in 3D: its picture and panels, and the time that they show. */
export interface Scene { element: HTMLElement; time: Time }

/** The page of `soarbox report`: a head, the run in 3D if there is one, and the text below. */
export class ReportPage {
  private readonly head = document.createElement("header");
  private readonly main = document.createElement("main");
  private readonly bar = document.createElement("div");
  private shown = 0;
  private time: Time | null = null;

  constructor(root: HTMLElement, private readonly reports: readonly Report[], private readonly scene: Scene | null) {
    this.head.className = "report-head";
    this.main.className = "report";
    this.bar.className = "bar";
    root.replaceChildren(this.head, ...(scene === null ? [] : [scene.element]), this.main, this.bar);
    if (scene !== null) {
      root.classList.add("has-scene");
      // The run's own slider controls all parts of the page.
      new IntersectionObserver((seen) => (this.bar.hidden = seen.at(-1)?.isIntersecting === true), { threshold: 0.6 }).observe(scene.element.querySelector(".foot") ?? scene.element);
    }
    addEventListener("beforeprint", () => this.openReasons());
    addEventListener("soarbox-theme", () => this.drawHead(this.shown));
    this.show(0);
  }

  private show(index: number): void {
    this.shown = index;
    const report = this.reports[index];
    if (report === undefined) return;
    this.drawHead(index);
    this.time?.play(false);
    clear(this.main);
    this.bar.hidden = report.kind === "sweep";
    if (report.kind === "sweep") return patch(this.main, [sweepSections(report)]);
    const time = this.scene?.time ?? new OwnTime(Math.max(report.seconds, 0.1));
    this.time = time;
    patch(this.main, [runSections(report, time, this.scene !== null)]);
    this.drawBar(report, time);
  }

  private drawHead(index: number): void {
    const report = this.reports[index];
    if (report === undefined) return;
    const verdict = report.passed === true ? ".good" : report.passed === false ? ".bad" : "";
    patch(this.head, [
      h("div.title", null, h("h1", null, report.title), report.verdict !== "" && h(`p.verdict${verdict}`, { attributes: { id: "verdict" } }, report.verdict), h("p.quiet", null, "See it: ", h("code.command", null, report.command))),
      h("div.row.choice", null,
        this.reports.length > 1 && h("select", { value: String(index), attributes: { "aria-label": "Run", id: "run" }, on: { change: (event) => this.show(Number((event.target as HTMLSelectElement).value)) } }, this.reports.map((each, i): Child => h("option", { attributes: { value: i } }, `${each.title}: ${each.verdict}`))),
        button(icon("sun"), switchTheme, { attributes: { id: "theme", title: "Light or dark", "aria-label": isDark() ? "Light colours" : "Dark colours" } }, "button.tool")),
    ]);
  }

  /** The moment that all pictures of a run show. */
  private drawBar(run: RunReport, time: Time): void {
    clear(this.bar);
    this.bar.setAttribute("role", "group");
    this.bar.setAttribute("aria-label", `Moment of ${run.title}`);
    const draw = (): void => patch(this.bar, [
      button([icon(time.isPlaying ? "pause" : "play"), time.isPlaying ? "Pause" : "Play"], () => time.play(!time.isPlaying), { attributes: { id: "play" } }),
      h("input", {
        value: String(time.now),
        attributes: { type: "range", id: "slider", min: 0, max: time.end, step: 0.1, "aria-label": "Time", "aria-valuetext": `${seconds(time.now)} of ${seconds(time.end)}` },
        on: { input: (event) => {
          const wanted = Number((event.target as HTMLInputElement).value);
          time.play(false);
          time.go(wanted);
        } },
      }),
      h("output", { attributes: { for: "slider" } }, seconds(time.now)),
    ]);
    time.on(draw);
    draw();
  }

  /** Opens all reasons before printing, because they cannot be opened on paper. */
  private openReasons(): void {
    for (const details of this.main.querySelectorAll<HTMLDetailsElement>("details.why")) details.open = true;
  }
}
