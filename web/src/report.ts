// SPDX-License-Identifier: BSD-2-Clause
// The page of `soarbox report`, for runs or a sweep. If there is a run in 3D, report_scene.ts is loaded before it.
import { keepInPage } from "./report/storage";
import { applyTheme, themeNow } from "./app/theme";
import type { Report } from "./report/data";
import { ReportPage, type Scene } from "./report/report_page";

declare global {
  /** Left by report_scene.ts. */
  var soarboxScene: Scene | undefined;
}

keepInPage();
applyTheme(themeNow());
const root = document.getElementById("report"), data = document.getElementById("data")?.textContent ?? "[]";
if (root !== null) new ReportPage(root, JSON.parse(data) as readonly Report[], globalThis.soarboxScene ?? null);
