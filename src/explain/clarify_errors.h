// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox::explain {

/// A kernel reports where its reader stumbled; this looks in the files for what a beginner most likely did there (a
/// comment of another language, no } at a rule's end, a misshapen arrow) and says that instead. It drops what one slip
/// causes in the lines after it.
void ClarifyErrors(std::vector<Diagnostic>& problems);

/// The same for files whose text somebody else has, such as an editor.
using TextOfFile = std::function<std::string(const std::string& file)>;
void ClarifyErrors(std::vector<Diagnostic>& problems, const TextOfFile& text_of);

}  // namespace soarbox::explain
