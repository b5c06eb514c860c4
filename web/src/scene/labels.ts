// SPDX-License-Identifier: BSD-2-Clause
import { Vector3, type PerspectiveCamera } from "three";
import type { NamedPlace, Scene, Speech, Vec3 } from "../format/scene";
import { h, patch, type Child } from "../dom/view";
import { LabelLayout, type Box } from "./label_layout";
import { agentColor, cssColor, FOREIGN, type Rgb } from "./looks";
import type { BelievedBody, OverlayWord, Placed } from "./overlays";
import { DOING_FONT, NAME_FONT, SPEECH_FONT, textWidth } from "./text_width";

const MOST_NAMES = 60, MOST_PLACES = 24, MOST_SPEECH = 8, GONE_M = 130, PLACE_GONE_M = 90;
/** Duration of a text over its speaker's head. */
export const SPEECH_S = 3.5;
/** Names are shown up to this multiple of the distance to the camera's target. */
const FURTHER = 2, MOST_COVERED = 0.5;
/**
 * With more agents than this, or if complete labels would cover more than this share of the picture, labels show only
 * names, except for the selected agent.
 */
const MOST_WHOLE = 24, MOST_LABELLED = 0.15, WHOLE_LABEL_PX2 = 80 * 44;
/** Border, padding and height of a name alone. */
const COMPACT_EDGES_PX = 12, COMPACT_PX = 20;
/** Border and padding of a name, as scene.css has them. */
const NAME_EDGES_PX = 20;
/** Shorter lines between labels and agents are left out. Lines begin at least this far from a label's corner. */
const LEAST_THREAD_PX = 12, THREAD_INSET_PX = 8;
/** Longer speech is wrapped. */
const SPEECH_PX = 210;
const FADES_S = 0.6, LEAST_OPACITY = 0.35;

/** The opacity of a text that was said some seconds ago. 0: it is not shown, because it would be too faint to be read, for example as long as the world is paused. */
export function speechOpacity(age_s: number): number {
  const opacity = Math.min(1, (SPEECH_S - age_s) / FADES_S);
  return opacity < LEAST_OPACITY ? 0 : opacity;
}
const PLACE_SIGNS: Readonly<Record<NamedPlace["kind"], string>> = { waypoint: "○", region: "□", thing: "■", item: "◆" };

export function healthColor(share: number): Rgb {
  return share < 0.5 ? [0.92, 0.25 + 0.9 * share, 0.08] : [0.92 - 1.6 * (share - 0.5), 0.7, 0.08 + 0.8 * (share - 0.5)];
}

const headOf = (one: Placed): Vec3 => [one.place[0], one.place[1] + one.agent.height / 2 + 0.15, one.place[2]];
const shortened = (text: string, most: number): string => (text.length > most ? `${text.slice(0, most - 1)}…` : text);

/** A short description of what an agent is doing. */
export function doingOf(scene: Scene, id: number): string {
  const agent = scene.agents.get(id), mind = scene.minds.get(id);
  if (agent === undefined) return "";
  if (agent.failed) return "stopped by an error";
  if (!agent.alive) return "dead";
  const operator = mind?.operator ?? "", body = mind !== undefined && mind.doing !== "" ? mind.doing : agent.lastCommand;
  if (operator === "" && body === "" && agent.kind === FOREIGN) return "foreign";
  if (operator === "") return shortened(body, 30);
  return body === "" || body === operator ? shortened(operator, 30) : `${shortened(operator, 24)} · ${shortened(body, 24)}`;
}

export interface LabelScene {
  scene: Scene;
  time: number;
  placed: ReadonlyMap<number, Placed>;
  selected: number;
  on: ReadonlySet<OverlayWord>;
  ghosts: readonly BelievedBody[];
  width: number;
  height: number;
  camera: PerspectiveCamera;
  /** The areas over the picture; labels are not placed under them. */
  covered: readonly Box[];
  /** Distance from the camera to its target, in m. */
  away: number;
  /** What agents printed, as they say it. */
  printed: readonly Speech[];
}

interface Point { x: number; y: number; away: number }

/** HTML elements over the picture: names, health, actions and speech of agents. */
export class Labels {
  private readonly at = new Vector3();
  private dots: { place: Vec3; color: Rgb }[] = [];

  constructor(private readonly layer: HTMLElement, private readonly select: (id: number) => void) {}

  clear(): void {
    patch(this.layer, []);
  }

  /** Draws the labels. Returns a dot for each agent without space for a name. */
  draw(view: LabelScene): { place: Vec3; color: Rgb }[] {
    this.dots = [];
    patch(this.layer, this.labels(view));
    return this.dots;
  }

  /** Null: behind the camera or outside of the picture. */
  private project(place: Vec3, { camera, width, height }: LabelScene): Point | null {
    this.at.set(...place);
    const away = this.at.distanceTo(camera.position);
    this.at.project(camera);
    if (this.at.z > 1 || this.at.z < -1) return null;
    const x = ((this.at.x + 1) / 2) * width, y = ((1 - this.at.y) / 2) * height;
    return x < -20 || y < -20 || x > width + 20 || y > height + 20 ? null : { x, y, away };
  }

  private labels(view: LabelScene): Child[] {
    const { scene, placed, selected, on } = view, layout = new LabelLayout(view.width, view.height), shown: Child[] = [];
    const heads: { one: Placed; point: Point }[] = [];
    for (const one of placed.values()) {
      const point = this.project(headOf(one), view);
      if (point !== null && point.away < Math.max(GONE_M, FURTHER * view.away)) heads.push({ one, point });
    }
    heads.sort((a, b) => (a.one.id === selected ? -1 : b.one.id === selected ? 1 : a.point.away - b.point.away));
    // Areas over the picture block labels, unless they cover most of it.
    for (const box of view.covered) if (box.width * box.height < MOST_COVERED * view.width * view.height) layout.block(box);
    for (const { point } of heads.slice(0, 24)) {
      const size = Math.min(600 / point.away, 60);
      layout.block({ left: point.x - size / 3, top: point.y, width: (2 * size) / 3, height: size * 1.4 });
    }
    shown.push(...this.speech(view, layout));
    if (on.has("labels")) {
      let names = 0;
      for (const { one, point } of heads) {
        const isSelected = one.id === selected, doing = doingOf(scene, one.id), name = `${one.agent.kind === FOREIGN ? "◇ " : ""}${shortened(one.agent.name, 28)}`, nameWide = textWidth(name, NAME_FONT);
        // In a crowd, labels show names only: they are more important than operators.
        const isCrowd = !isSelected && (heads.length > MOST_WHOLE || heads.length * WHOLE_LABEL_PX2 > MOST_LABELLED * view.width * view.height);
        const whole = names < MOST_NAMES && !isCrowd ? layout.place(point.x, point.y, Math.max(nameWide, textWidth(doing, DOING_FONT), 44) + NAME_EDGES_PX, doing === "" ? 29 : 44) : null;
        const box = whole ?? (names < MOST_NAMES ? layout.place(point.x, point.y, nameWide + COMPACT_EDGES_PX, COMPACT_PX) : null);
        if (box === null) {
          this.dots.push({ place: headOf(one), color: agentColor(one.agent) });
          continue;
        }
        names += 1;
        shown.push(this.name(one, name, whole === null ? null : doing, box, point, isSelected));
      }
    }
    for (const [i, ghost] of view.ghosts.entries()) {
      const point = this.project([ghost.place[0], ghost.place[1] + ghost.height / 2, ghost.place[2]], view);
      const box = point === null ? null : layout.place(point.x, point.y, textWidth(ghost.name, DOING_FONT) + 12, 18);
      if (box !== null) shown.push(h("div.ghost-name", { key: `g${i}`, style: { ...position(box), color: cssColor(ghost.color) } }, ghost.name));
    }
    if (on.has("places")) shown.push(...this.places(view, layout));
    return shown;
  }

  /** `doing`: null for a name alone. */
  private name(one: Placed, name: string, doing: string | null, box: Box, point: Point, isSelected: boolean): Child {
    const health = Math.min(Math.max(one.agent.health / 100, 0), 1), color = cssColor(agentColor(one.agent));
    const [x, y] = threadFrom(box, point);
    return [
      Math.hypot(x - point.x, y - point.y) > LEAST_THREAD_PX && h("div.thread", { key: `t${one.id}`, style: threadStyle(x, y, point.x, point.y) }),
      h(`div.name${isSelected ? ".selected" : ""}${doing === null ? ".compact" : ""}`, { key: `n${one.id}`, style: { ...position(box), "border-left-color": color }, on: { click: () => this.select(one.id) } },
        h("b", null, name), doing !== null && doing !== "" && h("span", null, doing),
        one.agent.alive && doing !== null && h("i.health", null, h("i", { style: { width: `${Math.round(health * 100)}%`, background: cssColor(healthColor(health)) } }))),
    ];
  }

  private speech(view: LabelScene, layout: LabelLayout): Child[] {
    if (!view.on.has("labels")) return [];
    const shown: Child[] = [], said = [...view.scene.speech, ...view.printed].filter((one) => view.time - one.time < SPEECH_S && view.time - one.time > -SPEECH_S).slice(-MOST_SPEECH);
    for (const one of said.reverse()) {
      const speaker = view.placed.get(one.from), text = shortened(one.text, 90);
      const opacity = speechOpacity(view.time - one.time);
      if (speaker === undefined || text === "" || opacity === 0) continue;
      const point = this.project([speaker.place[0], speaker.place[1] + speaker.agent.height / 2 + 0.3, speaker.place[2]], view);
      const wide = textWidth(text, SPEECH_FONT) * 1.04, room = Math.min(wide, SPEECH_PX), lines = Math.ceil((wide / room) * (wide > room ? 1.15 : 1)), box = point === null ? null : layout.place(point.x + 30, point.y - 50, room + 24, lines * 16 + 12);
      if (box === null || point === null) continue;
      const key = `${one.from}/${one.time}/${one.text}`;
      shown.push(
        h("div.thread.speaking", { key: `u${key}`, style: threadStyle(...threadFrom(box, point), point.x, point.y) }),
        h("div.speech", { key: `s${key}`, style: { ...position(box), opacity: String(opacity) } }, text));
    }
    return shown;
  }

  private places(view: LabelScene, layout: LabelLayout): Child[] {
    const near = view.scene.places.map((place) => ({ place, point: this.project(place.place, view) })).filter((one) => one.point !== null && one.point.away < Math.max(PLACE_GONE_M, FURTHER * view.away))
      .sort((a, b) => a.point!.away - b.point!.away).slice(0, MOST_PLACES);
    return near.map(({ place, point }) => {
      const box = layout.place(point!.x, point!.y - 4, textWidth(place.name, DOING_FONT) + 30, 19);
      return box !== null && h(`div.place.${place.kind}`, { key: `p${place.kind}${place.name}`, style: position(box) }, h("i", null, PLACE_SIGNS[place.kind]), place.name);
    });
  }
}

function position(box: Box): Record<string, string> {
  return { transform: `translate(${box.left.toFixed(1)}px, ${box.top.toFixed(1)}px)`, width: `${Math.ceil(box.width)}px` };
}

/** Where the line from a label to its agent begins: on the edge that faces the agent. */
export function threadFrom(box: Box, to: { x: number; y: number }): [x: number, y: number] {
  const bottom = box.top + box.height, isBeside = to.y >= box.top && to.y <= bottom;
  if (isBeside) return [to.x < box.left ? box.left : Math.min(to.x, box.left + box.width), to.y];
  return [Math.min(Math.max(to.x, box.left + THREAD_INSET_PX), box.left + box.width - THREAD_INSET_PX), to.y < box.top ? box.top : bottom];
}

function threadStyle(x0: number, y0: number, x1: number, y1: number): Record<string, string> {
  const away = Math.hypot(x1 - x0, y1 - y0), angle = Math.atan2(y1 - y0, x1 - x0);
  return { transform: `translate(${x0.toFixed(1)}px, ${y0.toFixed(1)}px) rotate(${angle.toFixed(3)}rad) scaleX(${away.toFixed(1)})` };
}
