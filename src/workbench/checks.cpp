// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/checks.h"

#include <algorithm>

namespace soarbox::workbench {

bool NoteCheck(const sim::RunEvent& event, std::vector<CheckRow>& checks) {
  const auto* report = std::get_if<sim::CheckReport>(&event.values);
  if (report == nullptr) return false;
  const auto known = std::ranges::find(checks, event.text, &CheckRow::name);
  CheckRow& row = known != checks.end() ? *known : checks.emplace_back();
  row = {event.text,        report->expected, report->was, report->agent,
         report->is_marker, event.parameters, event.tick,  event.time_s};
  return true;
}

namespace {

/// The result as soon as the check is decided, in the present future and with the present rules.
CheckResult FinalResultOf(const CheckRow& check, const Contents& contents) {
  const Moment& at = contents.moment;
  const bool is_passed = check.state == "true";
  if (!is_passed && check.state != "false") return CheckResult::kOpen;
  if (at.branch_tick && check.tick > *at.branch_tick) return CheckResult::kOpen;
  if (at.changed_tick && check.tick <= *at.changed_tick) return CheckResult::kOpen;
  if (is_passed) return CheckResult::kPassed;
  return contents.lesson && !contents.lesson->is_tried ? CheckResult::kOpen : CheckResult::kFailed;
}

}  // namespace

CheckResult ResultOf(const CheckRow& check, const Contents& contents) {
  return check.tick > contents.moment.shown_tick ? CheckResult::kOpen : FinalResultOf(check, contents);
}

bool IsDecidedLater(const CheckRow& check, const Contents& contents) {
  return check.tick > contents.moment.shown_tick && FinalResultOf(check, contents) != CheckResult::kOpen;
}

CheckCounts CountChecks(const Contents& contents) {
  CheckCounts counts;
  for (const CheckRow& check : contents.checks) {
    if (check.is_marker) continue;
    const CheckResult result = ResultOf(check, contents);
    ++counts.all;
    counts.passed += result == CheckResult::kPassed ? 1 : 0;
    counts.failed += result == CheckResult::kFailed ? 1 : 0;
  }
  return counts;
}

std::string WhyChecksAreOpen(const Moment& moment) {
  if (moment.branch_tick && moment.is_live)
    return "You went on from an earlier moment. Checks follow a run from its beginning.";
  if (moment.changed_tick) return "The rules changed while the world ran. Checks follow a run from its beginning.";
  return {};
}

}  // namespace soarbox::workbench
