// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

namespace soarbox::app {

/// The commit from which the program was built, from a file that the build wrote next to the program: "3bfdd897...",
/// followed by " with changes" if files differed from it. Empty if the program was built outside of a repository.
///
/// It is a separate file, so that two commits that give the same program give the same build id.
std::string Commit();

/// The version without the build: "0.1.0".
std::string Version();

/// The text of `--version`: the version, then the commit and the build id, each on its own line.
std::string VersionText();

}  // namespace soarbox::app
