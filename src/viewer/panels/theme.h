// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <imgui.h>

#include <cstddef>
#include <iterator>

#include "diagnostics/diagnostic.h"

namespace soarbox::viewer {

/// The colours of the panels. Colours with a meaning come from the palette of Okabe and Ito, which people with any
/// common kind of colour blindness can distinguish. No meaning is expressed by colour alone.
namespace theme {

// There is a dark and a light set; ApplyTheme copies one of them into these variables.
inline ImVec4 kText, kQuiet, kGround, kRaised, kField, kEdge;

inline ImVec4 kAccent;    ///< Sky blue: selected, links.
inline ImVec4 kGood;      ///< Bluish green: won, matches, running.
inline ImVec4 kWarn;      ///< Orange: changed, paused, a warning.
inline ImVec4 kBad;       ///< Vermilion: errors, failing conditions.
inline ImVec4 kNumber;    ///< Yellow: numbers.
inline ImVec4 kVariable;  ///< Reddish purple: variables, identifiers.

/// Colours of curves and tracks, in the order of their use.
inline ImVec4 Series(std::size_t number) {
  const ImVec4 all[] = {kAccent, kWarn, kGood, kVariable, kNumber, kBad};
  return all[number % std::size(all)];
}

inline ImU32 Packed(ImVec4 color, float alpha = 1) {
  color.w *= alpha;
  return ImGui::ColorConvertFloat4ToU32(color);
}

inline ImVec4 ColorOf(Severity severity) {
  return severity == Severity::kError ? kBad : severity == Severity::kWarning ? kWarn : kQuiet;
}

}  // namespace theme

/// Sets the colours, and ImGui's style for this text size; 1 is 100 %.
void ApplyTheme(float scale, bool light = false);

}  // namespace soarbox::viewer
