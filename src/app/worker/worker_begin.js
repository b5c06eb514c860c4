// SPDX-License-Identifier: BSD-2-Clause
// Begins the engine of a page's worker: where its place and the program's own files are, as `soarbox serve` says it to its engines.
Module["preRun"] = [].concat(Module["preRun"] || [], () => {
  Object.assign(ENV, { SOARBOX_DATA: "/soarbox", SOARBOX_PLACE: "/place", HOME: "/place/home", XDG_STATE_HOME: "/place/state" });
  FS.mkdir("/place");
});
