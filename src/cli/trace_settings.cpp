// SPDX-License-Identifier: BSD-2-Clause
#include "cli/trace_settings.h"

namespace soarbox::cli {
namespace {

using enum TraceFlag;

constexpr TraceFlagInfo kInfos[] = {
    {kAssertions, 'A', "assertions", "Assertions of rules and preferences",
     "assertions of rule instantiations and the preferences they generate", ""},
    {kBacktracing, 'b', "backtracing", "Dependency analysis", "chunking's dependency analysis trace messages",
     "watchbacktracing"},
    {kChunks, 'c', "chunks", "Chunks", "when chunks fire", "watchproductionchunks"},
    {kChunkWarnings, 'C', "chunk-warnings", "Chunking warnings", "warnings when issues detected while learning rules",
     ""},
    {kConsistency, 'o', "consistency", "State removals caused by operator consistency checks",
     "operator proposal consistency messages and any states removed as a result", ""},
    {kDecisions, 'd', "decisions", "Operator decisions and states", "states created and operators selected",
     "watchdecisions"},
    {kDefaultRules, 'D', "default", "Default rules", "when rules marked as :default fire", "watchproductiondefault"},
    {kGdsWmes, 'G', "gds-wmes", "Goal dependency set changes", "all WMEs added or removed from the Goal Dependency Set",
     "watchgds"},
    {kGds, 'g', "gds", "State removals caused by GDS violation", "when a state is removed because of a GDS violation",
     "watchgdsstateremoval"},
    {kIndifferent, 'i', "indifferent-selection", "Numeric preference calculations",
     "how Soar calculates and resolves numeric preferences", "watchindifferentselection"},
    {kRl, 'R', "rl", "Reinforcement learning value updates", "reinforcement learning value updates and gap intervals",
     "watchrl"},
    {kEpmem, 'e', "epmem", "Episodic memory recording and queries",
     "when episodic memory records a new episode or considers an episode in a query", "watchepmem"},
    {kJustifications, 'j', "justifications", "Justifications", "when justifications fire",
     "watchproductionjustifications"},
    {kTemplates, 'T', "template", "Templates", "when templates match", "watchproductiontemplates"},
    {kPhases, 'p', "phases", "Phases", "each individual phase", "watchphases"},
    {kPreferences, 'r', "preferences", "Preferences", "preferences as they are created", "watchpreferences"},
    {kSmem, 's', "smem", "Semantic memory additions", "additions to semantic memory", "watchsmem"},
    {kUserRules, 'u', "user", "User rules", "when user rules fire", "watchproductionuser"},
    {kWmes, 'w', "wmes", "WME additions and removals",
     "when working memory elements are added to or removed from memory", "watchworkingmemorychanges"},
    {kWaterfall, 'W', "waterfall", "Firings inhibited by higher-level firings",
     "when rules do not fire because a higher level rule matches and needs to fire first", "watchwaterfall"},
    {kWma, 'a', "wma", "Working memory activation and forgetting",
     "working memory activations, changed values, and removals caused by forgetting (if enabled)", "watchwma"},
};
static_assert(std::size(kInfos) == kTraceFlagCount);

struct Leveled {
  TraceFlag flag;
  int level;
};

constexpr Leveled kLevels[] = {
    {kDecisions, 1},   {kPhases, 2}, {kConsistency, 2},    {kGds, 2},       {kChunkWarnings, 2}, {kDefaultRules, 3},
    {kUserRules, 3},   {kChunks, 3}, {kJustifications, 3}, {kTemplates, 3}, {kWaterfall, 3},     {kWmes, 4},
    {kPreferences, 5},
};

}  // namespace

TraceSettings::TraceSettings() {
  SetLevel(1);
}

void TraceSettings::SetLevel(int level) {
  level_ = level;
  if (level <= 0) {
    flags_ = {};
    wme_detail_ = WmeDetail::kNone;
    learning_ = 0;
    return;
  }
  for (const Leveled& leveled : kLevels) Set(leveled.flag, leveled.level <= level);
}

std::span<const TraceFlagInfo> TraceSettings::Infos() {
  return kInfos;
}

}  // namespace soarbox::cli
