// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

namespace soarbox::record {

/// What a mind's percepts are after its changes, by path ("self.speed", "agent#3.range").
using PerceptValues = std::map<std::string, std::string, std::less<>>;

/// Applies the changes of a tick (MindRecord::percepts): "path value" sets, "-path" removes, with all below it.
void ApplyPercepts(std::span<const std::string> changes, PerceptValues& values);

}  // namespace soarbox::record
