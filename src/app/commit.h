// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::app {

/// The commit that the program was built from, as the build wrote it beside the program: "3bfdd897...", followed by
/// " with changes" if files differed from it. Empty if the program was built outside of a repository.
///
/// It is a file and no part of the program: two commits that give the same program give the same build id.
std::string Commit();

/// The version without the build: "0.1.0".
std::string Version();

/// What `--version` prints: the version, then the commit and the build id in lines of their own.
std::string VersionText();

}  // namespace soarbox::app
