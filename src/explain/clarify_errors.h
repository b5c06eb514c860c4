// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox::explain {

/// Replaces the errors that a kernel reports about files of rules by clearer ones. It reads the files and looks for the
/// likely mistake of a beginner: a comment of another language, a missing } at the end of a rule, a malformed arrow. It
/// also removes the errors that follow from the same mistake in later lines.
void ClarifyErrors(std::vector<Diagnostic>& problems);

/// Like ClarifyErrors(problems), but `text_of` returns the text of each file. An editor uses it for unsaved files.
using TextOfFile = std::function<std::string(const std::string& file)>;
void ClarifyErrors(std::vector<Diagnostic>& problems, const TextOfFile& text_of);

}  // namespace soarbox::explain
