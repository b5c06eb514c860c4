// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "app/page_server.h"

namespace soarbox::app {

/// `soarbox serve`: serves lessons and worlds, each in its own engine, until Ctrl-C. Returns an ExitCode.
int ServePages(const ServeOptions& options);

/// `--browser`: opens a page with one run or one recording and serves it until it is closed. Returns an ExitCode.
int ShowInBrowser(const BrowserOptions& options);

}  // namespace soarbox::app
