// SPDX-License-Identifier: BSD-2-Clause
import {
  ACESFilmicToneMapping, AmbientLight, BasicShadowMap, CapsuleGeometry, Color, DirectionalLight, FogExp2, HemisphereLight, Mesh, MeshBasicMaterial, PCFShadowMap, PointLight, Scene as World, Vector3,
  WebGLRenderer,
} from "three";
import type { Structure } from "../format/drawables";
import { Shape, type Light, type Scene, type Speech, type Vec3 } from "../format/scene";
import type { Ghosts } from "../run/contents";
import { Playout, type Between } from "../run/playout";
import { Bodies } from "./bodies";
import { RecentGround } from "./camera_keeper";
import { CameraRig, type Shown } from "./camera_rig";
import { Dots } from "./dots";
import { boardOf, freeOf, hasWalls, sceneryAround, type FramedBody } from "./framing";
import { FIRST_OF_PROCESSOR, Governor, SLOW_EVERY_MS } from "./governor";
import type { Box } from "./label_layout";
import { Labels, SPEECH_S } from "./labels";
import { LineBatch } from "./line_batch";
import { paintImagined } from "./imagined";
import { lookOf } from "./looks";
import { geometryOf, Materials, PLAIN_SIDE_M } from "./materials";
import { MovingModels } from "./moving_models";
import { paintOverlays, Trails, type BelievedBody, type OverlayWord, type Placed } from "./overlays";
import { whenPainted } from "./painter";
import { Assets, type AssetContent } from "./assets";
import { Sounds } from "./sounds";
import { ScriptUi } from "./script_ui";
import { ShapeLibrary, type ShapeContent } from "./shape_library";
import { Sky } from "./sky";
import { Things } from "./things";
import { length, minus, times } from "./vectors";

const LIGHT_SCALE = Math.PI;
const MOST_POINT_LIGHTS = 4;
/** The picture also shows texts that are printed at most this many seconds after its moment. */
const JUST_NOW_S = 0.1;
/** A body that moves further than this between two moments was teleported. */
const JUMP_M = 3;
/** In a world that runs faster than this, past positions predict future ones better than velocities. */
const FAST_PACE = 4;
const NOBODY_MOVES: Vec3 = [0, 0, 0];
/** Interval between searches for scenery around the agents, in simulated seconds. */
const SCENERY_EVERY_S = 1;
const BACKDROP = ["backdrop/hills", "backdrop/trees", "backdrop/fence"] as const;

export interface SceneEvents {
  selected(id: number): void;
  /** A button of the world's scripts was clicked. */
  pressed(button: string): void;
  /** `keeps`: the camera keeps everybody in the picture. `outside`: the number of living agents outside of it. */
  framed(keeps: boolean, outside: number, living: number): void;
}

/** Draws a run. Draws new pictures only while something moves. */
export class SceneView {
  readonly rig = new CameraRig();
  readonly on = new Set<OverlayWord>(["labels", "shots", "places"]);
  readonly playout = new Playout();
  isPaused = false;
  /** Whether the world is a game on a board. */
  isBoard = false;
  /** Areas over the picture, in its pixels. Labels are not placed under them. */
  covered: readonly Box[] = [];
  private readonly renderer: WebGLRenderer;
  private readonly world = new World();
  private readonly materials = new Materials();
  private readonly shapes = new ShapeLibrary(() => this.wake());
  private readonly things = new Things(this.materials, this.shapes);
  private readonly bodies = new Bodies(this.materials, this.shapes);
  private readonly models = new MovingModels(this.materials, this.shapes);
  private readonly sky = new Sky();
  private readonly sun = new DirectionalLight();
  private readonly ambient = new HemisphereLight();
  private readonly fill = new AmbientLight(0xffffff, 0);
  private readonly lines = new LineBatch(2);
  private readonly dots = new Dots();
  private readonly trails = new Trails();
  private readonly assets = new Assets();
  readonly sounds = new Sounds(this.assets);
  private readonly labels: Labels;
  private readonly scriptUi: ScriptUi;
  private readonly pointLights: PointLight[] = [];
  private backdrop: Mesh[] = [];
  private plains: { structure: Structure | null; slots: number[] } = { structure: null, slots: [] };
  private ghosts: Mesh[] = [];
  private scene: Scene | null = null;
  private imagined: Ghosts | null = null;
  private placed = new Map<number, Placed>();
  private selectedId = 0;
  private lastFrame = 0;
  private readonly isProcessor: boolean;
  private governor: Governor;
  private restless = 2;
  private stopped = false;
  private isFramed = false;
  private readonly recentGround = new RecentGround();
  private around: { scene: number; time: number; scenery: readonly FramedBody[]; board: readonly FramedBody[]; hasWalls: boolean } | null = null;
  /** Values of the last second, for measurements. */
  framesPerSecond = 0;
  private frames = 0;
  private pictures = 0;
  private framesSince = 0;

  /** `isFull`: everything is drawn in full detail, however long it takes. */
  constructor(private readonly place: HTMLElement, private readonly canvas: HTMLCanvasElement, labelLayer: HTMLElement, scriptLayer: HTMLElement, private readonly events: SceneEvents, private isFull: boolean) {
    const context = contextOf(canvas);
    this.isProcessor = isDrawnByProcessor(context);
    this.governor = this.newGovernor();
    this.renderer = new WebGLRenderer({ canvas, context });
    // Shader errors are checked during development only, because the check delays the first frame.
    this.renderer.debug.checkShaderErrors = false;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.autoUpdate = false;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.toneMapping = ACESFilmicToneMapping;
    this.renderer.toneMappingExposure = 0.98;
    this.world.fog = new FogExp2(0xd0dde6, 0.0042);
    this.sun.castShadow = true;
    this.sun.shadow.bias = -0.0004;
    this.sun.shadow.normalBias = 0.03;
    this.world.add(this.sky.mesh, this.sun, this.sun.target, this.ambient, this.fill, this.things.group, this.bodies.group, this.models.group, this.lines.fills, this.lines.lines, this.dots.points);
    whenPainted(() => this.wake());
    this.labels = new Labels(labelLayer, (id) => events.selected(id));
    this.scriptUi = new ScriptUi(scriptLayer, this.assets, (button) => events.pressed(button));
    this.drawAs();
    new ResizeObserver(() => this.wake()).observe(place);
    canvas.addEventListener("webglcontextrestored", () => this.wake());
    requestAnimationFrame((now) => this.frame(now));
  }

  take(scene: Scene): void {
    this.scene = scene;
    this.playout.add(scene, performance.now() / 1000);
    this.trails.note(scene);
    this.sounds.take(scene.sounds, this.rig.camera, !this.isPaused);
    this.wake();
  }

  /** Adds a shape of the run: the contents "shapes:KEY". */
  takeShape(key: string, content: ShapeContent): Promise<void> {
    return this.shapes.add(key, content);
  }

  /** Adds an image or a sound of the run: the contents "assets:KEY". */
  takeAsset(key: string, content: AssetContent): void {
    this.assets.add(key, content);
    this.wake();
  }

  /**
   * Returns the texts that agents printed between two times of the world. They are shown over their heads for a while,
   * also at a past moment.
   */
  printedBetween: (from: number, until: number) => readonly { agent: string; text: string; time: number }[] = () => [];

  private printedNow(scene: Scene): readonly Speech[] {
    const now = this.playout.time, lines = this.printedBetween(now - SPEECH_S, now + JUST_NOW_S);
    if (lines.length === 0) return [];
    const ids = new Map([...scene.agents].map(([id, agent]) => [agent.name, id]));
    return lines.map(({ agent, text, time }) => ({ from: ids.get(agent) ?? 0, to: 0, text: text.trim(), time }));
  }

  /** Sets what the selected agent imagines or remembers, until the next call. */
  imagine(ghosts: Ghosts | null): void {
    this.imagined = ghosts;
    this.wake();
  }

  /** Removes all data of the last run. `isSameWorld`: keeps the camera if the user has moved it. */
  forget(isSameWorld = false): void {
    this.scene = null;
    this.imagined = null;
    this.playout.clear();
    this.trails.clear();
    this.things.clear();
    this.bodies.clear();
    this.models.clear();
    this.removeBackdrop();
    this.shapes.clear();
    this.assets.clear();
    this.sounds.clear();
    const keepsCamera = isSameWorld && this.isFramed && !this.rig.keeps;
    if (!keepsCamera) this.rig.forget();
    this.labels.clear();
    this.scriptUi.clear();
    this.renderer.shadowMap.needsUpdate = true;
    this.placed.clear();
    this.isFramed = keepsCamera;
    this.around = null;
    this.recentGround.forget();
    this.selectedId = 0;
    this.wake();
  }

  select(name: string): void {
    this.selectedId = 0;
    for (const [id, agent] of this.scene?.agents ?? []) if (agent.name === name) this.selectedId = id;
    this.selectedName = name;
    this.wake();
  }
  private selectedName = "";

  nameOf(id: number): string {
    return this.scene?.agents.get(id)?.name ?? "";
  }

  frameAll(): void {
    if (this.scene !== null) this.rig.frameAll(this.toShow(this.scene, this.scene, 0));
    this.wake();
  }

  frameSelected(): void {
    const chosen = this.placed.get(this.selectedId);
    if (chosen === undefined) this.frameAll();
    else this.rig.frame([{ place: chosen.place, velocity: NOBODY_MOVES, radius: chosen.agent.radius, height: chosen.agent.height }]);
    this.wake();
  }

  wake(): void {
    this.restless = Math.max(this.restless, 3);
  }

  stop(): void {
    this.stopped = true;
    this.renderer.dispose();
  }

  /** The id of the agent at a position in the picture, in pixels; 0: none. */
  agentAt(x: number, y: number): number {
    const { clientWidth: width, clientHeight: height } = this.canvas, point = new Vector3();
    let best = 0, bestScore = Infinity;
    for (const one of this.placed.values()) {
      const ends = [-0.5, 0.5].map((share) => {
        point.set(one.place[0], one.place[1] + share * one.agent.height, one.place[2]).project(this.rig.camera);
        return { x: ((point.x + 1) / 2) * width, y: ((1 - point.y) / 2) * height, z: point.z };
      });
      const [low, high] = ends as [typeof ends[0], typeof ends[0]];
      if (low.z > 1) continue;
      const size = Math.hypot(high.x - low.x, high.y - low.y), t = Math.min(Math.max(((x - low.x) * (high.x - low.x) + (y - low.y) * (high.y - low.y)) / Math.max(size * size, 1), 0), 1);
      const away = Math.hypot(x - low.x - t * (high.x - low.x), y - low.y - t * (high.y - low.y));
      if (away < Math.max(14, size * 0.35) && away + low.z * 40 < bestScore) {
        best = one.id;
        bestScore = away + low.z * 40;
      }
    }
    return best;
  }

  private frame(now: number): void {
    if (this.stopped) return;
    requestAnimationFrame((next) => this.frame(next));
    if (this.governor.quality.isSlow && now - this.lastFrame < SLOW_EVERY_MS) return;
    const seconds = Math.min((now - this.lastFrame) / 1000, 0.25);
    this.lastFrame = now;
    if (this.canvas.clientWidth === 0) return;
    const moving = this.playout.advance(seconds, this.isPaused);
    const followed = this.placed.get(this.selectedId)?.place ?? null;
    if (this.rig.update(seconds, followed) || (moving !== null && moving.share < 1)) this.wake();
    if (this.restless <= 0) return;
    this.restless -= 1;
    this.fit();
    if (moving !== null) this.show(moving, seconds);
    this.draw();
    this.judge(seconds, now);
  }

  private show(between: Between, seconds: number): void {
    const { after } = between;
    if (this.selectedId === 0 && this.selectedName !== "") this.select(this.selectedName);
    this.place3d(between);
    this.light(after);
    this.things.show(between);
    this.bodies.show(between, this.rig.camera, this.governor.quality.isSlow);
    this.models.show(between, this.rig.camera);
    this.keepInView(between, seconds);
    this.showBackdrop(after);
  }

  /** At first the camera shows all agents, or the script's view. Then it keeps them in the picture until the user moves it. */
  private keepInView({ before, after }: Between, seconds: number): void {
    if (!this.isFramed) {
      if (after.agents.size === 0) return;
      this.isFramed = true;
      this.drawBoxes(after);
      this.rig.begin(after.camera, this.toShow(before, after, seconds));
    } else if (after.camera !== null && !this.isBoard) {
      this.rig.obey(after.camera);
    }
    if (this.rig.keeps) this.rig.keep(this.toShow(before, after, seconds), seconds);
  }

  /** The living agents with their destinations and surroundings; if none is alive, all agents. */
  private toShow(before: Scene, after: Scene, seconds: number): Shown {
    const isFast = this.playout.pace > FAST_PACE, pace = this.isPaused || isFast ? 0 : this.playout.pace, bodies: FramedBody[] = [], all: FramedBody[] = [], span = after.time - before.time;
    for (const [id, agent] of after.agents) {
      if (!agent.place.every(Number.isFinite)) continue;
      const way = minus(agent.place, before.agents.get(id)?.place ?? agent.place);
      const body = { place: this.placed.get(id)?.place ?? agent.place, velocity: span > 0 && length(way) < JUMP_M ? times(way, pace / span) : NOBODY_MOVES, radius: agent.radius, height: agent.height };
      all.push(body);
      if (agent.alive) bodies.push(body);
    }
    const shown = bodies.length > 0 ? bodies : all;
    if (isFast && !this.isPaused) {
      this.recentGround.note(shown, seconds);
      shown.push(...this.recentGround.corners());
    } else {
      this.recentGround.forget();
    }
    const places = after.places.filter((one) => one.kind !== "thing").map((one) => one.place);
    if (this.around === null || this.around.scene !== after.drawables.size || Math.abs(this.around.time - after.time) > SCENERY_EVERY_S)
      this.around = { scene: after.drawables.size, time: after.time, scenery: sceneryAround(after, places), board: this.isBoard ? boardOf(after) : [], hasWalls: hasWalls(after) };
    const { scenery, board } = this.around;
    return { bodies: board.length > 0 ? board : shown, places, scenery, isBoard: board.length > 0, hasWalls: this.around.hasWalls };
  }

  /** Boxes of text that scripts show: agents are kept in the free area. */
  private drawBoxes(scene: Scene): readonly Box[] {
    const { clientWidth: width, clientHeight: height } = this.canvas, boxes = this.scriptUi.draw(scene.components, scene.surroundings?.palette ?? [], this.rig.camera, width, height);
    this.rig.free = freeOf(boxes, width, height);
    return boxes;
  }

  private place3d({ before, after, share }: Between): void {
    this.placed = new Map();
    for (const [id, agent] of after.agents) {
      const old = before.agents.get(id) ?? agent;
      const at = (a: Vec3, b: Vec3): Vec3 => [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share];
      const jumps = Math.hypot(agent.place[0] - old.place[0], agent.place[2] - old.place[2]) > JUMP_M;
      this.placed.set(id, { id, agent, place: jumps ? agent.place : at(old.place, agent.place), forward: agent.forward });
    }
  }

  private light(scene: Scene): void {
    const around = scene.surroundings;
    if (around === null) return;
    this.sky.show(around.sky);
    (this.world.fog as FogExp2).color.copy(this.sky.haze);
    const sun = around.lights.find((light) => light.directional);
    const way = new Vector3(...(sun?.direction ?? [0.4, -0.8, 0.45])).normalize();
    if (way.lengthSq() < 0.5) way.set(0, -1, 0);
    const size = Math.min(Math.max(this.rig.away * 0.9, 14), 120), [x, y, z] = this.rig.target;
    this.sun.target.position.set(x, y, z);
    this.sun.position.set(x - way.x * size * 2, y - way.y * size * 2, z - way.z * size * 2);
    const shadow = this.sun.shadow.camera;
    if (Math.abs(shadow.right - size) > size * 0.15) {
      shadow.left = shadow.bottom = -size;
      shadow.right = shadow.top = size;
      shadow.near = 1;
      shadow.far = size * 4.5;
      shadow.updateProjectionMatrix();
      this.sun.shadow.normalBias = 0.0012 * size;
    }
    const [r, g, b] = sun?.diffuse ?? [0, 0, 0];
    this.sun.color.setRGB(r, g, b);
    this.sun.intensity = sun === undefined ? 0 : 0.95 * LIGHT_SCALE;
    this.sun.castShadow = sun === undefined || sun.castsShadows;
    const [ar, ag, ab] = around.ambient;
    this.ambient.color.setRGB(ar * 0.78, ag * 0.83, ab * 0.9);
    this.ambient.groundColor.setRGB(ar * 0.46, ag * 0.42, ab * 0.37);
    this.ambient.intensity = 1.25 * LIGHT_SCALE;
    this.fill.intensity = 0;
    this.furtherLights(around.lights.filter((light) => !light.directional).slice(0, MOST_POINT_LIGHTS));
  }

  private furtherLights(lights: readonly Light[]): void {
    while (this.pointLights.length < lights.length) {
      const made = new PointLight();
      this.pointLights.push(made);
      this.world.add(made);
    }
    this.pointLights.forEach((shown, i) => {
      const light = lights[i];
      shown.visible = light !== undefined;
      if (light === undefined) return;
      shown.position.set(...light.place);
      shown.color.setRGB(...light.diffuse);
      shown.intensity = LIGHT_SCALE * (light.attenuation[2] > 0 ? Math.min(1 / light.attenuation[2], 60) : 20);
      shown.distance = light.range;
      shown.decay = light.attenuation[2] > 0 ? 2 : 1;
    });
  }

  private showBackdrop(scene: Scene): void {
    const { drawables } = scene, { structure } = drawables;
    if (this.plains.structure !== structure) {
      this.plains = { structure, slots: [] };
      structure.descriptions.forEach((d, slot) => d?.visible === true && d.shape === Shape.Plane && d.size[0] === PLAIN_SIDE_M && d.size[2] === PLAIN_SIDE_M && this.plains.slots.push(slot));
    }
    const hasPlain = this.plains.slots.some((slot) => Math.hypot(...drawables.placeAt(slot)) < 0.5);
    if (hasPlain && this.backdrop.length < BACKDROP.length) {
      this.removeBackdrop();
      for (const key of BACKDROP) {
        const mesh = this.shapes.mesh(key, 1);
        if (mesh !== null) this.backdrop.push(new Mesh(geometryOf(mesh, lookOf(mesh.material)), this.materials.named(mesh.material)));
      }
      if (this.backdrop.length > 0) this.world.add(...this.backdrop);
    }
    for (const mesh of this.backdrop) mesh.visible = hasPlain;
  }

  private removeBackdrop(): void {
    for (const mesh of this.backdrop) mesh.geometry.dispose();
    this.world.remove(...this.backdrop);
    this.backdrop = [];
  }

  private draw(): void {
    const scene = this.scene, size = { width: this.canvas.clientWidth, height: this.canvas.clientHeight };
    this.sky.mesh.position.copy(this.rig.camera.position);
    this.lines.begin();
    let ghosts: BelievedBody[] = [];
    if (scene !== null) {
      ghosts = paintOverlays(this.lines, { scene, time: this.playout.time, placed: this.placed, selected: this.selectedId, on: this.on, trails: this.trails });
      if (this.imagined !== null) ghosts = [...ghosts, ...paintImagined(this.lines, this.imagined)];
      const covered = [...this.covered, ...this.drawBoxes(scene)];
      const dots = this.labels.draw({ scene, time: this.playout.time, placed: this.placed, selected: this.selectedId, on: this.on, ghosts, ...size, camera: this.rig.camera, away: this.rig.away, covered, printed: this.printedNow(scene) });
      this.dots.show(dots, this.renderer.getPixelRatio());
    }
    this.showGhosts(ghosts.filter((one) => one.radius > 0));
    this.lines.end(this.canvas.width, this.canvas.height, this.renderer.getPixelRatio());
    // Also for the last frame before the picture stops changing.
    if (this.restless <= 0 || this.pictures % this.governor.quality.shadowsEvery === 0) this.renderer.shadowMap.needsUpdate = true;
    this.pictures += 1;
    this.tellFramed();
    this.renderer.render(this.world, this.rig.camera);
  }

  private tellFramed(): void {
    const { clientWidth: width, clientHeight: height } = this.canvas, point = new Vector3();
    let outside = 0, living = 0;
    for (const { agent, place } of this.placed.values()) {
      if (!agent.alive) continue;
      living += 1;
      point.set(...place).project(this.rig.camera);
      if (width > 0 && height > 0 && (Math.abs(point.x) > 1 || Math.abs(point.y) > 1 || point.z > 1)) outside += 1;
    }
    this.events.framed(this.rig.keeps, outside, living);
  }

  private showGhosts(ghosts: readonly BelievedBody[]): void {
    while (this.ghosts.length < ghosts.length) {
      const mesh = new Mesh(new CapsuleGeometry(1, 2, 6, 16), new MeshBasicMaterial({ transparent: true, depthWrite: false, fog: false }));
      this.ghosts.push(mesh);
      this.world.add(mesh);
    }
    this.ghosts.forEach((mesh, i) => {
      const ghost = ghosts[i];
      mesh.visible = ghost !== undefined;
      if (ghost === undefined) return;
      mesh.position.set(...ghost.place);
      mesh.scale.set(ghost.radius * 0.7, ghost.height / 4, ghost.radius * 0.7);
      const material = mesh.material as MeshBasicMaterial;
      material.color = new Color().setRGB(...ghost.color);
      material.opacity = 0.35 * ghost.opacity;
    });
  }

  private fit(): void {
    const width = this.place.clientWidth, height = this.place.clientHeight, ratio = Math.min(window.devicePixelRatio, this.governor.quality.ratio);
    const wanted = Math.floor(width * ratio), high = Math.floor(height * ratio);
    if (this.canvas.width === wanted && this.canvas.height === high) return;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.rig.setSize(width, height);
  }

  private judge(seconds: number, now: number): void {
    this.frames += 1;
    if (now - this.framesSince > 1000) {
      this.framesPerSecond = (this.frames * 1000) / (now - this.framesSince);
      this.frames = 0;
      this.framesSince = now;
    }
    if (this.governor.note(seconds)) this.drawAs();
  }

  get isInFullDetail(): boolean {
    return this.isFull;
  }

  /** Antialiasing changes when the page is loaded again. */
  setFullDetail(isFull: boolean): void {
    this.isFull = isFull;
    this.governor = this.newGovernor();
    this.drawAs();
  }

  private newGovernor(): Governor {
    return this.isFull ? new Governor(0, true) : new Governor(this.isProcessor ? FIRST_OF_PROCESSOR : 0);
  }

  /** Sets the level of detail that the governor chose. */
  private drawAs(): void {
    const { shadowSide, isSlow } = this.governor.quality, { shadow } = this.sun;
    if (shadow.mapSize.x !== shadowSide) {
      shadow.mapSize.set(shadowSide, shadowSide);
      shadow.map?.dispose();
      shadow.map = null;
    }
    this.renderer.shadowMap.needsUpdate = true;
    this.wake();
    if (isSlow === this.materials.isSlow) return;
    this.renderer.shadowMap.type = isSlow ? BasicShadowMap : PCFShadowMap;
    this.materials.isSlow = isSlow;
    this.materials.dispose();
    this.things.clear();
    this.bodies.clear();
    this.models.clear();
    this.removeBackdrop();
  }
}

/** Antialiasing only with a graphics card. A context that refuses software rendering shows whether there is one. */
function contextOf(canvas: HTMLCanvasElement): WebGL2RenderingContext {
  const wanted: WebGLContextAttributes = { alpha: false, depth: true, stencil: false, powerPreference: "high-performance" };
  const context = canvas.getContext("webgl2", { ...wanted, antialias: true, failIfMajorPerformanceCaveat: true }) ?? canvas.getContext("webgl2", { ...wanted, antialias: false });
  if (context === null) throw new Error("WebGL is switched off");
  return context;
}

function isDrawnByProcessor(context: WebGL2RenderingContext): boolean {
  const info = context.getExtension("WEBGL_debug_renderer_info");
  return info !== null && /swiftshader|llvmpipe|software/i.test(String(context.getParameter(info.UNMASKED_RENDERER_WEBGL)));
}
