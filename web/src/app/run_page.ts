// SPDX-License-Identifier: BSD-2-Clause
import { patch, type Child } from "../dom/view";
import { documentPanel } from "../document/document_panel";
import { EditPanel } from "../editor/edit_panel";
import type { Panel, PanelContext, PlaceFiles } from "../panels/panel";
import { outputPanel } from "../panels/output";
import { ARRANGEMENTS, PANELS } from "../panels/panel_table";
import { timelinePanel } from "../panels/timeline";
import type { ContentName } from "../run/contents";
import type { Run } from "../run/run";
import { Dock } from "./dock";
import { flowControls, scrubber, WantedTick } from "./flow_bar";
import { isTyping } from "./keys";
import { protagonist } from "./protagonist";
import { splitter } from "./splitter";
import { Stage } from "./stage";

/** Keys of a stopped script, and how it continues. */
const STEP_KEYS: Readonly<Record<string, string>> = { F8: "on", F10: "over", F11: "into", "Shift+F11": "out" };
const NARROW = "(max-width: 900px)";

/** All panels in one row of tabs: the task and the rules first. */
function inOneRow({ left, right, bottom }: Arrangement): Arrangement {
  const all = [...left, ...right, ...bottom], first = ["mission", "edit"].filter((word) => all.includes(word));
  return { left: [], right: [], bottom: [...first, ...all.filter((word) => !first.includes(word))] };
}

/** The positions of panels on this kind of page. */
function arrangementOf(shape: string): Arrangement {
  if (shape === "narrow") return inOneRow(ARRANGEMENTS.lesson);
  if (shape === "narrowReport") return inOneRow(ARRANGEMENTS.report);
  return shape === "report" ? ARRANGEMENTS.report : shape === "world" ? ARRANGEMENTS.world : ARRANGEMENTS.lesson;
}

interface Arrangement { readonly left: readonly string[]; readonly right: readonly string[]; readonly bottom: readonly string[] }

/** The panel of an exercise is shown only in runs that take part in one. */
function withExercise(arranged: Arrangement, hasExercise: boolean, isNarrow: boolean): Arrangement {
  if (!hasExercise) return arranged;
  return isNarrow ? { ...arranged, bottom: [...arranged.bottom, "exercise"] } : { ...arranged, left: [...arranged.left, "exercise"] };
}

/** A run with its picture, panels and flow: the lesson's or the world's page. */
export class RunPage {
  readonly element = document.createElement("div");
  private readonly work = document.createElement("main");
  private readonly foot = document.createElement("footer");
  private readonly stage: Stage;
  private readonly panels: Panel[];
  private readonly edit: EditPanel;
  private docks: Dock[] = [];
  private readonly narrow = matchMedia(NARROW);
  private shape = "";
  private readonly wanted = new WantedTick();
  private hasExercise = false;
  private isChosen = false;
  /** The agent that was selected automatically. */
  private chosen = "";
  private isFronted = false;
  /** Number of the script's stop that was shown last. */
  private stopCount = 0;
  /** The world that runs, as the address names it. */
  private what = "";

  /**
   * `isReport`: the page contains a recorded run and shows fewer panels. `only`: the panels of an embedded page; null:
   * all.
   */
  constructor(private readonly run: Run, openWhat: (what: string) => void, private readonly isReport = false, private readonly only: readonly string[] | null = null, files: PlaceFiles | null = null) {
    this.element.className = "run-page";
    this.work.className = "work";
    this.foot.className = "foot";
    const context: PanelContext = {
      run, openWhat, files, grade: () => this.grade(),
      redraw: (word) => this.docks.forEach((dock) => dock.has(word) && dock.redraw(word)),
      titleOf: (word) => this.panels.find((one) => one.word === word)?.title ?? word,
      reveal: (word) => this.reveal(word),
      why: (about, what) => {
        run.ask("ask", { about, ...(what === undefined ? {} : { what }) });
        this.reveal("why");
      },
      beforeEdit: () => this.edit.flush(),
      edit: (file, line) => {
        this.edit.flush();
        run.ask("edit", { file, ...(line === undefined ? {} : { line }) });
        this.reveal("edit");
      },
    };
    this.edit = new EditPanel(context, () => this.applied());
    const own = [timelinePanel, outputPanel].map((make) => make(context));
    this.panels = [...own, ...PANELS.filter((one) => one.hasDocument).map((one) => documentPanel(context, one))];
    this.panels.push(this.edit);
    this.stage = new Stage(run, (name) => run.ask("select", { agent: name }));
    this.element.append(this.work, this.foot);
    this.what = run.hello?.what ?? "";
    run.on("hello", ({ what }) => {
      this.isChosen = false;
      this.chosen = "";
      this.stopCount = 0;
      // When the run begins again, the panels stay as they are.
      if (what !== this.what) this.isFronted = false;
      this.what = what;
      this.arrange();
      this.drawFlow();
    });
    run.on("contents", (names) => this.take(names));
    run.on("flow", () => this.drawFlow());
    run.on("state", () => this.drawFlow());
    this.narrow.addEventListener("change", () => this.arrange());
    this.arrange();
    this.drawFlow();
  }

  private arrange(): void {
    const hello = this.run.hello, isNarrow = this.narrow.matches || this.only !== null, shape = this.only !== null ? "embedded" : this.isReport ? (isNarrow ? "narrowReport" : "report") : isNarrow ? "narrow" : hello !== null && !hello.what.startsWith("lesson:") ? "world" : "lesson";
    const hasExercise = hello?.has_exercise === true;
    if (shape === this.shape && hasExercise === this.hasExercise) return;
    this.shape = shape;
    this.hasExercise = hasExercise;
    this.element.dataset["shape"] = shape;
    const arranged = shape === "embedded" ? { left: [], right: [], bottom: (this.only ?? []).filter((word) => this.panels.some((one) => one.word === word)) } : withExercise(arrangementOf(shape), hasExercise, isNarrow), contents = (): typeof this.run.contents => this.run.contents, changed = (): void => this.look();
    const dock = (name: string, words: readonly string[]): Dock => new Dock(name, `${shape}.${name}`, words.map((word) => this.panels.find((one) => one.word === word)!), contents, changed);
    const middle = document.createElement("div");
    middle.className = "middle";
    this.docks = [];
    if (isNarrow) {
      this.docks = arranged.bottom.length === 0 ? [] : [dock("bottom", arranged.bottom)];
      middle.append(this.stage.element, this.foot, ...this.docks.map((one) => one.element));
      this.work.replaceChildren(middle);
    } else {
      const left = dock("left", arranged.left), right = dock("right", arranged.right), bottom = dock("bottom", arranged.bottom);
      this.docks = [left, bottom, right];
      const most = (share: number) => (): number => innerWidth * share;
      middle.append(this.stage.element, splitter("Height of the panels below the picture", "--bottom", "horizontal", -1, this.element, 90, () => innerHeight * 0.7, 270), bottom.element);
      this.work.replaceChildren(left.element, splitter("Width of the task", "--left", "vertical", 1, this.element, 180, most(0.4), 300), middle,
        splitter("Width of the rules", "--right", "vertical", -1, this.element, 220, most(0.55), Math.min(460, Math.round(innerWidth * 0.34))), right.element);
      this.element.append(this.foot);
    }
    this.look();
  }

  get editorPlace(): { file: string; line: number } | null {
    return this.edit.where;
  }

  /** Shows a line of a file of this run, by the file's name. */
  showLine(file: string, line: number): void {
    const found = this.run.contents.edit?.files.find((one) => one.file.split("/").at(-1) === file);
    if (found === undefined) return this.run.remark(`${file} is not among the files of this world.`, "Open the lesson or world that it belongs to.", false);
    this.edit.flush();
    this.run.ask("edit", { file: found.file, line });
    this.reveal("edit");
  }

  /** Why this agent does what it does. */
  askWhy(agent: string): void {
    this.isChosen = true;
    this.run.ask("select", { agent });
    this.run.ask("ask", { about: "agent" });
    this.reveal("why");
  }

  /** Whether the run has other rules than at its beginning, or continued from an earlier moment. */
  get isPieced(): boolean {
    const time = this.run.contents.moment?.time;
    return (time?.changed_tick ?? null) !== null || (time?.branch_tick ?? null) !== null;
  }

  get editorText(): string | null {
    return this.edit.text;
  }

  /** Opens a file by its name; with a shared text, as a draft. */
  showFile(file: string, text: string): void {
    if (text !== "") void this.edit.offer(file, text);
    this.edit.showFile(file);
    this.reveal("edit");
  }

  private reveal(word: string): void {
    for (const dock of this.docks) if (dock.has(word)) dock.show(word);
  }

  /**
   * Requests visible contents only, plus the editor's text, checks and problems (counted on tabs), and printed texts
   * (shown over heads).
   */
  private look(): void {
    const shown = this.docks.map((dock) => dock.shownWord).filter((word) => word !== "" && word !== "output");
    this.run.look([...shown, "mission", "problems", "edit", "timeline"]);
  }

  /** A script has stopped: shows its text and its variables. */
  private noteStop(): void {
    const stopped = this.run.contents.edit?.stopped ?? null;
    if (stopped === null || stopped.count === this.stopCount) return;
    this.stopCount = stopped.count;
    this.reveal("script");
    this.reveal("edit");
  }

  private take(names: readonly ContentName[]): void {
    if (names.includes("edit")) {
      this.edit.take(this.run.contents);
      this.noteStop();
    }
    this.choose();
    for (const dock of this.docks) dock.note(names);
    if (names.includes("moment")) this.drawFlow();
    const front = this.run.contents.mission?.lesson?.panel;
    if (!this.isFronted && front !== undefined) {
      this.isFronted = true;
      const panel = this.panels.find((one) => one.title === front);
      if (panel !== undefined && this.shape === "lesson") this.reveal(panel.word);
    }
  }

  /** Selects an agent at the beginning, so that panels are not empty. */
  private choose(): void {
    const { moment, mission } = this.run.contents, { hello } = this.run;
    if (this.isChosen || moment === undefined || hello === null || (mission === undefined && !this.isReport)) return;
    const agents = hello.minds.length > 0 ? hello.minds : hello.agents, agent = mission === undefined ? (agents[0] ?? "") : protagonist(mission, agents);
    // Checks may arrive later. Until then the first agent is selected, as the run does itself.
    this.isChosen = mission === undefined || mission.checks.length > 0;
    if (moment.agent !== "" && moment.agent !== agents[0] && moment.agent !== this.chosen) this.isChosen = true;
    else if (agent !== "" && agent !== moment.agent && agent !== this.chosen && hello.may_edit !== false) this.run.ask("select", { agent: (this.chosen = agent) });
  }

  /** Called when rules have changed. A lesson's run begins again, so that checks and picture show the new rules. */
  private applied(): void {
    const { run } = this, isLive = run.contents.moment?.time.is_live !== false;
    if (this.what.startsWith("lesson:") && this.edit.restarts && isLive && !run.flow.paused && run.hello?.may_edit === true) run.ask("flow", { what: "begin-again" });
  }

  private grade(): boolean {
    if (this.edit.isUnsaved) this.edit.apply();
    return this.run.ask("lesson", { what: "grade" });
  }

  private drawFlow(): void {
    patch(this.foot, [flowControls(this.run), scrubber(this.run, this.wanted, () => this.drawFlow())] satisfies Child[]);
  }

  /** Handles keys of the page. Returns whether the key was one of them. */
  key(event: KeyboardEvent): boolean {
    if (event.altKey && /^[1-9]$/.test(event.key)) {
      const dock = this.docks.find((one) => one.name === "bottom"), panel = dock?.panels[Number(event.key) - 1];
      if (dock !== undefined && panel !== undefined) dock.show(panel.word, true);
      return panel !== undefined;
    }
    if ((event.ctrlKey || event.metaKey) && !event.altKey && (event.key === "Enter" || event.key === "s") && this.run.hello?.may_edit === true) {
      this.edit.apply();
      return true;
    }
    if (event.ctrlKey || event.metaKey || event.altKey) return false;
    const step = this.run.flow.stopped === true ? STEP_KEYS[(event.shiftKey ? "Shift+" : "") + event.key] : undefined;
    if (step !== undefined) return this.run.ask("script-go", { how: step });
    if (event.key === "Escape") return this.stage.closeMenu();
    if (isTyping(event.target)) return false;
    const isButton = event.target instanceof HTMLElement && event.target.closest("button, summary, [role=tab], a") !== null;
    const flow = (what: string): boolean => this.run.ask("flow", { what });
    switch (event.key) {
      case " ": return !isButton && flow(this.run.flow.paused ? "go-on" : "pause");
      case ".": return flow("step-turn");
      case "d": case "D": return flow("step-decision");
      case "p": case "P": return flow("step-phase");
      case "c": case "C": return flow("step-change");
      case "r": case "R": return flow("begin-again");
      case "<": return flow("slower");
      case ">": return flow("faster");
      case "l": case "L": this.wanted.forget(); return this.run.ask("live");
      case "o": case "O": this.stage.setCamera("orbit"); return true;
      case "f": case "F": this.stage.setCamera("follow"); return true;
      case "m": case "M": this.stage.setCamera("map"); return true;
      case "u": case "U": this.stage.toggleSound(); return true;
      case "a": case "A": this.stage.view?.frameAll(); return true;
      case "n": case "N": return this.selectNext();
      default: return false;
    }
  }

  private selectNext(): boolean {
    const all = this.run.hello?.agents ?? [], at = all.indexOf(this.run.contents.moment?.agent ?? "");
    const next = all[(at + 1) % Math.max(all.length, 1)];
    return next !== undefined && this.run.ask("select", { agent: next });
  }
}
