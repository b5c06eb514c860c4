// SPDX-License-Identifier: BSD-2-Clause
import { button, h, patch, type Child } from "../dom/view";
import type { AssetContent } from "../scene/assets";
import type { ShapeContent } from "../scene/shape_library";
import type { SceneView } from "../scene/scene_view";
import { COSTLY, OVERLAYS, type OverlayWord } from "../scene/overlays";
import { listenToGamepads } from "../scene/gamepads";
import { WorldInput, type WorldEvent } from "../scene/world_input";
import type { CameraMode } from "../scene/camera_rig";
import type { Run } from "../run/run";
import { icon } from "./icons";

const CAMERAS: readonly { mode: CameraMode; title: string; key: string }[] = [
  { mode: "orbit", title: "Orbit", key: "O" }, { mode: "follow", title: "Follow the selected agent", key: "F" }, { mode: "map", title: "Map, from above", key: "M" },
];
const RESIZED_AFTER_MS = 400;
/** Prefix of the names of contents with shapes. */
const SHAPES = "shapes:";
/** Prefix of the names of contents with images and sounds. */
const ASSETS = "assets:";
const OVERLAYS_KEY = "soarbox.overlays", DETAIL_KEY = "soarbox.detail", FULL = "full", SOUND_KEY = "soarbox.sound", OFF = "off";

/** The picture of the world with labels, camera buttons and overlays. The scene's code is loaded when it is needed. */
export class Stage {
  readonly element: HTMLElement;
  view: SceneView | null = null;
  private readonly tools: HTMLElement;
  private readonly canvas: HTMLCanvasElement;
  private isOpen = false;
  private toldSize = "";
  private keeps = false;
  private isLost = false;
  private isEmpty = false;
  private resized: ReturnType<typeof setTimeout> | undefined;

  constructor(private readonly run: Run, private readonly select: (name: string) => void) {
    this.element = document.createElement("section");
    this.element.className = "stage";
    this.element.setAttribute("aria-label", "World");
    this.canvas = document.createElement("canvas");
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-label", "Picture of the world. Arrow keys turn the camera, plus and minus go nearer and further, N selects the next agent. The panel Agents lists everybody.");
    const scripts = document.createElement("div"), labels = document.createElement("div");
    scripts.className = "script-ui";
    labels.className = "labels";
    labels.setAttribute("aria-hidden", "true");
    this.tools = document.createElement("div");
    this.tools.className = "stage-tools";
    this.element.append(this.canvas, scripts, labels, this.tools);
    void this.load(labels, scripts);
    this.draw();
  }

  setCamera(mode: CameraMode): void {
    this.view?.rig.setMode(mode);
    if (mode === "follow") this.view?.frameSelected();
    this.view?.wake();
    this.draw();
  }

  draw(): void {
    const view = this.view, mode = view?.rig.mode ?? "orbit";
    patch(this.tools, [
      h("div.group", { attributes: { role: "group", "aria-label": "Camera" } }, CAMERAS.map((one): Child => button(icon(one.mode), () => this.setCamera(one.mode),
        { attributes: { title: `${one.title} (${one.key})`, "aria-label": one.title, "aria-pressed": String(mode === one.mode) } }, "button.tool")),
      button(icon("all"), () => view?.frameAll(), { attributes: { title: this.keeps ? "The camera keeps everybody in the picture, until you move it" : "Show everybody, and keep them in the picture (A)", "aria-label": "Show everybody", "aria-pressed": String(this.keeps) } }, "button.tool"),
      button(icon(this.isSilent ? "silence" : "sound"), () => this.toggleSound(), { attributes: { title: "The sounds of the world (U)", "aria-label": "Sound", "aria-pressed": String(!this.isSilent) } }, "button.tool"),
      button(icon("more"), () => {
        this.isOpen = !this.isOpen;
        this.draw();
      }, { attributes: { title: "What is drawn over the picture", "aria-label": "What is drawn over the picture", "aria-expanded": String(this.isOpen) } }, "button.tool")),
      this.isOpen && h("div.menu", null, OVERLAYS.filter((one) => this.mayAsk || !COSTLY.has(one.word)).map((one): Child => h("label", null, h("input", { checked: view?.on.has(one.word) ?? false, attributes: { type: "checkbox" }, on: { change: () => this.toggle(one.word) } }), one.title)),
        h("label", { attributes: { title: "Draws everything, however long a picture takes; otherwise the page reduces the detail if pictures are slow" } },
          h("input", { checked: view?.isInFullDetail ?? false, attributes: { type: "checkbox" }, on: { change: () => this.toggleDetail() } }), "Full detail")),
      this.isEmpty && h("div.nobody", { attributes: { role: "status" } }, h("p", null, h("b", null, "Nobody is here yet.")), (this.run.printed.lines.filter((one) => one.agent === "" && one.isPrinted).slice(-2)).map((one) => h("p", null, one.text)), h("p", null, "This world reacts to keys only while the picture has the focus: click it first.")),
      this.isLost && button("Nobody is in the picture. Show everybody", () => view?.frameAll(), {}, "button.small.lost"),
    ]);
  }

  /** `data-outside` is the number of living agents that the picture does not show. */
  private noteFramed(keeps: boolean, outside: number, living: number): void {
    this.element.dataset["outside"] = String(outside);
    // A camera that keeps everybody in the picture is on its way to them.
    const isLost = !keeps && living > 0 && outside === living, isEmpty = living === 0 && (this.run.scene?.agents.size ?? 1) === 0 && this.mayAsk;
    if (keeps === this.keeps && isLost === this.isLost && isEmpty === this.isEmpty) return;
    this.isEmpty = isEmpty;
    this.keeps = keeps;
    this.isLost = isLost;
    this.draw();
  }

  closeMenu(): boolean {
    const was = this.isOpen;
    this.isOpen = false;
    this.draw();
    return was;
  }

  private toggle(word: OverlayWord): void {
    const on = this.view?.on;
    if (on === undefined) return;
    if (!on.delete(word)) on.add(word);
    localStorage.setItem(OVERLAYS_KEY, [...on].join());
    this.askOverlays();
    this.view?.wake();
    this.draw();
  }

  /** The user has switched the sounds off, in this browser. */
  private get isSilent(): boolean {
    return localStorage.getItem(SOUND_KEY) === OFF;
  }

  toggleSound(): void {
    localStorage.setItem(SOUND_KEY, this.isSilent ? "" : OFF);
    if (this.view !== null) this.view.sounds.isOn = !this.isSilent;
    this.draw();
  }

  private toggleDetail(): void {
    const isFull = this.view?.isInFullDetail !== true;
    this.view?.setFullDetail(isFull);
    localStorage.setItem(DETAIL_KEY, isFull ? FULL : "");
    this.draw();
  }

  /** Whether this is the user's own live run, which accepts input. */
  private get mayAsk(): boolean {
    return this.run.hello?.may_edit === true && !this.run.hello.is_recording;
  }

  private askOverlays(): void {
    if (this.mayAsk) this.run.wantOverlays([...(this.view?.on ?? [])].filter((one) => COSTLY.has(one)).sort());
  }

  /** Sends the size of the picture to scripts that show boxes of text. */
  private tellSize(): void {
    const { clientWidth: width, clientHeight: height } = this.element, told = `${width}x${height}`;
    if (told === this.toldSize || width === 0 || !this.mayAsk) return;
    this.toldSize = told;
    this.run.ask("input", { kind: "screen", width, height });
  }

  /** Sends what the user did to the scripts of the world. */
  private tellWorld(input: WorldEvent): void {
    if (!this.mayAsk || this.run.contents.moment?.time.is_live === false) return;
    this.tellSize();
    this.run.ask("input", input);
  }

  private async load(labels: HTMLElement, scripts: HTMLElement): Promise<void> {
    const [{ SceneView }, { listenToPointer }] = await Promise.all([import("../scene/scene_view"), import("../scene/pointer")]);
    let view: SceneView;
    try {
      view = new SceneView(this.element, this.canvas, labels, scripts, { selected: (id) => this.select(this.view?.nameOf(id) ?? ""), pressed: (name) => this.tellWorld({ kind: "panel", name }), framed: (keeps, outside, living) => this.noteFramed(keeps, outside, living) }, localStorage.getItem(DETAIL_KEY) === FULL);
    } catch {
      patch(labels, [h("p.no-picture", null, "This browser cannot draw the world: WebGL is switched off. All panels work without it.")]);
      return;
    }
    this.view = view;
    view.sounds.isOn = !this.isSilent;
    const kept = localStorage.getItem(OVERLAYS_KEY);
    if (kept !== null) {
      view.on.clear();
      for (const one of OVERLAYS) if (kept.split(",").includes(one.word)) view.on.add(one.word);
    }
    this.askOverlays();
    listenToPointer(this.canvas, view, this.select);
    new WorldInput(this.element, this.canvas, (input) => this.tellWorld(input));
    listenToGamepads((input) => this.tellWorld(input));
    this.run.on("scene", (scene) => {
      view.take(scene);
      if (scene.components.length > 0) this.tellSize();
    });
    this.run.on("printed", () => this.isEmpty && this.draw());
    this.run.on("printed", () => view.wake());
    view.printedBetween = (from, until) => {
      const step = this.run.hello?.step_s ?? 1 / 30;
      return this.run.printed.lines.filter((one) => one.isPrinted && one.tick * step > from && one.tick * step < until)
        .map(({ agent, text, tick }) => ({ agent, text, time: tick * step }));
    };
    const tellCovered = (): void => {
      const { offsetLeft: left, offsetTop: top, offsetWidth: width, offsetHeight: height } = this.tools;
      view.covered = [{ left, top, width, height }];
      view.wake();
    };
    new ResizeObserver(tellCovered).observe(this.tools);
    new ResizeObserver(() => {
      tellCovered();
      clearTimeout(this.resized);
      this.resized = setTimeout(() => (this.run.scene?.components.length ?? 0) > 0 && this.tellSize(), RESIZED_AFTER_MS);
    }).observe(this.element);
    const tellBoard = (): void => {
      view.isBoard = (this.run.hello?.turn_ticks ?? 1) > 1;
    };
    tellBoard();
    let what = this.run.hello?.what ?? "";
    this.run.on("hello", (hello) => {
      this.toldSize = "";
      // The same world begins again: a camera that the user moved stays there.
      view.forget(hello.what === what);
      what = hello.what;
      tellBoard();
      this.askOverlays();
      this.draw();
    });
    this.run.on("flow", (flow) => {
      view.isPaused = flow.paused || this.run.contents.moment?.time.is_live === false;
      view.wake();
    });
    const takeShapes = (names: readonly string[]): void => {
      for (const name of names) {
        if (name.startsWith(ASSETS)) view.takeAsset(name.slice(ASSETS.length), (this.run.contents as Readonly<Record<string, unknown>>)[name] as AssetContent);
        if (!name.startsWith(SHAPES)) continue;
        const content = (this.run.contents as Readonly<Record<string, unknown>>)[name] as ShapeContent;
        view.takeShape(name.slice(SHAPES.length), content).catch((error: unknown) => console.error(`the shape ${name}: ${String(error)}`));
      }
    };
    this.run.on("contents", (names) => {
      takeShapes(names);
      if (names.includes("ghosts")) view.imagine(this.run.contents.ghosts ?? null);
      if (!names.includes("moment")) return;
      view.select(this.run.contents.moment?.agent ?? "");
      view.isPaused = this.run.flow.paused || this.run.contents.moment?.time.is_live === false;
    });
    takeShapes(Object.keys(this.run.contents));
    if (this.run.scene !== null) view.take(this.run.scene);
    view.imagine(this.run.contents.ghosts ?? null);
    view.select(this.run.contents.moment?.agent ?? "");
    this.draw();
  }
}
