// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

namespace soarbox::script {

struct ReferencePage {
  std::string file;  ///< "agent.md".
  std::string text;  ///< Markdown.
};

/// The pages of docs/lua/: one for each group of functions, and README.md, which lists all.
std::vector<ReferencePage> ApiReference();

}  // namespace soarbox::script
