// SPDX-License-Identifier: BSD-2-Clause
import { button, h, patch, type Child } from "../dom/view";
import { learnersArena } from "../class/arena_view";
import { LearnerDesk } from "../class/learner_desk";
import { startPage } from "../lesson/start_page";
import type { WorldMaps } from "../lesson/world_map";
import { Run, type Remark } from "../run/run";
import type { Api, ArenaInfo, PlaceInfo } from "./api";
import type { PlaceFiles } from "../panels/panel";
import { clock } from "../panels/parts";
import { keysDialog, linkDialog, type Link } from "./dialogs";
import { icon } from "./icons";
import { isTyping } from "./keys";
import { folderPill, folderSection } from "./folder_views";
import { formatAddress, NOWHERE, packFiles, packText, type Address, type ChangedFiles } from "./address";
import { Navigator } from "./navigator";
import { Reach } from "./reach";
import { fileName, firstFile } from "../editor/first_file";
import { RunPage } from "./run_page";
import { isDark, switchTheme } from "./theme";

const FETCHED_AFTER_MS = 800;
/** The folder in which a run finds the files of its place. */
const HOME = "/place/home/";
/** Key prefix in the browser's storage: the lesson or world that was last opened in a place. */
const LAST = "soarbox.last.";
const REMARK_MS = 7000, MOST_REMARKS = 4;

/** The name of a world that runs; "": it is something else. */
const worldOf = (what: string): string => /^scenario:(.*)$/.exec(what)?.[1] ?? "";

/** The mode of a page that is not the place's own. */
export interface Guest {
  /** The teacher watches, with the key of the class. */
  key?: string;
  /** A person watches with a shared link. */
  link?: string;
  /** The page is a frame in a page of another site, with these panels. */
  panels?: readonly string[];
  /** The page shows the experiment of a link in a temporary place. `packed`: the files of the link. */
  experiment?: { readonly packed: string; readonly names: readonly string[] };
}

/** The page of a place: the start page, and the open run. */
export class App {
  private readonly head = document.createElement("header");
  private readonly body = document.createElement("div");
  private readonly over = document.createElement("div");
  private readonly remarks = document.createElement("div");
  private readonly run: Run;
  private runPage: RunPage | null = null;
  private isHome = true;
  private dialog: "" | "keys" | "link" = "";
  private copied = "";
  private links: readonly Link[] = [];
  private filter = "";
  private shown: { remark: Remark; id: number }[] = [];
  private nextRemark = 1;
  private openedGiven = false;
  /** Of an experiment: the restart with the link's seed was requested; it has not begun yet; *Why* was requested. */
  private isSeeded = false;
  private isSeeding = false;
  private isAsked = false;
  /** The run that was requested because the address names it; "" after that run has begun. */
  private openedByAddress = "";
  /** File and text from the address, shown as soon as there is a run. */
  private given: { file: string; text: string } | null = null;
  private readonly navigator: Navigator;
  private readonly reach: Reach;
  private ticker: ReturnType<typeof setInterval> | null = null;

  private maps: WorldMaps = {};
  private arena: ArenaInfo | null = null;
  private readonly desk: LearnerDesk | null;
  /** A teacher's message to the watched learner, while it is written. */
  private message = "";

  constructor(root: HTMLElement, private readonly api: Api, private info: PlaceInfo, private readonly guest: Guest = {}) {
    this.head.className = "head";
    this.body.className = "body";
    this.remarks.className = "remarks";
    this.remarks.setAttribute("role", "status");
    root.replaceChildren(this.head, this.body, this.remarks, this.over);
    // The server knows this tab again when it connects again.
    const tab = [...crypto.getRandomValues(new Uint8Array(8))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
    const { key, link } = guest, path = key !== undefined ? `/api/p/${info.place}/watch?key=${encodeURIComponent(key)}` : link !== undefined ? `/api/w/${link}/watch` : `/api/p/${info.place}/run?tab=${tab}`;
    root.classList.toggle("embedded", guest.panels !== undefined);
    this.run = new Run(api.source(path), this.watches || guest.experiment !== undefined ? "" : info.place);
    this.desk = this.watches || info.learner === "" ? null : new LearnerDesk(api, `/api/p/${info.place}`, this.run, () => {
      this.draw();
      this.drawRemarks();
    }, (error) => this.fail(error), (file, line) => {
      this.isHome = false;
      this.draw();
      this.runPage?.showLine(file, line);
    });
    this.navigator = new Navigator(this.watches, (address) => this.goTo(address));
    this.reach = new Reach(this.run);
    this.isHome = this.navigator.address.what === "";
    const { experiment } = this.guest, brought = experiment === undefined || experiment.names.length === 0 ? "" : `, with ${experiment.names.join(", ")}`;
    if (experiment !== undefined) this.say({ text: `The link brought this experiment${brought}. Your own files are as they were.`, hint: "What you change here is gone when you leave it. To pass it on with your changes, use the button Links to share.", isError: false });
    else if (this.navigator.address.rules !== "") this.say({ text: "The rules of this link are not shown here: it is from a site without a server.", hint: "Open it at the address that it was made for.", isError: true });
    this.takeGiven(this.navigator.address);
    this.run.on("hello", ({ what }) => this.begun(what));
    this.run.on("state", (state) => {
      if (state === "none") this.nothingRuns();
      this.draw();
    });
    this.run.on("remark", (remark) => this.say(remark));
    this.run.on("connection", () => this.draw());
    this.run.on("contents", (names) => {
      if (names.includes("mission")) this.noteLessons();
      if (names.includes("edit") && this.watches) this.draw();
      this.noteWhere();
    });
    void api.folders?.start({ changed: () => this.draw(), say: (text, hint, isError) => this.say({ text, hint, isError }) });
    document.addEventListener("keydown", (event) => this.key(event));
    addEventListener("soarbox-theme", () => this.draw());
    this.draw();
    this.run.start();
    if (this.isHome) this.fetchArena();
    void import("../lesson/maps.json").then(({ default: maps }) => {
      this.maps = maps;
      this.draw();
    });
    // Fetches what a run needs while the user still chooses.
    setTimeout(() => {
      void import("../scene/scene_view");
      void import("../editor/editor");
    }, FETCHED_AFTER_MS);
  }

  /** Whether this page only watches a run and cannot change it. */
  private get watches(): boolean {
    return this.guest.key !== undefined || this.guest.link !== undefined;
  }

  private open(what: string): void {
    // Everything else is opened in the user's own place.
    if (this.guest.experiment !== undefined && what !== this.navigator.address.what) return location.assign(this.api.pageAddress + formatAddress({ ...NOWHERE, what }));
    this.isHome = false;
    this.navigator.go(what);
    this.reach.forget();
    this.run.open(what);
    this.draw();
  }

  /** Back, Forward, or an address that was typed. */
  private goTo(address: Address): void {
    // An experiment has a place of its own.
    if (!this.api.hasServer && address.rules !== (this.guest.experiment?.packed ?? "")) return location.reload();
    this.takeGiven(address);
    this.isHome = address.what === "";
    if (this.isHome) this.fetchInfo();
    else if (this.run.hello?.what !== address.what || this.run.state === "ended") this.run.open(address.what);
    else this.show(address);
    this.draw();
  }

  private takeGiven({ file, text }: Address): void {
    this.given = file !== "" || text !== "" ? { file, text } : null;
  }

  /** The moment and the file of an address. */
  private show({ seconds }: Address): void {
    if (seconds !== null) this.reach.start(seconds);
    else if (this.run.contents.moment?.time.is_live === false) this.run.ask("live");
    this.noteWhere();
  }

  private begun(what: string): void {
    const { address } = this.navigator;
    if (!this.watches && address.what !== "" && address.what !== what && this.openedByAddress !== address.what) {
      // The place still has another run: open the run that the address names.
      this.openedByAddress = address.what;
      this.run.open(address.what);
      return;
    }
    this.openedByAddress = "";
    const isExperiment = this.guest.experiment !== undefined;
    if (isExperiment && address.seed !== null && this.run.hello?.seed !== address.seed && !this.isSeeded) {
      this.isSeeded = this.isSeeding = true;
      this.run.ask("flow", { what: "begin-again", seed: address.seed });
      return;
    }
    this.isSeeding = false;
    this.api.folders?.show(worldOf(what));
    if (!this.watches && !isExperiment) localStorage.setItem(LAST + this.info.place, what);
    if (address.what === what) {
      this.isHome = false;
      if (address.seconds !== null) this.reach.start(address.seconds, isExperiment && address.agent !== "" && !this.isAsked ? () => this.runPage?.askWhy(address.agent) : null);
      this.isAsked = true;
    } else if (!this.navigator.isHome || this.watches) {
      this.isHome = false;
      this.navigator.stay(what);
    }
    this.draw();
  }

  /** There is no run: opens what the address names. If that is impossible, shows lessons and worlds. */
  private nothingRuns(): void {
    const { what } = this.navigator.address;
    if (!this.watches && what !== "" && this.openedByAddress !== what) {
      this.openedByAddress = what;
      this.isHome = false;
      this.run.open(what);
      return;
    }
    this.isHome = true;
    this.navigator.stay("");
    const { opens } = this.info;
    if (opens === "" || this.openedGiven || this.watches) return;
    this.openedGiven = true;
    this.open(opens.includes(":") ? opens : `scenario:${opens}`);
  }

  /** Updates the address with the moment and the file that are shown. */
  private noteWhere(): void {
    const { moment, edit } = this.run.contents, { hello } = this.run;
    if (hello === null || hello.what !== this.navigator.address.what) return;
    if (this.given !== null && edit !== undefined && edit.files.length > 0 && this.runPage !== null) {
      const { file, text } = this.given;
      this.given = null;
      this.runPage.showFile(file === "" ? fileName(firstFile(this.run.contents)) : file, text);
      this.navigator.note({ text: "" });
    } else if (edit !== undefined && edit.edit.file !== "" && this.given === null) {
      this.navigator.note({ file: edit.edit.file === firstFile(this.run.contents) ? "" : fileName(edit.edit.file) });
    }
    if (moment !== undefined && !this.reach.isUnderWay && !this.isSeeding) this.navigator.note({ seconds: moment.time.is_live ? null : moment.time.shown_tick * moment.time.step_s });
  }

  private noteLessons(): void {
    const told = this.run.contents.mission?.lessons ?? [];
    const passed = new Map(told.map((one) => [one.name, one.is_passed]));
    this.info = { ...this.info, lessons: this.info.lessons.map((one) => ({ ...one, is_passed: passed.get(one.name) ?? one.is_passed })) };
  }

  private goHome(): void {
    if (this.guest.experiment !== undefined) return location.assign(this.api.pageAddress);
    this.isHome = true;
    this.navigator.go("");
    this.reach.forget();
    this.draw();
    this.fetchInfo();
  }

  private fetchInfo(): void {
    if (this.watches) return;
    void this.api.json<PlaceInfo>(`/api/p/${this.info.place}`).then((info) => {
      this.info = info;
      this.draw();
    }, (error: unknown) => this.fail(error));
    this.fetchArena();
  }

  /** Learners of a class see the arena. It is requested again while a tournament is played. */
  private fetchArena(): void {
    if (this.desk === null) return;
    const PLAYS_AGAIN_MS = 3000;
    void this.api.json<ArenaInfo>(`/api/p/${this.info.place}/arena`).then((arena) => {
      this.arena = arena;
      this.draw();
      if (this.isHome && arena.games.some((one) => one.tournament?.is_playing === true)) setTimeout(() => this.fetchArena(), PLAYS_AGAIN_MS);
    }, (error: unknown) => this.fail(error));
  }

  /** Files of the place, by the names that the run gives them. */
  private files(): PlaceFiles {
    const path = (file: string): string => {
      if (!file.startsWith(HOME)) throw new Error(`${fileName(file)} is not a file of your place.`);
      return `/api/p/${this.info.place}/files/${file.slice(HOME.length).split("/").map(encodeURIComponent).join("/")}`;
    };
    return {
      read: async (file) => (await this.api.fetch(path(file))).text(),
      write: async (file, text) => void (await this.api.fetch(path(file), { method: "PUT", body: text })),
    };
  }

  private handIn(game: string, file: string): void {
    void this.api.json<ArenaInfo>(`/api/p/${this.info.place}/arena/${game}`, { method: "POST", body: JSON.stringify({ file }) }).then((arena) => {
      this.arena = arena;
      this.say({ text: `${fileName(file)} is handed in.`, hint: "You can hand in again until the tournament is played.", isError: false });
      this.draw();
    }, (error: unknown) => this.fail(error));
  }

  /** Sends the teacher's message to the watched learner, optionally about the line of the caret. */
  private sendMessage(isAboutLine: boolean): void {
    const where = isAboutLine ? (this.runPage?.editorPlace ?? null) : null;
    void this.api.json<unknown>(`/api/class/${encodeURIComponent(this.guest.key ?? "")}/message`, { method: "POST", body: JSON.stringify({ to: this.info.place, text: this.message, ...(where ?? {}) }) }).then(() => {
      this.say({ text: where === null ? `Sent to ${this.info.learner}.` : `Sent to ${this.info.learner}, about line ${where.line} of ${where.file}.`, hint: "", isError: false });
      this.message = "";
      this.draw();
    }, (error: unknown) => this.fail(error));
  }

  /** The bar of a watched run: the learner's name, and buttons. */
  private watchBar(): Child {
    const { learner } = this.info, who = learner === "" ? "somebody's run" : `${learner}'s place`, unsaved = this.run.contents.edit?.edit.is_unsaved === true;
    const pill = h("span.pill", { key: "watch" }, `You watch ${who}; you cannot change anything`), typed = unsaved && h("span.pill", { key: "typed" }, "The text is not applied yet");
    if (this.guest.key === undefined || learner === "") return [pill, typed];
    return [pill, typed, h("form.row.write", { key: "write", on: { submit: (event) => {
      event.preventDefault();
      this.sendMessage((event as SubmitEvent).submitter?.dataset["about"] === "line");
    } } }, h("input", { value: this.message, attributes: { type: "text", maxlength: 500, placeholder: `Write to ${learner}`, "aria-label": `Message to ${learner}`, autocomplete: "off" }, on: { input: (event) => (this.message = (event.target as HTMLInputElement).value) } }),
    h("button", { attributes: { type: "submit" } }, "Send"), h("button", { attributes: { type: "submit", "data-about": "line", title: "The message contains a link to the line of the caret" } }, "Send about this line"))];
  }

  private say(remark: Remark): void {
    const id = this.nextRemark++;
    this.shown = [...this.shown.filter((one) => one.remark.text !== remark.text), { remark, id }].slice(-MOST_REMARKS);
    setTimeout(() => this.unsay(id), REMARK_MS);
    this.drawRemarks();
  }

  private unsay(id: number): void {
    this.shown = this.shown.filter((one) => one.id !== id);
    this.drawRemarks();
  }

  private fail(error: unknown): void {
    const told = error as { message?: string; hint?: string };
    this.say({ text: told.message ?? String(error), hint: told.hint ?? "", isError: true });
  }

  private drawRemarks(): void {
    patch(this.remarks, [this.desk !== null && this.desk.notesView(), this.shown.map(({ remark, id }) => h(`div.remark${remark.isError ? ".error" : ""}`, { key: String(id) }, h("div", null, h("p", null, remark.text), remark.hint !== "" && h("p.hint", null, remark.hint)),
      button(icon("cross"), () => this.unsay(id), { attributes: { "aria-label": "Close this remark" } }, "button.tool")))]);
  }

  private draw(): void {
    const { hello } = this.run, title = this.titleOfRun();
    document.title = this.isHome || title === "" ? "Soarbox" : `${title} - Soarbox`;
    patch(this.head, [
      button([icon("home"), h("span.brand", null, "Soarbox")], () => this.goHome(), { attributes: { title: "Lessons and worlds", "aria-label": "Soarbox: lessons and worlds" } }, "button.home"),
      !this.isHome && title !== "" && h("h1.run-title", null, title), hello !== null && !this.isHome && hello.seed > 0 && h("span.quiet.seed", null, `seed ${hello.seed}`),
      this.guest.experiment !== undefined && h("span.pill", { attributes: { title: "It is in a place of its own, which is not kept" } }, "An experiment from a link"),
      this.watches && this.watchBar(), hello?.is_recording === true && !this.isHome && h("span.pill", null, "Recording"),
      this.api.folders !== null && !this.isHome && hello !== null && folderPill(this.api.folders, worldOf(hello.what), () => void this.api.folders?.connect(worldOf(hello.what), true)),
      this.run.state === "busy" && h("span.pill.busy", { attributes: { role: "status" } }, "Working …"),
      h("span.space"), this.connectionView(),
      this.desk !== null && this.desk.handButton(),
      this.guest.panels !== undefined && hello !== null && h("a", { attributes: { href: `/${formatAddress({ ...NOWHERE, what: hello.what })}`, target: "_blank", rel: "noopener" } }, "Open in Soarbox"),
      !this.watches && button(icon("link"), () => this.showDialog("link"), { attributes: { title: "Links to share", "aria-label": "Links to share" } }, "button.tool"),
      button(icon("sun"), switchTheme, { attributes: { title: isDark() ? "Light colours" : "Dark colours", "aria-label": isDark() ? "Light colours" : "Dark colours" } }, "button.tool"),
      button(icon("keys"), () => this.showDialog("keys"), { attributes: { title: "Keys (?)", "aria-label": "Keys" } }, "button.tool"),
    ]);
    this.drawBody();
    patch(this.over, [
      this.dialog === "keys" && keysDialog(() => this.showDialog("")),
      this.dialog === "link" && linkDialog(this.links, this.api.hasToken, this.copied, (address) => void this.copyLink(address), () => this.showDialog("")),
    ]);
  }

  private titleOfRun(): string {
    const { hello } = this.run;
    if (hello === null) return "";
    if (hello.what.startsWith("match:")) return `${hello.agents.join(" against ")}, seed ${hello.seed}`;
    const name = hello.what.replace(/^\w+:/, "");
    return hello.title || (this.info.lessons.find((one) => hello.what === `lesson:${one.name}`)?.title ?? name);
  }

  private connectionView(): Child {
    const { connection, retryAt } = this.run;
    if (connection === "lost" && this.ticker === null) this.ticker = setInterval(() => this.draw(), 1000);
    if (connection !== "lost" && this.ticker !== null) {
      clearInterval(this.ticker);
      this.ticker = null;
    }
    if (connection === "lost") {
      const seconds = Math.max(0, Math.ceil((retryAt - Date.now()) / 1000));
      return h("span.pill.lost", { attributes: { role: "status" } }, `Connection lost. Next try in ${seconds} s. `, button("Try now", () => this.run.retry(), {}, "button.link"));
    }
    if (this.run.state === "joining" && this.run.hello !== null) return h("span.pill", { attributes: { role: "status" } }, "The world is made …");
    return connection === "connecting" && h("span.pill", { attributes: { role: "status" } }, "Connecting …");
  }

  private drawBody(): void {
    const { state, hello } = this.run;
    this.runPage ??= hello === null ? null : new RunPage(this.run, (what) => this.open(what), false, this.guest.panels ?? null, this.watches ? null : this.files());
    const shows = this.isHome ? "start" : state === "joining" && hello === null ? "waiting" : "run";
    this.body.dataset["shows"] = shows;
    let start = this.body.querySelector<HTMLElement>(":scope > .start-place");
    if (start === null) {
      start = document.createElement("div");
      start.className = "start-place";
      this.body.append(start);
    }
    if (this.runPage !== null && this.runPage.element.parentElement === null) this.body.append(this.runPage.element);
    if (this.runPage !== null) this.runPage.element.hidden = shows !== "run";
    start.hidden = shows === "run" && state !== "ended";
    start.classList.toggle("ended", shows === "run" && state === "ended");
    if (shows === "start") patch(start, [this.start()]);
    else if (shows === "waiting") patch(start, [h("div.waiting", { attributes: { role: "status" } }, h("p", null, "The world is made …"))]);
    else if (state === "ended") patch(start, [this.ended()]);
  }

  private start(): Child {
    if (this.watches) return h("main.start", null, h("div.empty", null, h("p", null, `${this.info.learner === "" ? "The person" : this.info.learner} has no world open now. It is shown here as soon as there is one.`)));
    const { hello } = this.run, running = hello !== null && this.run.state !== "ended" ? { what: hello.what, title: this.titleOfRun() } : null;
    const folder = `/api/p/${this.info.place}`;
    return startPage(this.info, this.filter, running, localStorage.getItem(LAST + this.info.place) ?? "", this.maps, this.arena !== null && learnersArena(this.arena, this.info.files, (game, file) => this.handIn(game, file), { replay: (match) => this.open(`match:${match}`) }), this.folders(), {
      open: (what) => this.open(what),
      goOn: () => {
        this.isHome = false;
        this.navigator.go(running?.what ?? "");
        this.draw();
      },
      download: () => void this.api.download(`${folder}/zip`, "soarbox.zip").catch((error: unknown) => this.fail(error)),
      upload: (file) => void this.api.fetch(`${folder}/zip`, { method: "POST", body: file, headers: { "Content-Type": "application/zip" } }).then(() => {
        this.say({ text: `${file.name} is in your place now.`, hint: "", isError: false });
        this.goHome();
      }, (error: unknown) => this.fail(error)),
      downloadRecording: (name) => void this.api.download(`${folder}/recordings/${encodeURIComponent(name)}`, name).catch((error: unknown) => this.fail(error)),
    }, (text) => {
      this.filter = text;
      this.draw();
    });
  }

  private folders(): Child {
    const { folders } = this.api;
    if (folders === null) return null;
    // Names of worlds, which folders may not have: the program's, and those in the place.
    const taken = [...this.info.scenarios.map((one) => one.name), ...this.info.files.map((one) => /^worlds\/([^/]+)\//.exec(one.path)?.[1] ?? "")];
    return folderSection(folders, {
      choose: () => void folders.choose(taken).then((world) => world !== null && this.open(`scenario:${world}`)),
      open: (world) => void folders.connect(world, true).then((isGood) => isGood && this.open(`scenario:${world}`)),
      forget: (world) => void folders.forget(world).then(() => this.fetchInfo(), (error: unknown) => this.fail(error)),
    });
  }

  private ended(): Child {
    const what = this.run.hello?.what ?? "";
    return h("div.over-run", { attributes: { role: "alert" } }, h("h2", null, "This run has ended"), h("p", null, this.run.endedText),
      h("div.row", null, this.run.canOpenAgain && what !== "" && !this.watches && button("Open it again", () => this.open(what), {}, "button.primary"), button("Lessons and worlds", () => this.goHome())));
  }

  private showDialog(which: "" | "keys" | "link"): void {
    this.dialog = this.dialog === which ? "" : which;
    this.copied = "";
    if (this.dialog === "link") {
      this.links = [];
      void this.makeLinks();
    }
    this.draw();
  }

  /** Creates the links to share: the current view, for another place; a copy of the rules; the entire place. */
  private async makeLinks(): Promise<void> {
    const { address } = this.navigator, { hello } = this.run, title = this.titleOfRun(), edit = this.run.contents.edit?.edit, links: Link[] = [], isShown = !this.isHome && hello !== null && hello.what === address.what;
    if (isShown && !hello.what.startsWith("recording:")) {
      const when = address.seconds === null ? "" : ` at ${clock(address.seconds)}`;
      links.push({ title: `${title}${when}`, about: "Opens it for anybody in a place of their own. Nobody sees or changes your place.", address: this.api.pageAddress + formatAddress({ ...address, text: "", rules: "", seed: null, agent: "" }) });
      const changed = await this.api.changedFiles(hello.what);
      if (changed !== null) links.push(await this.experimentLink(changed));
      if (edit !== undefined && edit.file !== "" && this.api.hasServer) {
        const text = await packText(this.runPage?.editorText ?? edit.text);
        links.push({ title: `A copy of your ${fileName(edit.file)}`, about: "The same, with your text in the editor: others can try it and change their copy.", address: this.api.pageAddress + formatAddress({ ...NOWHERE, what: hello.what, file: fileName(edit.file), text }) });
      }
    }
    if (isShown && this.guest.panels === undefined && this.api.hasServer) {
      try {
        links.push(await this.watchLink());
      } catch (error) {
        this.fail(error);
      }
    }
    if (this.api.hasServer) links.push({ title: "Your whole place", about: "Keep this link: it leads to your files, lessons and recordings, on any machine. Everybody who has it can change everything here, as you can.", address: `${location.origin}/p/${this.info.place}/${isShown ? formatAddress({ ...address, text: "" }) : ""}`, isPlace: true });
    this.links = links;
    this.draw();
  }

  /** A link that contains the user's files and the moment that is shown. */
  private async experimentLink(changed: ChangedFiles): Promise<Link> {
    const { hello, contents, flow } = this.run, { moment, edit } = contents, file = edit?.edit.file ?? "", text = this.runPage?.editorText ?? null;
    const files = { ...changed.files };
    if (text !== null && edit?.edit.text !== text && file.startsWith(changed.folder)) files[file.slice(changed.folder.length)] = text;
    // Messages about the flow arrive more often than contents.
    const tick = moment?.time.is_live === false ? moment.time.shown_tick : Math.max(moment?.time.last_tick ?? 0, flow.tick), seconds = tick * (hello?.step_s ?? 0), names = Object.keys(files);
    const address = this.api.pageAddress + formatAddress({ ...NOWHERE, what: hello?.what ?? "", seconds, seed: hello?.seed ?? null, agent: moment?.agent ?? "", rules: await packFiles(files) });
    const withFiles = names.length === 0 ? "You have changed no files." : `With your ${names.join(", ")}.`;
    return { title: "This experiment", address, about: [`${withFiles} Opens this moment, paused, and says why ${moment?.agent || "an agent"} does what it does. The world begins with these files and this seed.`,
      changed.leftOut.length > 0 && `It leaves out ${changed.leftOut.join(", ")}: only texts fit into a link.`,
      this.runPage?.isPieced === true && "Rules changed while the world ran, or you went on from an earlier moment: the link may show another run."].filter(Boolean).join(" ") };
  }

  /** The link with which others can watch this run. */
  private async watchLink(): Promise<Link> {
    const title = "Watch what I do, live", path = `/api/p/${this.info.place}/watch`, ask = (method: string) => (): void => {
      void this.api.json<unknown>(path, { method }).then(() => this.makeLinks(), (error: unknown) => this.fail(error));
    };
    const { link } = await this.api.json<{ link: string }>(path);
    if (link === "") return { title, about: "Shows others what runs here, whatever you open, until you withdraw the link. They change nothing and do not learn the link of your place.", address: "", make: ask("POST") };
    return { title, about: "Everybody with this link sees what runs here, whatever you open, and cannot change anything. Once you withdraw it, it opens nothing; people who are already watching see the run until they load the page again.", address: location.origin + link, withdraw: ask("DELETE") };
  }

  private async copyLink(address: string): Promise<void> {
    try {
      await navigator.clipboard.writeText(address);
      this.copied = "Copied.";
    } catch {
      this.copied = "This browser does not let the page copy: mark the link and copy it.";
    }
    this.draw();
  }

  private key(event: KeyboardEvent): void {
    if (event.defaultPrevented) return;
    if (event.key === "Escape" && this.dialog !== "") this.showDialog("");
    else if (event.key === "?" && !isTyping(event.target)) this.showDialog("keys");
    else if (this.dialog !== "" || this.isHome || this.runPage?.key(event) !== true) return;
    event.preventDefault();
  }
}
