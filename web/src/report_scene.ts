// SPDX-License-Identifier: BSD-2-Clause
// The run in 3D on the page of `soarbox report`: the same picture and panels as in a browser, for a recorded run that
// the page contains.
import { keepInPage } from "./report/storage";
import { RunPage } from "./app/run_page";
import { applyTheme, themeNow } from "./app/theme";
import { SceneTime } from "./report/scene_time";
import { FileSource, type RecordedRun } from "./run/file_source";
import { Run } from "./run/run";

keepInPage();
applyTheme(themeNow());
const recorded = JSON.parse(document.getElementById("recorded")?.textContent ?? "null") as RecordedRun | null;
if (recorded !== null) {
  const run = new Run(new FileSource(recorded)), page = new RunPage(run, () => undefined, true), element = document.createElement("section");
  element.className = "scene";
  element.setAttribute("aria-label", "The run in 3D");
  element.append(page.element);
  globalThis.soarboxScene = { element, time: new SceneTime(run, recorded) };
  // Its keys work while the scene is visible, unless the focus is in the sections below.
  document.addEventListener("keydown", (event) => {
    const target = event.target as Element | null, isFree = target === document.body && element.getBoundingClientRect().bottom > innerHeight / 2;
    if (!event.defaultPrevented && (isFree || element.contains(target)) && page.key(event)) event.preventDefault();
  });
  // At this event the page has already inserted the element.
  document.addEventListener("DOMContentLoaded", () => run.start());
}
