// SPDX-License-Identifier: BSD-2-Clause
#include "app/junit.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "diagnostics/problem.h"
#include "mission/sentences.h"

namespace soarbox::app {
namespace {

/// What XML can hold, and stands for itself.
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
        // Other control characters may not stand in XML at all.
        out += static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t' ? '?' : c;
    }
  }
  return out;
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
    std::size_t failures = 0, cases = 0, errors = 0;
    std::ostringstream body;
    for (std::size_t i = 0; i < mission.checks.size(); ++i) {
      if (mission.checks[i].marker) continue;
      ++cases;
      body << "    <testcase name=\"" << Escape(mission.checks[i].name) << "\" classname=\"" << Escape(mission.name)
           << "\">";
      if (!CheckPassed(each, i)) {
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
      if (run.outcome == "ok") continue;
      ++errors;
      ++cases;
      body << "    <testcase name=\"seed " << run.seed << "\" classname=\"" << Escape(mission.name)
           << "\"><error message=\"" << Escape(run.outcome) << "\">" << Escape(run.error) << "</error></testcase>\n";
    }
    out << "  <testsuite name=\"" << Escape(mission.name) << "\" tests=\"" << cases << "\" failures=\"" << failures
        << "\" errors=\"" << errors << "\" time=\"" << mission::NumberText(each.outcome.wall_s) << "\">\n"
        << body.str() << "  </testsuite>\n";
  }
  out << "</testsuites>\n";
  std::ofstream to(file, std::ios::binary);
  if ((to << out.str()).flush()) return {};
  return ProblemIn(file.string(), std::string("this file cannot be written: ") + std::strerror(errno));
}

}  // namespace soarbox::app
