// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child } from "../dom/view";
import { clock, short } from "../panels/parts";
import type { Run } from "../run/run";
import { FLOWS, RESUME } from "./flow_table";
import { icon } from "./icons";

/** Run, pause, steps and speed. */
export function flowControls(run: Run): Child {
  const { flow, hello } = run, disabled = hello === null || run.state === "ended" || hello.may_edit === false, isRun = hello?.only_shows !== true;
  const flowButton = (name: Child, what: string, title: string, key: string, more = "", meaning = ""): Child =>
    button(name, () => run.ask("flow", { what }), { key: what, attributes: { title: `${title} (${key})${meaning === "" ? "" : `: ${meaning}`}`, "aria-label": title, disabled } }, `button.flow${more}`);
  const command = (what: keyof typeof FLOWS, key: string, more = "", name: Child = FLOWS[what].button): Child => flowButton(name, what, FLOWS[what].title, key, more, FLOWS[what].meaning);
  const turn = FLOWS[(hello?.turn_ticks ?? 1) > 1 ? "step-turn" : "step-tick"];
  return h("div.flow-bar", { attributes: { role: "group", "aria-label": "Run" } },
    flow.paused ? flowButton([icon("play"), h("span", null, "Run")], "go-on", "Run", "Space", ".primary") : flowButton([icon("pause"), h("span", null, "Pause")], "pause", "Pause", "Space"),
    flowButton(turn.button, "step-turn", turn.title, ".", ".step", turn.meaning), isRun && command("step-decision", "D", ".step"), isRun && command("step-phase", "P", ".step"), isRun && command("step-change", "C", ".step.rare"),
    command("begin-again", "R", "", [icon("restart"), h("span.wide", null, FLOWS["begin-again"].button)]),
    isRun && command("next-seed", "no key", ".step.rare"),
    h("span.speed", { attributes: { role: "group", "aria-label": "Speed" } }, command("slower", "<"), h("output", { attributes: { "aria-label": "Speed" } }, flow.speed === "unlimited" ? "max" : `${short(flow.speed)}×`), command("faster", ">")));
}

/** How long the slider keeps its new position without an answer, in milliseconds. */
const PATIENCE_MS = 5_000;

/**
 * The position of the slider until the run shows that tick. Further key presses continue from this position, even if
 * answers are late.
 */
export class WantedTick {
  private asked: number | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  get tick(): number | null {
    return this.asked;
  }

  /** `late` is called if no answer came in time. */
  ask(tick: number, late: () => void): void {
    this.forget();
    this.asked = tick;
    this.timer = setTimeout(() => {
      this.forget();
      late();
    }, PATIENCE_MS);
  }

  shown(tick: number | undefined): void {
    if (tick === this.asked) this.forget();
  }

  forget(): void {
    clearTimeout(this.timer);
    this.asked = null;
  }
}

/** A slider over past moments, and a button back to the present. */
export function scrubber(run: Run, wanted: WantedTick, redraw: () => void): Child {
  const time = run.contents.moment?.time, { flow, hello } = run, step = time?.step_s ?? hello?.step_s ?? 1 / 30;
  if (time?.is_live === false) wanted.shown(time.shown_tick);
  const first = time?.first_tick ?? 0, last = Math.max(time?.last_tick ?? 0, time?.is_live === false ? 0 : flow.tick), isLive = time?.is_live ?? true;
  const shown = wanted.tick ?? (isLive ? last : (time?.shown_tick ?? last)), mayAsk = hello !== null && hello.may_edit !== false;
  const seek = (tick: number): void => {
    wanted.ask(tick, redraw);
    run.ask("seek", { tick });
    redraw();
  };
  return h("div.scrubber", { attributes: { role: "group", "aria-label": "Time" } },
    h("input.past", {
      value: String(shown),
      attributes: { type: "range", min: first, max: Math.max(last, first + 1), step: 1, "aria-label": "Moment that is shown", "aria-valuetext": `${clock(shown * step)} of ${clock(last * step)}`, disabled: !mayAsk || time?.can_go_back === false },
      on: { input: (event) => seek(Number((event.target as HTMLInputElement).value)) },
    }),
    h("span.moment", null, clock(shown * step), h("span.quiet", null, ` / ${clock(last * step)}`)),
    !isLive && mayAsk && hello.only_shows !== true && button([icon("resume"), h("span", null, RESUME)], () => {
      wanted.forget();
      run.ask("resume");
    }, {
      attributes: { disabled: time?.can_resume !== true, title: time?.can_resume === true ? "Continue from this moment; what came after it becomes the old future" : (time?.resume_refusal ?? "") },
    }),
    !(time?.is_recording === true) && button([icon("live"), h("span", null, isLive ? "Live" : "To the newest")], () => {
      wanted.forget();
      run.ask("live");
    }, { attributes: { disabled: isLive || !mayAsk, title: "Show the newest moment (L)" } }, `button${isLive ? ".is-live" : ".primary"}`));
}
