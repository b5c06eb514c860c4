// SPDX-License-Identifier: BSD-2-Clause
import { button, h, patch, type Child } from "../dom/view";
import { startPage } from "../lesson/start_page";
import { Run, type Remark } from "../run/run";
import { SocketSource } from "../run/socket_source";
import type { Api, PlaceInfo } from "./api";
import { clock } from "../panels/parts";
import { keysDialog, linkDialog, type Link } from "./dialogs";
import { icon } from "./icons";
import { isTyping } from "./keys";
import { formatAddress, NOWHERE, packText, type Address } from "./address";
import { Navigator } from "./navigator";
import { Reach } from "./reach";
import { fileName, firstFile } from "../editor/first_file";
import { RunPage } from "./run_page";
import { isDark, switchTheme } from "./theme";

const FETCHED_AFTER_MS = 800;
/** What was opened last in a place. */
const LAST = "soarbox.last.";
const REMARK_MS = 7000, MOST_REMARKS = 4;

/** The page of a place: where one begins, and the run that is open. */
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
  /** What was opened because the address says so; "": nothing since a run was there. */
  private openedByAddress = "";
  /** File and text of the address that are to be shown once the run is there. */
  private given: { file: string; text: string } | null = null;
  private readonly navigator: Navigator;
  private readonly reach: Reach;
  private ticker: ReturnType<typeof setInterval> | null = null;

  constructor(root: HTMLElement, private readonly api: Api, private info: PlaceInfo, private readonly watchKey: string) {
    this.head.className = "head";
    this.body.className = "body";
    this.remarks.className = "remarks";
    this.remarks.setAttribute("role", "status");
    root.replaceChildren(this.head, this.body, this.remarks, this.over);
    // The server knows this tab again when it connects again.
    const tab = [...crypto.getRandomValues(new Uint8Array(8))].map((byte) => byte.toString(16).padStart(2, "0")).join("");
    const path = watchKey === "" ? `/api/p/${info.place}/run?tab=${tab}` : `/api/p/${info.place}/watch?key=${encodeURIComponent(watchKey)}`;
    this.run = new Run(new SocketSource(api.socketAddress(path), api.secret), watchKey === "" ? info.place : "");
    this.navigator = new Navigator(watchKey !== "", (address) => this.goTo(address));
    this.reach = new Reach(this.run);
    this.isHome = this.navigator.address.what === "";
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
      this.noteWhere();
    });
    document.addEventListener("keydown", (event) => this.key(event));
    addEventListener("soarbox-theme", () => this.draw());
    this.draw();
    this.run.start();
    // What a run needs is fetched while one still chooses.
    setTimeout(() => {
      void import("../scene/scene_view");
      void import("../editor/editor");
    }, FETCHED_AFTER_MS);
  }

  private open(what: string): void {
    this.isHome = false;
    this.navigator.go(what);
    this.reach.forget();
    this.run.open(what);
    this.draw();
  }

  /** Back, Forward, or an address that was typed. */
  private goTo(address: Address): void {
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
    if (this.watchKey === "" && address.what !== "" && address.what !== what && this.openedByAddress !== address.what) {
      // Another run was left here.
      this.openedByAddress = address.what;
      this.run.open(address.what);
      return;
    }
    this.openedByAddress = "";
    if (this.watchKey === "") localStorage.setItem(LAST + this.info.place, what);
    if (address.what === what) {
      this.isHome = false;
      if (address.seconds !== null) this.reach.start(address.seconds);
    } else if (!this.navigator.isHome || this.watchKey !== "") {
      this.isHome = false;
      this.navigator.stay(what);
    }
    this.draw();
  }

  /** There is no run: what the address names is opened; what cannot be opened leads to lessons and worlds. */
  private nothingRuns(): void {
    const { what } = this.navigator.address;
    if (this.watchKey === "" && what !== "" && this.openedByAddress !== what) {
      this.openedByAddress = what;
      this.isHome = false;
      this.run.open(what);
      return;
    }
    this.isHome = true;
    this.navigator.stay("");
    const { opens } = this.info;
    if (opens === "" || this.openedGiven || this.watchKey !== "") return;
    this.openedGiven = true;
    this.open(opens.includes(":") ? opens : `scenario:${opens}`);
  }

  /** The address follows what is shown: the moment, and the file. */
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
    if (moment !== undefined && !this.reach.isUnderWay) this.navigator.note({ seconds: moment.time.is_live ? null : moment.time.shown_tick * moment.time.step_s });
  }

  private noteLessons(): void {
    const told = this.run.contents.mission?.lessons ?? [];
    const passed = new Map(told.map((one) => [one.name, one.is_passed]));
    this.info = { ...this.info, lessons: this.info.lessons.map((one) => ({ ...one, is_passed: passed.get(one.name) ?? one.is_passed })) };
  }

  private goHome(): void {
    this.isHome = true;
    this.navigator.go("");
    this.reach.forget();
    this.draw();
    this.fetchInfo();
  }

  private fetchInfo(): void {
    void this.api.json<PlaceInfo>(`/api/p/${this.info.place}`).then((info) => {
      this.info = info;
      this.draw();
    }, (error: unknown) => this.fail(error));
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
    patch(this.remarks, this.shown.map(({ remark, id }) => h(`div.remark${remark.isError ? ".error" : ""}`, { key: String(id) }, h("div", null, h("p", null, remark.text), remark.hint !== "" && h("p.hint", null, remark.hint)),
      button(icon("cross"), () => this.unsay(id), { attributes: { "aria-label": "Close this remark" } }, "button.tool"))));
  }

  private draw(): void {
    const { hello } = this.run, title = this.titleOfRun();
    document.title = this.isHome || title === "" ? "Soarbox" : `${title} - Soarbox`;
    patch(this.head, [
      button([icon("home"), h("span.brand", null, "Soarbox")], () => this.goHome(), { attributes: { title: "Lessons and worlds", "aria-label": "Soarbox: lessons and worlds" } }, "button.home"),
      !this.isHome && title !== "" && h("h1.run-title", null, title), hello !== null && !this.isHome && hello.seed > 0 && h("span.quiet.seed", null, `seed ${hello.seed}`),
      this.watchKey !== "" && h("span.pill", null, "You watch; only the learner can change anything"), hello?.is_recording === true && !this.isHome && h("span.pill", null, "Recording"),
      this.run.state === "busy" && h("span.pill.busy", { attributes: { role: "status" } }, "Working …"),
      h("span.space"), this.connectionView(),
      button(icon("link"), () => this.showDialog("link"), { attributes: { title: "Links to share", "aria-label": "Links to share" } }, "button.tool"),
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
    this.runPage ??= hello === null ? null : new RunPage(this.run, (what) => this.open(what), false, () => this.goHome());
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
    if (this.watchKey !== "") return h("main.start", null, h("div.empty", null, h("p", null, "The learner has no world open now. It is shown here as soon as there is one.")));
    const { hello } = this.run, running = hello !== null && this.run.state !== "ended" ? { what: hello.what, title: this.titleOfRun() } : null;
    const folder = `/api/p/${this.info.place}`;
    return startPage(this.info, this.filter, running, localStorage.getItem(LAST + this.info.place) ?? "", {
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

  private ended(): Child {
    const what = this.run.hello?.what ?? "";
    return h("div.over-run", { attributes: { role: "alert" } }, h("h2", null, "This run has ended"), h("p", null, this.run.endedText),
      h("div.row", null, this.run.canOpenAgain && what !== "" && this.watchKey === "" && button("Open it again", () => this.open(what), {}, "button.primary"), button("Lessons and worlds", () => this.goHome())));
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

  /** What can be given to somebody else: what is shown, for a place of their own; a copy of the rules; the whole place. */
  private async makeLinks(): Promise<void> {
    const { address } = this.navigator, { hello } = this.run, title = this.titleOfRun(), edit = this.run.contents.edit?.edit, links: Link[] = [], isShown = !this.isHome && hello !== null && hello.what === address.what;
    if (isShown && !hello.what.startsWith("recording:")) {
      const when = address.seconds === null ? "" : ` at ${clock(address.seconds)}`;
      links.push({ title: `${title}${when}`, about: "Opens it for anybody in a place of their own. Nobody sees or changes your place.", address: location.origin + "/" + formatAddress({ ...address, text: "" }) });
      if (edit !== undefined && edit.file !== "") {
        const text = await packText(this.runPage?.editorText ?? edit.text);
        links.push({ title: `A copy of your ${fileName(edit.file)}`, about: "The same, with your text in the editor: others can try it and change their copy.", address: location.origin + "/" + formatAddress({ ...NOWHERE, what: hello.what, file: fileName(edit.file), text }) });
      }
    }
    links.push({ title: "Your whole place", about: "Keep this link: it leads to your files, lessons and recordings, on any machine. Whoever has it can change everything here, as you can.", address: `${location.origin}/p/${this.info.place}/${isShown ? formatAddress({ ...address, text: "" }) : ""}`, isPlace: true });
    this.links = links;
    this.draw();
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
