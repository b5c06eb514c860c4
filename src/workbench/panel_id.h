// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace soarbox::workbench {

/// The panels around the picture, in the order of the Panels menu.
enum class PanelId : std::uint8_t {
  kAgents,
  kMind,
  kMemory,
  kRules,
  kWhy,
  kLinks,
  kMessages,
  kTimeline,
  kTrace,
  kPlots,
  kConsole,
  kEdit,
  kBreakpoints,
  kFutures,
  kProblems,
  kWatch,
  kMinds,
  kMission,
  kLongTerm,
  kLearning,
  kExercise,
  kImagery,
  kScript,
};

/// Names, description and key of a panel.
struct PanelInfo {
  PanelId id;
  std::string_view word;   ///< In the file of the layout and on the command line.
  std::string_view title;  ///< On its tab and in the menu.
  std::string_view about;  ///< Tooltip: what the panel shows.
  char key;                ///< With Alt: brings the panel to the front.
};

/// One line for each panel, in the order of PanelId.
inline constexpr auto kPanelInfos = std::to_array<PanelInfo>({
    {PanelId::kAgents, "agents", "Agents", "All agents of the world: team, state, operator, command. Click to select.",
     'A'},
    {PanelId::kMind, "mind", "Mind",
     "The goal stack, the operators that compete in it, and why one of them was selected.", 'M'},
    {PanelId::kMemory, "memory", "Memory", "Working memory as a tree; changes are marked.", 'E'},
    {PanelId::kRules, "rules", "Rules", "The rules with how often they fired, what they match now, or where they fail.",
     'R'},
    {PanelId::kWhy, "why", "Why", "Why the agent does what it does, and why it does not do something else.", 'W'},
    {PanelId::kLinks, "links", "Senses",
     "What the agent perceives (input link) and which commands it gives (output link).", 'S'},
    {PanelId::kMessages, "messages", "Messages", "What agents said to each other.", 'G'},
    {PanelId::kTimeline, "timeline", "Timeline",
     "Operators, impasses, commands and events over time. Click to go there.", 'T'},
    {PanelId::kTrace, "trace", "Trace", "What the mind did, decision by decision; filter and search it.", 'C'},
    {PanelId::kPlots, "plots", "Plots", "Numbers over time: percepts, reward, decision time, rules fired.", 'P'},
    {PanelId::kConsole, "console", "Console", "The Soar command line of the selected agent.", 'L'},
    {PanelId::kEdit, "edit", "Edit", "Change rules and reload them while the world runs.", 'D'},
    {PanelId::kBreakpoints, "breakpoints", "Breakpoints", "Stop the world when a rule fires, an impasse occurs, ...",
     'B'},
    {PanelId::kFutures, "futures", "Futures",
     "After going back: the old future next to the new one, and where they differ.", 'U'},
    {PanelId::kProblems, "problems", "Problems", "Errors and warnings in full, with file and line.", 'O'},
    {PanelId::kWatch, "watch", "Watch",
     "Values and Soar commands that you want to see at each decision, for several agents side by side.", 'H'},
    {PanelId::kMinds, "minds", "Minds", "Several minds side by side: goal stack, operators, commands.", 'I'},
    {PanelId::kMission, "mission", "Mission", "What agents are to do: checks that tick off as they come true. Lessons.",
     'K'},
    {PanelId::kLongTerm, "longterm", "Long-term memory",
     "What the agent knows and remembers, what it recalled and why; an episode as ghosts in the scene.", 'Y'},
    {PanelId::kLearning, "learning", "Learning",
     "Rules that the agent learned, with their reasons; values learned from reward, as numbers and curves.", 'N'},
    {PanelId::kExercise, "exercise", "Exercise",
     "The exercise (DIS) that the run shares with other simulations: their entities, sent and received PDUs, dropped "
     "PDUs.",
     'X'},
    {PanelId::kImagery, "imagery", "Imagery",
     "What the agent imagines: the scene of each state, what its rules ask of it, the answers, and why they are so.",
     'V'},
    {PanelId::kScript, "script", "Script",
     "Stop Lua scripts at a line, and step through them: calls, variables, values that you watch.", 'F'},
});
inline constexpr std::size_t kPanelCount = kPanelInfos.size();

inline constexpr const PanelInfo& InfoOf(PanelId id) {
  return kPanelInfos[static_cast<std::size_t>(id)];
}

/// The panel with this word; nothing if there is none.
inline constexpr std::optional<PanelId> FindPanel(std::string_view word) {
  for (const PanelInfo& info : kPanelInfos) {
    if (info.word == word) return info.id;
  }
  return std::nullopt;
}

/// The panel with this title; null if there is none.
inline constexpr const PanelInfo* FindPanelByTitle(std::string_view title) {
  for (const PanelInfo& info : kPanelInfos) {
    if (info.title == title) return &info;
  }
  return nullptr;
}

/// Some of the panels.
class PanelSet {
 public:
  void Add(PanelId id) { bits_ |= Bit(id); }
  bool Has(PanelId id) const { return (bits_ & Bit(id)) != 0; }
  /// The union of both sets.
  friend PanelSet operator|(PanelSet a, const PanelSet& b) {
    a.bits_ |= b.bits_;
    return a;
  }
  friend bool operator==(const PanelSet&, const PanelSet&) = default;

 private:
  static constexpr std::uint32_t Bit(PanelId id) { return std::uint32_t{1} << static_cast<unsigned>(id); }

  std::uint32_t bits_ = 0;
};
static_assert(kPanelCount <= 32);

}  // namespace soarbox::workbench
