// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <initializer_list>
#include <string_view>

#include "workbench/panel_id.h"

namespace soarbox::workbench {

/// The initial positions of panels around the picture, in order. The first panel of each side is in front.
struct Arrangement {
  std::string_view word;
  std::initializer_list<PanelId> left, right, bottom;
};

/// The window and pages of live runs use kWorldArrangement, pages of lessons kLessonArrangement, and recorded runs in
/// reports kReportArrangement. The panel Exercise is added on the left if the run takes part in an exercise.
inline constexpr Arrangement kWorldArrangement{
    "world",
    {PanelId::kAgents, PanelId::kMission, PanelId::kProblems},
    {PanelId::kMind, PanelId::kWhy, PanelId::kMemory, PanelId::kRules, PanelId::kLinks, PanelId::kEdit,
     PanelId::kBreakpoints, PanelId::kFutures},
    {PanelId::kTimeline, PanelId::kTrace, PanelId::kConsole, PanelId::kPlots, PanelId::kMessages, PanelId::kWatch,
     PanelId::kMinds, PanelId::kLongTerm, PanelId::kLearning, PanelId::kImagery, PanelId::kScript}};
inline constexpr Arrangement kLessonArrangement{
    "lesson",
    {PanelId::kMission, PanelId::kAgents},
    {PanelId::kEdit},
    {PanelId::kWhy, PanelId::kMind, PanelId::kMemory, PanelId::kRules, PanelId::kLinks, PanelId::kTimeline,
     PanelId::kTrace, PanelId::kMessages, PanelId::kProblems, PanelId::kConsole, PanelId::kWatch, PanelId::kPlots,
     PanelId::kLearning, PanelId::kLongTerm, PanelId::kImagery, PanelId::kBreakpoints, PanelId::kMinds,
     PanelId::kFutures, PanelId::kScript}};
inline constexpr Arrangement kReportArrangement{
    "report",
    {PanelId::kAgents, PanelId::kMission},
    {PanelId::kMind, PanelId::kWhy},
    {PanelId::kTimeline, PanelId::kMessages, PanelId::kTrace, PanelId::kImagery}};

}  // namespace soarbox::workbench
