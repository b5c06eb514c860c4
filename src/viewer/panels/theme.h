// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <imgui.h>

#include "diagnostics/diagnostic.h"

namespace soarbox::viewer {

/// The colours of the panels. Those that carry a meaning are of Okabe and Ito's set, which people with any of the
/// common kinds of colour blindness tell apart; nothing is told by colour alone.
namespace theme {

inline const ImVec4 kText{0.91f, 0.93f, 0.95f, 1};
inline const ImVec4 kQuiet{0.61f, 0.67f, 0.73f, 1};
inline const ImVec4 kGround{0.075f, 0.095f, 0.122f, 1};
inline const ImVec4 kRaised{0.115f, 0.143f, 0.180f, 1};
inline const ImVec4 kField{0.045f, 0.060f, 0.080f, 1};
inline const ImVec4 kEdge{0.20f, 0.24f, 0.29f, 1};

inline const ImVec4 kAccent{0.34f, 0.71f, 0.91f, 1};    ///< Sky blue: selected, links.
inline const ImVec4 kGood{0.18f, 0.75f, 0.56f, 1};      ///< Bluish green: won, matches, running.
inline const ImVec4 kWarn{0.95f, 0.68f, 0.13f, 1};      ///< Orange: changed, paused, a warning.
inline const ImVec4 kBad{0.97f, 0.49f, 0.29f, 1};       ///< Vermilion: errors, failing conditions.
inline const ImVec4 kNumber{0.94f, 0.89f, 0.26f, 1};    ///< Yellow: numbers.
inline const ImVec4 kVariable{0.86f, 0.58f, 0.74f, 1};  ///< Reddish purple: variables, identifiers.

/// Colours of curves and tracks, told apart in this order.
inline const ImVec4 kSeries[] = {kAccent, kWarn, kGood, kVariable, kNumber, kBad};

inline ImU32 Packed(ImVec4 color, float alpha = 1) {
  color.w *= alpha;
  return ImGui::ColorConvertFloat4ToU32(color);
}

inline ImVec4 ColorOf(Severity severity) {
  return severity == Severity::kError ? kBad : severity == Severity::kWarning ? kWarn : kQuiet;
}

}  // namespace theme

/// Sets ImGui's style for this text size; 1 is 100 %.
void ApplyTheme(float scale);

}  // namespace soarbox::viewer
