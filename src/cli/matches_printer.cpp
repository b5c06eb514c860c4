// SPDX-License-Identifier: BSD-2-Clause
#include "cli/matches_printer.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/object_printer.h"
#include "cli/printed_rule.h"

namespace soarbox::cli {
namespace {

using kernel::Agent;
using kernel::Condition;
using kernel::ConditionKind;
using kernel::MatchSet;
using kernel::WmeId;

constexpr std::string_view kFailed = ">>>> ";
constexpr std::string_view kBeyond = "     ";

class PartialMatchPrinter {
 public:
  PartialMatchPrinter(PrintStream& stream, const Agent& agent, kernel::ProductionId rule, WmeDetail detail,
                      ResultNode& structured)
      : stream_(stream), agent_(agent), rule_(rule), detail_(detail), structured_(structured) {}

  void Print() {
    const kernel::Production& production = agent_.production(rule_);
    structured_.Add("matches");
    ResultNode& node = structured_.Add("production");
    bool failed = false;
    PrintConditions(production.conditions, {}, "", failed);
    const std::vector<std::uint16_t> last{static_cast<std::uint16_t>(production.conditions.size() - 1)};
    const std::size_t complete = failed ? 0 : agent_.rete().CountAfter(rule_, last);
    node.Set("matches", std::to_string(complete));
    stream_.Print(fmt::format("\n{} complete matches.\n", complete));
    if (detail_ == WmeDetail::kNone || complete == 0) return;
    stream_.Print("*** Complete Matches ***\n");
    PrintTokens(agent_.rete().MatchesAfter(rule_, last), "");
  }

 private:
  void PrintConditions(std::span<const Condition> conditions, std::vector<std::uint16_t> path,
                       const std::string& indent, bool& failed) {
    path.push_back(0);
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      path.back() = static_cast<std::uint16_t>(i);
      const Condition& condition = conditions[i];
      if (condition.kind == ConditionKind::kConjunctiveNegation) {
        stream_.Print(indent + "    -{\n");
        // A failure in a conjunctive negation is not a failure of the rule.
        bool inner_failed = failed;
        PrintConditions(condition.conditions(), path, indent + std::string(kBeyond), inner_failed);
        PrintMark(path, indent, failed);
        stream_.Print("}\n");
        continue;
      }
      const bool now_failing = PrintMark(path, indent, failed);
      stream_.Print(ConditionText(agent_, condition) + "\n");
      if (now_failing && detail_ != WmeDetail::kNone) PrintMeeting(path, indent);
    }
  }

  /// Prints the count before a condition, or the mark at the first condition that fails, or blanks after it. Returns
  /// true at that first condition.
  bool PrintMark(const std::vector<std::uint16_t>& path, const std::string& indent, bool& failed) {
    if (failed) {
      stream_.Print(indent + std::string(kBeyond));
      return false;
    }
    const std::size_t count = agent_.rete().CountAfter(rule_, path);
    failed = count == 0;
    stream_.Print(indent + (failed ? std::string(kFailed) : fmt::format("{:4} ", count)));
    return failed;
  }

  /// Prints the partial matches of the previous conditions, and the elements of the condition itself.
  void PrintMeeting(const std::vector<std::uint16_t>& path, const std::string& indent) {
    stream_.Print(indent + "*** Matches For Left ***\n");
    const bool first = path.size() == 1 && path[0] == 0;
    if (first)
      stream_.Print(indent + "\n");
    else
      PrintTokens(agent_.rete().MatchesBefore(rule_, path), indent);
    stream_.Print(indent + "*** Matches for Right ***\n" + indent);
    for (const WmeId wme : agent_.rete().RightMatches(rule_, path)) PrintWme(wme);
    stream_.Print("\n");
  }

  void PrintWme(WmeId wme) {
    if (detail_ == WmeDetail::kTimetags)
      stream_.Print(fmt::format("{} ", agent_.memory().wme(wme).timetag));
    else
      stream_.Print(WmeText(agent_, wme) + "\n ");
  }

  void PrintTokens(const kernel::Rete::PartialMatches& matches, const std::string& indent) {
    for (const std::vector<WmeId>& match : matches) {
      stream_.Print(indent);
      for (const WmeId wme : match) PrintWme(wme);
      stream_.Print("\n");
    }
  }

  PrintStream& stream_;
  const Agent& agent_;
  kernel::ProductionId rule_;
  WmeDetail detail_;
  ResultNode& structured_;
};

/// Prints one list of the match set. Without detail, matches of one rule in one state are counted together.
void PrintList(PrintStream& stream, const Agent& agent, MatchSet::List list, WmeDetail detail, ResultNode& node) {
  const MatchSet& matches = agent.rete().matches();
  const std::vector<kernel::PendingMatch> pending = matches.Pending(list);
  const bool retractions = list == MatchSet::List::kRetractions;
  const auto name = [&](const kernel::PendingMatch& match) {
    if (match.production == kernel::ProductionId::kNone) return std::string("justification");
    return RuleName(agent, *agent.rete().production(match.production));
  };
  const auto head = [&](const kernel::PendingMatch& match) {
    return "  " + name(match) + "  [" + (match.goal ? SymbolText(agent, match.goal) : "") + "] ";
  };
  const auto add_node = [&](const kernel::PendingMatch& match) -> ResultNode& {
    ResultNode& child = node.Add("production");
    child.Set("goal", match.goal ? SymbolText(agent, match.goal) : "").Set("name", name(match));
    return child;
  };
  if (detail == WmeDetail::kNone) {
    std::vector<std::pair<std::string, int>> counted;
    for (const kernel::PendingMatch& match : pending) {
      add_node(match);
      const std::string line = head(match);
      const auto same = [&](const auto& entry) { return entry.first == line; };
      const auto found = std::find_if(counted.begin(), counted.end(), same);
      if (found == counted.end())
        counted.emplace_back(line, 1);
      else
        ++found->second;
    }
    // Single matches are listed newest first, counted ones newest last.
    for (auto entry = counted.rbegin(); entry != counted.rend(); ++entry) {
      stream.Print(entry->first + (entry->second > 1 ? fmt::format("({})", entry->second) : std::string()) + "\n");
    }
    return;
  }
  for (const kernel::PendingMatch& match : pending) {
    ResultNode& child = add_node(match);
    stream.Print(retractions ? "  " + name(match) + "\n" : head(match));
    for (const WmeId wme : matches.Wmes(match.match)) {
      AddWmeNode(child, agent, wme);
      const std::uint64_t timetag = agent.memory().wme(wme).timetag;
      if (retractions) {
        stream.Print(detail == WmeDetail::kTimetags ? fmt::format(" {}", timetag)
                                                    : fmt::format("WME with time tag {}\n", timetag));
      } else {
        stream.Print(detail == WmeDetail::kTimetags ? fmt::format("{} ", timetag) : WmeText(agent, wme) + "\n ");
      }
    }
    stream.Print("\n");
  }
}

}  // namespace

void PrintPartialMatches(PrintStream& stream, const Agent& agent, kernel::ProductionId rule, WmeDetail detail,
                         ResultNode& structured) {
  PartialMatchPrinter(stream, agent, rule, detail, structured).Print();
}

void PrintMatchSet(PrintStream& stream, const Agent& agent, bool assertions, bool retractions, WmeDetail detail,
                   ResultNode& structured) {
  structured.Add("matches");
  if (assertions) {
    stream.Print("O Assertions:\n");
    PrintList(stream, agent, MatchSet::List::kOAssertions, detail, structured.Add("O-assertions"));
    stream.Print("I Assertions:\n");
    PrintList(stream, agent, MatchSet::List::kIAssertions, detail, structured.Add("I-assertions"));
  }
  if (retractions) {
    stream.Print("Retractions:\n");
    PrintList(stream, agent, MatchSet::List::kRetractions, detail, structured.Add("retractions"));
  }
}

}  // namespace soarbox::cli
