// SPDX-License-Identifier: BSD-2-Clause
#include "app/junit.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "diagnostics/problem.h"
#include "mission/check_sentences.h"

namespace soarbox::app {
namespace {

/// Escapes a text for XML.
std::string Escape(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        // XML does not allow other control characters.
        out += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? '?' : c;
    }
  }
  return out;
}

std::string Lines(const std::vector<std::string>& texts) {
  std::string lines;
  for (const std::string& text : texts) lines += text + "\n";
  return lines;
}

/// Whether this run failed although none of its checks did: it reported an error.
bool IsAtFault(const TestedMission& tested, const mission::RunResult& run) {
  if (run.passed || run.problems.empty() || run.IsUndecided()) return false;
  const std::vector<mission::Check>& checks = tested.loaded.mission.checks;
  for (std::size_t i = 0; i < checks.size(); ++i)
    if (!checks[i].marker && !checks[i].pass && !run.IsTrue(i)) return false;
  return true;
}

/// Why the result of this check is not known: the test was interrupted, and the check failed in no finished run. Empty
/// if the result is known.
std::string WhyOpen(const TestedMission& tested, std::size_t check) {
  const mission::MissionOutcome& outcome = tested.outcome;
  if (!outcome.IsInterrupted() || outcome.check_true[check] < outcome.runs.size()) return {};
  return "interrupted after " + std::to_string(outcome.runs.size()) + " of " + std::to_string(outcome.asked);
}

Result<void> Save(const std::filesystem::path& file, const std::string& text) {
  std::ofstream to(file, std::ios::binary);
  if ((to << text).flush()) return {};
  return ProblemIn(file.string(), std::string("this file cannot be written: ") + std::strerror(errno));
}

}  // namespace

bool CheckPassed(const TestedMission& tested, std::size_t check) {
  return tested.outcome.check_true[check] >= mission::NeededOf(tested.loaded.mission, tested.outcome, check);
}

Result<void> WriteJunit(const std::filesystem::path& file, const std::vector<TestedMission>& tested) {
  std::ostringstream out;
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const TestedMission& each : tested) {
    const mission::Mission& mission = each.loaded.mission;
    std::size_t failures = 0, cases = 0, errors = 0, skipped = 0;
    std::ostringstream body;
    for (std::size_t i = 0; i < mission.checks.size(); ++i) {
      if (mission.checks[i].marker) continue;
      ++cases;
      body << "    <testcase name=\"" << Escape(mission.checks[i].name) << "\" classname=\"" << Escape(mission.name)
           << "\">";
      if (const std::string open = WhyOpen(each, i); !open.empty()) {
        ++skipped;
        body << "<skipped message=\"" << Escape(open) << "\"/>";
      } else if (!CheckPassed(each, i)) {
        ++failures;
        body << "<failure message=\"" << each.outcome.check_true[i] << " of " << each.outcome.runs.size() << "\">";
        for (const mission::RunResult& run : each.outcome.runs) {
          if (run.outcome != "ok" || run.IsTrue(i)) continue;
          const mission::CheckResult& check = run.checks[i];
          body << Escape("seed " + std::to_string(run.seed) + ", " + mission::SecondsText(check.verdict.time_s) + ": " +
                         check.expected + "; " + check.verdict.was)
               << "\n";
          for (const std::string& reason : check.reasons) body << "  " << Escape(reason) << "\n";
          if (!run.recording.empty()) body << "[[ATTACHMENT|" << Escape(run.recording) << "]]\n";
        }
        body << "</failure>";
      }
      body << "</testcase>\n";
    }
    for (const mission::RunResult& run : each.outcome.runs) {
      if (run.outcome == "ok" && !IsAtFault(each, run)) continue;
      ++errors;
      ++cases;
      body << "    <testcase name=\"seed " << run.seed << "\" classname=\"" << Escape(mission.name)
           << "\"><error message=\"" << Escape(run.outcome == "ok" ? "problem" : run.outcome) << "\">"
           << Escape(run.outcome == "ok" ? Lines(run.problems) : run.error) << "</error></testcase>\n";
    }
    out << "  <testsuite name=\"" << Escape(mission.name) << "\" tests=\"" << cases << "\" failures=\"" << failures
        << "\" errors=\"" << errors << "\" skipped=\"" << skipped << "\" time=\""
        << mission::NumberText(each.outcome.wall_s) << "\">\n"
        << body.str() << "  </testsuite>\n";
  }
  out << "</testsuites>\n";
  return Save(file, out.str());
}

}  // namespace soarbox::app
