// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic.h"

namespace soarbox {

/// "did you mean 'target'?", with the candidate that is most similar to a misspelt word. If none is similar, returns
/// `otherwise`.
inline std::string NearestHint(std::string_view word, const std::vector<std::string_view>& candidates,
                               std::string otherwise = {}) {
  const std::string_view near = Suggest(word, candidates);
  return near.empty() ? std::move(otherwise) : "did you mean '" + std::string(near) + "'?";
}

}  // namespace soarbox
