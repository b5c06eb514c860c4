// SPDX-License-Identifier: BSD-2-Clause

const KEY = "soarbox.theme";
export type Theme = "system" | "light" | "dark";

export function themeNow(): Theme {
  const kept = localStorage.getItem(KEY);
  return kept === "light" || kept === "dark" ? kept : "system";
}

export function applyTheme(theme: Theme): void {
  if (theme === "system") localStorage.removeItem(KEY);
  else localStorage.setItem(KEY, theme);
  if (theme === "system") delete document.documentElement.dataset["theme"];
  else document.documentElement.dataset["theme"] = theme;
}

export function isDark(): boolean {
  const theme = themeNow();
  return theme === "dark" || (theme === "system" && matchMedia("(prefers-color-scheme: dark)").matches);
}

/** The opposite theme: dark for light, light for dark. */
export function switchTheme(): void {
  applyTheme(isDark() ? "light" : "dark");
  dispatchEvent(new Event("soarbox-theme"));
}
