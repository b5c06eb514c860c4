// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>

#include "debugger/json.h"
#include "workbench/contents.h"
#include "workbench/document/document.h"

namespace soarbox::workbench::document {

/// Whether a document describes the panel.
bool HasDocument(PanelId panel);
/// Builds the document of a panel; empty if it has none.
Nodes DocumentOf(PanelId panel, const Contents& contents);
/// The number that the panel's tab shows; empty: none.
std::string BadgeOf(PanelId panel, const Contents& contents);

/// Converts a document to JSON (docs/workbench.md).
debugger::Json ToJson(const Nodes& nodes);
/// Prints the complete document as text. Times are computed from ticks of `step_s` seconds, starting at tick 0.
std::string ToText(const Nodes& nodes, double step_s);

// Builders of the panels' documents, each in a file of its name.
Nodes AgentsDocument(const Contents& contents);
Nodes MindDocument(const Contents& contents);
Nodes MemoryDocument(const Contents& contents);
Nodes RulesDocument(const Contents& contents);
Nodes WhyDocument(const Contents& contents);
Nodes LinksDocument(const Contents& contents);
Nodes MessagesDocument(const Contents& contents);
Nodes TraceDocument(const Contents& contents);
Nodes PlotsDocument(const Contents& contents);
Nodes BreakpointsDocument(const Contents& contents);
Nodes FuturesDocument(const Contents& contents);
Nodes WatchDocument(const Contents& contents);
Nodes MindsDocument(const Contents& contents);
Nodes LongTermDocument(const Contents& contents);
Nodes LearningDocument(const Contents& contents);
Nodes ExerciseDocument(const Contents& contents);
Nodes ImageryDocument(const Contents& contents);
Nodes ScriptDocument(const Contents& contents);
Nodes ProblemsDocument(const Contents& contents);
Nodes MissionDocument(const Contents& contents);
Nodes ConsoleDocument(const Contents& contents);

struct PanelDocument {
  PanelId panel;
  Nodes (*build)(const Contents&);
};
inline constexpr PanelDocument kPanelDocuments[] = {
    {PanelId::kAgents, AgentsDocument},     {PanelId::kMind, MindDocument},
    {PanelId::kMemory, MemoryDocument},     {PanelId::kRules, RulesDocument},
    {PanelId::kWhy, WhyDocument},           {PanelId::kLinks, LinksDocument},
    {PanelId::kMessages, MessagesDocument}, {PanelId::kTrace, TraceDocument},
    {PanelId::kPlots, PlotsDocument},       {PanelId::kBreakpoints, BreakpointsDocument},
    {PanelId::kFutures, FuturesDocument},   {PanelId::kWatch, WatchDocument},
    {PanelId::kMinds, MindsDocument},       {PanelId::kLongTerm, LongTermDocument},
    {PanelId::kLearning, LearningDocument}, {PanelId::kExercise, ExerciseDocument},
    {PanelId::kImagery, ImageryDocument},   {PanelId::kScript, ScriptDocument},
    {PanelId::kProblems, ProblemsDocument}, {PanelId::kMission, MissionDocument},
    {PanelId::kConsole, ConsoleDocument},
};

}  // namespace soarbox::workbench::document
