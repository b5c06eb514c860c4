// SPDX-License-Identifier: BSD-2-Clause
// The page of `soarbox report`: a recorded run that lies in it, with its picture and panels.
import { RunPage } from "./app/run_page";
import { applyTheme, themeNow } from "./app/theme";
import { FileSource, type RecordedRun } from "./run/file_source";
import { Run } from "./run/run";

const data = document.getElementById("data")?.textContent ?? "null", root = document.getElementById("page");
if (root !== null) {
  applyTheme(themeNow());
  const run = new Run(new FileSource(JSON.parse(data) as RecordedRun));
  const page = new RunPage(run, () => undefined, true), body = document.createElement("div");
  body.className = "body";
  body.dataset["shows"] = "run";
  body.append(page.element);
  root.replaceChildren(body);
  document.addEventListener("keydown", (event) => {
    if (!event.defaultPrevented && page.key(event)) event.preventDefault();
  });
  run.start();
}
