// SPDX-License-Identifier: BSD-2-Clause
import { Matrix4, Quaternion, Vector3, type PerspectiveCamera } from "three";
import { h, patch, type Child } from "../dom/view";
import { Font, type Color, type Component } from "../format/scene";
import type { Assets } from "./assets";
import type { Box } from "./label_layout";
import { cssColor } from "./looks";

const FONT_OF: Readonly<Record<string, Font>> = { "9": Font.Small, "91": Font.SmallMono, "14": Font.Medium, "141": Font.MediumMono, "24": Font.Large, "241": Font.LargeMono };
const CLASS_OF: readonly string[] = ["small", "small.mono", "medium", "medium.mono", "large", "large.mono"];
const METRES_PER_PX = 0.005;
/** Maximum width of a box, as a part of the picture's width, unless its text would become too small to read. */
const LEAST_FITTING = 0.6, READABLE = 0.75, MOST_SHARE = 0.5, EDGE_PX = 6;

export interface TextRun { text: string; color: number; font: Font; mono: boolean }

/** The lines of a markup text: %0 to %9 are colours, %R the usual one, %M fixed width, %@nn% a font, %% a percent sign. */
export function parseMarkup(markup: string): TextRun[][] {
  const lines: TextRun[][] = [[]];
  let run: TextRun = { text: "", color: 0, font: Font.Small, mono: false };
  const flush = (): void => {
    if (run.text !== "") lines.at(-1)!.push({ ...run });
    run.text = "";
  };
  for (let i = 0; i < markup.length; ++i) {
    const c = markup[i]!;
    if (c === "\n") {
      flush();
      lines.push([]);
      continue;
    }
    if (c !== "%") {
      if (c !== "\r") run.text += c === "\t" ? " " : c;
      continue;
    }
    i += 1;
    const command = markup[i];
    if (command === undefined) break;
    if (command === "%") run.text += "%";
    else if (command >= "0" && command <= "9") flush(), (run = { ...run, color: Number(command) });
    else if (command === "R" || command === "r") flush(), (run = { ...run, color: 0 });
    else if (command === "M" || command === "m") flush(), (run = { ...run, mono: !run.mono });
    else if (command === "@" || command === ":") {
      const end = markup.indexOf("%", i + 1);
      if (end < 0) break;
      if (command === "@") {
        const font = FONT_OF[markup.slice(i + 1, end)];
        if (font === undefined) break;
        flush();
        run = { ...run, font };
      }
      i = end;
    }
  }
  flush();
  return lines;
}

function ink(color: Color): string {
  return cssColor(color, color[3]);
}

function body(one: Component, palette: readonly Color[]): Child[] {
  const caption = one.caption === "" ? [] : [h("div", null, one.caption)];
  if (!one.isMarkup) return [...caption, h("div", null, one.text)];
  return [...caption, ...parseMarkup(one.text).map((line) => h("div", null, line.map((run) =>
    h(`span.${CLASS_OF[run.font] ?? "small"}${run.mono ? ".mono" : ""}`, { style: { color: ink(palette[run.color] ?? [1, 1, 1, 1]) } }, run.text)), line.length === 0 && "\u00a0"))];
}

/** Boxes of text that scripts put on the screen or into the world. */
export class ScriptUi {
  /** `press`: a button of this name was clicked. */
  constructor(private readonly layer: HTMLElement, private readonly assets: Assets, private readonly press: (button: string) => void) {}

  clear(): void {
    patch(this.layer, []);
  }

  /** Returns the areas that the boxes on the screen cover. */
  draw(components: readonly Component[], palette: readonly Color[], camera: PerspectiveCamera, width: number, height: number): Box[] {
    const covered: Box[] = [], byId = new Map(components.map((one) => [one.id, one])), shown: Child[] = [];
    for (const one of [...components].sort((a, b) => a.layer - b.layer)) {
      if (!one.visible || (one.width < 1 && one.text === "")) continue;
      let { x, y } = one, world = one.world;
      for (let parent = byId.get(one.parent), left = 16; parent !== undefined && left > 0; parent = byId.get(parent.parent), --left) {
        x += parent.x;
        y += parent.y;
        world ??= parent.world;
      }
      let scale = "1";
      if (world !== null) {
        const right = new Vector3(METRES_PER_PX, 0, 0).applyQuaternion(new Quaternion(...world.turn)), down = new Vector3(0, -METRES_PER_PX, 0).applyQuaternion(new Quaternion(...world.turn));
        const at = new Vector3(...world.place).addScaledVector(right, one.world === null ? x : 0).addScaledVector(down, one.world === null ? y : 0);
        const away = at.clone().applyMatrix4(new Matrix4().copy(camera.matrixWorldInverse)).z;
        if (away > -0.2) continue;
        const point = at.project(camera);
        x = ((point.x + 1) / 2) * width;
        y = ((1 - point.y) / 2) * height;
        scale = ((METRES_PER_PX * height) / (2 * Math.tan((camera.fov * Math.PI) / 360) * -away)).toFixed(3);
      }
      if (world === null) {
        // Boxes made for an entire screen are scaled down if there is no room.
        const wide = Math.max(one.width, 1), fitting = Math.min(1, Math.max(LEAST_FITTING, Math.min((width - x - EDGE_PX) / wide, Math.max(READABLE, (MOST_SHARE * width) / wide))));
        if (fitting < 1) scale = fitting.toFixed(3);
        covered.push({ left: x, top: y, width: one.width * fitting, height: one.height * fitting });
      }
      const gradient = one.gradient, image = this.assets.url(one.material), isButton = one.button !== "";
      const angle = gradient?.direction === "diagonal" ? "135deg" : gradient?.direction === "vertical" ? "180deg" : "90deg";
      const grounds = [image === null ? "" : `center / 100% 100% no-repeat url(${image})`, gradient === null ? "" : `linear-gradient(${angle}, ${ink(gradient.from)}, ${ink(gradient.to)})`].filter((ground) => ground !== "");
      shown.push(h(`${isButton ? "button" : "div"}.box.${CLASS_OF[one.font] ?? "small"}`, {
        key: `${one.id}${isButton ? " button" : ""}`,
        // The picture keeps the focus, and with it the keys.
        ...(isButton ? { attributes: { type: "button", "data-button": one.button }, on: { click: () => this.press(one.button), pointerdown: (event: PointerEvent) => event.preventDefault() } } : {}),
        style: {
          left: `${x}px`, top: `${y}px`, width: `${Math.max(one.width, 0)}px`, height: `${Math.max(one.height, 0)}px`, padding: `${one.marginTop}px 0 0 ${one.marginLeft}px`,
          color: ink(one.textColor), transform: `scale(${scale})`, ...(grounds.length === 0 ? {} : { background: grounds.join(", ") }),
        },
      }, one.bar !== null && h("i.bar", { style: { width: `${(one.bar.share * 100).toFixed(2)}%`, background: ink(one.bar.color) } }), body(one, palette)));
    }
    patch(this.layer, shown);
    return covered;
  }
}
