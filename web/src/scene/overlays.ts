// SPDX-License-Identifier: BSD-2-Clause
import type { Agent, Mind, Scene, Vec3 } from "../format/scene";
import { ink, type Ink, type LineBatch } from "./line_batch";
import { agentColor, bright, FOREIGN, type Rgb } from "./looks";
import { cross, length, minus, plus, times, unit } from "./vectors";

/** What can be drawn over the scene; each is on or off. */
export const OVERLAYS = [
  { word: "labels", title: "Names" }, { word: "trails", title: "Trails" }, { word: "senses", title: "Senses" }, { word: "goals", title: "Paths and goals" },
  { word: "shots", title: "Shots" }, { word: "belief", title: "Belief" }, { word: "places", title: "Places" },
  { word: "forces", title: "Forces" }, { word: "navigation", title: "Navigation mesh" }, { word: "influence", title: "Influence map" }, { word: "physics", title: "Physics shapes" },
] as const;
export type OverlayWord = (typeof OVERLAYS)[number]["word"];
/** Overlays that cost the run time: they are requested while they are on, and recordings do not have them. */
export const COSTLY: ReadonlySet<OverlayWord> = new Set(["forces", "navigation", "influence", "physics"]);

const TRAIL_STEP_M = 0.3, MOST_TRAIL_POINTS = 160, JUMP_M = 3;
const TRACER_S = 0.7, HIT_MARK_S = 1.8;
const SIGHT: Rgb = [1, 0.93, 0.55], HEARING: Rgb = [0.55, 0.85, 1], TRACER: Rgb = [1, 0.85, 0.35], HIT: Rgb = [1, 0.22, 0.12], MISS: Rgb = [0.92, 0.9, 0.85];
const VELOCITY: Rgb = [0.35, 0.9, 1], FORCE: Rgb = [1, 0.45, 0.85];
const UNKNOWN: Rgb = [0.6, 0.62, 0.66];

/** The current pose of an agent, interpolated between two moments. */
export interface Placed { id: number; agent: Agent; place: Vec3; forward: Vec3 }

export const feetOf = (placed: Placed): Vec3 => [placed.place[0], placed.place[1] - placed.agent.height / 2, placed.place[2]];

class Pen {
  constructor(private readonly out: LineBatch) {}

  line(from: Vec3, to: Vec3, color: Ink): void {
    this.out.line(from, to, color);
  }

  dashes(from: Vec3, to: Vec3, color: Ink, dash = 0.5): void {
    const whole = length(minus(to, from)), along = unit(minus(to, from));
    if (whole > 500) return;
    for (let at = 0; at < whole; at += 2 * dash) this.line(plus(from, times(along, at)), plus(from, times(along, Math.min(at + dash, whole))), color);
  }

  circle(centre: Vec3, radius: number, color: Ink, dashed = false): void {
    for (let i = 0; i < 48; i += dashed ? 2 : 1) this.line(on(centre, radius, (i * Math.PI) / 24), on(centre, radius, ((i + 1) * Math.PI) / 24), color);
  }

  arrow(from: Vec3, to: Vec3, color: Ink): void {
    this.line(from, to, color);
    const along = unit(minus(to, from)), across = unit(cross(along, [0, 1, 0])), head = Math.min(0.35, 0.4 * length(minus(to, from)));
    for (const side of [0.5, -0.5]) this.line(to, plus(plus(to, times(along, -head)), times(across, side * head)), color);
  }

  star(at: Vec3, size: number, color: Ink): void {
    for (const arm of [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.6, 0.6, 0.5], [-0.6, 0.6, 0.5], [0.6, 0.6, -0.5], [-0.6, 0.6, -0.5]] as const)
      this.line(minus(at, times(arm, size)), plus(at, times(arm, size)), color);
  }

  sector(centre: Vec3, radius: number, heading: number, half: number, edge: Ink, fill: Ink): void {
    const pieces = Math.max(6, Math.floor((48 * half) / Math.PI)), whole = half > 0.999 * Math.PI;
    let before = on(centre, radius, heading - half);
    if (!whole) this.line(centre, before, edge);
    for (let i = 1; i <= pieces; ++i) {
      const next = on(centre, radius, heading - half + (2 * half * i) / pieces);
      this.line(before, next, edge);
      if (fill[3] > 0) this.out.fill(centre, before, next, fill);
      before = next;
    }
    if (!whole) this.line(before, centre, edge);
  }
}

function on(centre: Vec3, radius: number, heading: number): Vec3 {
  return [centre[0] + radius * Math.sin(heading), centre[1], centre[2] + radius * Math.cos(heading)];
}

const lifted = (p: Vec3, by: number): Vec3 => [p[0], p[1] + by, p[2]];

/** The recent positions of agents. */
export class Trails {
  private readonly courses = new Map<number, Vec3[]>();
  private readonly moves = new Map<number, { place: Vec3; velocity: Vec3 }>();
  private tick = -1;
  private time = 0;

  note(scene: Scene): void {
    if (scene.tick < this.tick || scene.tick > this.tick + 300) this.clear();
    const seconds = scene.time - this.time, isNew = scene.tick !== this.tick;
    this.tick = scene.tick;
    this.time = scene.time;
    for (const id of this.courses.keys()) if (!scene.agents.has(id)) this.courses.delete(id);
    for (const [id, agent] of scene.agents) {
      const course = this.courses.get(id) ?? [], feet: Vec3 = [agent.place[0], agent.place[1] - agent.height / 2, agent.place[2]], last = course.at(-1);
      if (last === undefined || length(minus(feet, last)) >= TRAIL_STEP_M) course.push(feet);
      if (course.length > MOST_TRAIL_POINTS) course.shift();
      this.courses.set(id, course);
      if (!isNew) continue;
      const before = this.moves.get(id);
      this.moves.set(id, { place: agent.place, velocity: before !== undefined && seconds > 0 ? times(minus(agent.place, before.place), 1 / seconds) : [0, 0, 0] });
    }
  }

  clear(): void {
    this.courses.clear();
    this.moves.clear();
    this.tick = -1;
  }

  of(id: number): readonly Vec3[] {
    return this.courses.get(id) ?? [];
  }

  /** Velocity in m/s, from the last two received moments. */
  velocityOf(id: number): Vec3 {
    return this.moves.get(id)?.velocity ?? [0, 0, 0];
  }
}

function paintTrail(pen: Pen, placed: Placed, points: readonly Vec3[]): void {
  const color = bright(agentColor(placed.agent)), all = [...points, feetOf(placed)];
  for (let i = 1; i < all.length; ++i) {
    if (length(minus(all[i]!, all[i - 1]!)) > JUMP_M) continue;
    pen.line(lifted(all[i - 1]!, 0.06), lifted(all[i]!, 0.06), ink(color, 0.9 * (1 - (all.length - i) / MOST_TRAIL_POINTS)));
  }
}

function paintSenses(pen: Pen, placed: Placed, mind: Mind, filled: boolean): void {
  if (!placed.agent.alive) return;
  const ground = lifted(feetOf(placed), 0.09);
  if (mind.measured !== null) {
    const place: Vec3 = [mind.measured[0], ground[1], mind.measured[2]], away = length(minus(place, ground));
    if (away < 500) pen.circle(ground, away, ink(SIGHT, filled ? 0.8 : 0.4), true);
    pen.dashes(ground, place, ink(SIGHT, filled ? 0.9 : 0.5), 0.4);
    pen.circle(place, 0.3, ink(SIGHT, 0.9));
  }
  if (mind.senses === null) return;
  const { sight, viewDeg, hearing } = mind.senses, heading = Math.atan2(placed.forward[0], placed.forward[2]);
  if (sight > 0) pen.sector(ground, sight, heading, (viewDeg * Math.PI) / 360, ink(SIGHT, filled ? 0.9 : 0.45), ink(SIGHT, filled ? 0.13 : 0));
  if (hearing > 0) pen.circle(ground, hearing, ink(HEARING, filled ? 0.9 : 0.4), true);
}

function paintGoals(pen: Pen, placed: Placed, mind: Mind, others: ReadonlyMap<number, Placed>): void {
  if (!placed.agent.alive) return;
  const color = bright(agentColor(placed.agent)), feet = feetOf(placed);
  let before = lifted(feet, 0.18);
  mind.path.forEach((corner, i) => {
    const next = lifted(corner, 0.18);
    if (i === 0 && mind.pathIsWhole) before = next;
    else if (i + 1 === mind.path.length) pen.arrow(before, next, ink(color));
    else pen.line(before, next, ink(color));
    pen.circle(next, 0.14, ink(color, 0.8));
    before = next;
  });
  const target = others.get(mind.target), leader = others.get(mind.leader);
  if (target !== undefined) {
    pen.arrow(lifted(placed.place, 0.3), lifted(target.place, 0.3), ink(HIT, 0.85));
    pen.circle(target.place, target.agent.radius * 1.9, ink(HIT));
  }
  if (leader !== undefined) pen.dashes(placed.place, leader.place, ink(color, 0.8), 0.35);
  if (mind.goal === null) return;
  const goal: Vec3 = [mind.goal[0], feet[1] + 0.12, mind.goal[2]];
  if (mind.path.length === 0) pen.dashes(lifted(feet, 0.12), goal, ink(color, 0.7));
  pen.circle(goal, 0.35, ink(color));
  pen.line(goal, lifted(goal, 1.6), ink(color));
  pen.line(lifted(goal, 1.6), plus(goal, [0.5, 1.4, 0]), ink(color));
  pen.line(plus(goal, [0.5, 1.4, 0]), lifted(goal, 1.2), ink(color));
}

/** The believed positions of other agents, with a thread to their real positions. */
export interface BelievedBody { name: string; place: Vec3; color: Rgb; opacity: number; radius: number; height: number }

function paintBelief(pen: Pen, self: Placed, mind: Mind, others: ReadonlyMap<number, Placed>): BelievedBody[] {
  const ghosts: BelievedBody[] = [];
  if (mind.senses === null) return ghosts;
  for (const [id, other] of others) {
    if (id === self.id) continue;
    const contact = mind.contacts.find((one) => one.agent === id), feet = lifted(feetOf(other), 0.07);
    if (contact === undefined) {
      pen.circle(feet, 0.6, ink(UNKNOWN, 0.8), true);
      continue;
    }
    const sure = contact.visible ? 1 : 1 - contact.forgotten, color = bright(agentColor(other.agent));
    if (length(minus(contact.place, other.place)) < 0.4) {
      pen.circle(feet, 0.6, ink(color, 0.35 + 0.65 * sure), !contact.visible);
      continue;
    }
    ghosts.push({
      name: `${other.agent.name}${contact.heard ? " · heard" : ""}${contact.alive ? "" : " · dead"}`, place: contact.place, color, opacity: 0.25 + 0.5 * sure,
      radius: other.agent.radius, height: other.agent.height,
    });
    pen.dashes(contact.place, other.place, ink(color, 0.4 + 0.5 * sure), 0.25);
    pen.circle(lifted(contact.place, 0.07 - other.agent.height / 2), 0.55, ink(color, 0.5 + 0.5 * sure));
  }
  return ghosts;
}

/** The length of arrows: 10 m/s² are two metres. The limits keep collisions and impulses from filling the picture. */
const METRES_PER_PUSH = 0.2, LONGEST_PUSH_M = 4, LEAST_PUSH_M = 0.04, MOST_PUSHES = 12, METRES_PER_SPEED = 0.6;

/** Velocities of bodies and the forces on them; the sum of several forces is drawn brighter. */
function paintForces(pen: Pen, scene: Scene, placed: ReadonlyMap<number, Placed>, trails: Trails): void {
  for (const one of placed.values()) {
    const [x, , z] = trails.velocityOf(one.id), from = lifted(one.place, 0.1);
    if (one.agent.alive && Math.hypot(x, z) > 0.05) pen.arrow(from, plus(from, times([x, 0, z], METRES_PER_SPEED)), ink(VELOCITY));
  }
  const arrow = (from: Vec3, acceleration: Vec3, alpha: number): void => {
    const push = times(acceleration, METRES_PER_PUSH), long = length(push);
    if (long > LEAST_PUSH_M) pen.arrow(from, plus(from, long > LONGEST_PUSH_M ? times(push, LONGEST_PUSH_M / long) : push), ink(FORCE, alpha));
  };
  const sums = new Map<number, { from: Vec3; acceleration: Vec3; count: number }>();
  for (const push of scene.pushes) {
    if (!(push.mass > 0)) continue;
    const at = placed.get(push.owner)?.place ?? push.place, from = lifted(at, 0.25), acceleration = times(push.force, 1 / push.mass), sum = sums.get(push.owner);
    sums.set(push.owner, { from, acceleration: plus(sum?.acceleration ?? [0, 0, 0], acceleration), count: (sum?.count ?? 0) + 1 });
    if ((sum?.count ?? 0) < MOST_PUSHES) arrow(from, acceleration, 0.45);
  }
  for (const { from, acceleration } of sums.values()) arrow(from, acceleration, 1);
}

export interface OverlayScene {
  scene: Scene;
  time: number;
  placed: ReadonlyMap<number, Placed>;
  selected: number;
  on: ReadonlySet<OverlayWord>;
  trails: Trails;
}

/** Draws the active overlays and the lines of scripts. Returns the bodies at believed positions. */
export function paintOverlays(out: LineBatch, { scene, time, placed, selected, on: shown, trails }: OverlayScene): BelievedBody[] {
  const pen = new Pen(out);
  let ghosts: BelievedBody[] = [];
  for (const lines of [scene.lines, scene.overlayLines]) {
    for (const line of lines.lines) pen.line(line.from, line.to, line.color);
    for (const circle of lines.circles) pen.circle(circle.center, circle.radius, circle.color);
    for (const face of lines.triangles) out.fill(face.a, face.b, face.c, face.color);
  }
  for (const particle of scene.particles) {
    if (!particle.visible) continue;
    if (particle.effect === "Bullet") pen.line(particle.place, minus(particle.place, times(particle.direction, 0.8)), ink(TRACER));
    else if (particle.effect !== "") pen.star(particle.place, 0.16, ink(MISS, 0.8));
  }
  for (const one of placed.values()) {
    if (shown.has("trails")) paintTrail(pen, one, trails.of(one.id));
    if (shown.has("labels") && one.agent.kind === FOREIGN && one.agent.alive) pen.circle(lifted(feetOf(one), 0.06), one.agent.radius * 2, ink(agentColor(one.agent)), true);
    const mind = scene.minds.get(one.id), isSelected = one.id === selected;
    if (mind === undefined) continue;
    if (shown.has("senses") && (isSelected || selected === 0)) paintSenses(pen, one, mind, isSelected);
    if (shown.has("goals")) paintGoals(pen, one, mind, placed);
    if (shown.has("belief") && isSelected) ghosts = paintBelief(pen, one, mind, placed);
  }
  if (shown.has("shots")) {
    for (const shot of scene.shots) {
      const age = Math.max(0, time - shot.time);
      if (age < TRACER_S) pen.line(shot.from, shot.to, ink(TRACER, 1 - age / TRACER_S));
      if (age >= HIT_MARK_S) continue;
      if (shot.hit !== 0) pen.star(shot.to, 0.32, ink(HIT, 1.3 - age / HIT_MARK_S));
      else pen.star(shot.to, 0.14, ink(MISS, 1 - age / HIT_MARK_S));
    }
  }
  if (shown.has("forces")) paintForces(pen, scene, placed, trails);
  const chosen = placed.get(selected);
  if (chosen !== undefined) {
    const feet = lifted(feetOf(chosen), 0.08);
    pen.circle(feet, Math.max(0.55, chosen.agent.radius * 1.5), [1, 0.86, 0.35, 1]);
    pen.circle(feet, Math.max(0.6, chosen.agent.radius * 1.6), [1, 0.86, 0.35, 0.7]);
  }
  return ghosts;
}
