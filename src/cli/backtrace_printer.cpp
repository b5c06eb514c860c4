// SPDX-License-Identifier: BSD-2-Clause
#include "cli/backtrace_printer.h"

#include <fmt/format.h>

#include "cli/object_printer.h"
#include "cli/printed_rule.h"
#include "cli/session.h"
#include "cli/trace_printer.h"
#include "kernel/rules/print_production.h"

namespace soarbox::cli {
namespace {

using kernel::Agent;
using kernel::BacktraceStep;

/// Lists the elements in reverse order, as Soar does.
std::string TestedText(const Agent& agent, std::string_view title, std::span<const kernel::WmeId> wmes) {
  std::string text = fmt::format("  -->{}:\n", title);
  for (std::size_t n = wmes.size(); n-- > 0;) text += "     " + WmeText(agent, wmes[n]) + "\n";
  return text;
}

std::string TracedPreferenceText(const Agent& agent, kernel::PreferenceId id) {
  const kernel::Preference& preference = agent.memory().preference(id);
  return fmt::format("{} [level {}]\n", PreferenceText(agent, preference), preference.level);
}

}  // namespace

BacktracePrinter::~BacktracePrinter() {
  Listen(false);
}

void BacktracePrinter::Listen(bool on) {
  if (on == listens_) return;
  listens_ = on;
  if (on) {
    session_.agent().AddObserver(*this, Mask(kernel::Event::kBacktrace));
  } else {
    session_.agent().RemoveObserver(*this);
  }
}

void BacktracePrinter::OnBacktrace(const Agent& agent, const BacktraceStep& step) {
  PrintStream& stream = session_.stream();
  stream.FreshLine();
  switch (step.kind) {
    case BacktraceStep::Kind::kResult:
      stream.Print("For result preference " + TracedPreferenceText(agent, step.preference));
      return;
    case BacktraceStep::Kind::kSelection:
      stream.Print("\nFor preference that selected the operator " + TracedPreferenceText(agent, step.preference));
      return;
    case BacktraceStep::Kind::kFiring:
      PrintFiring(agent, step);
      return;
    case BacktraceStep::Kind::kKnownFiring:
      stream.Print(fmt::format(" ... BT through instantiation of {}, traced above\n", RuleName(agent, step.firing)));
      return;
    case BacktraceStep::Kind::kLocals:
      stream.Print("\n\n*** Tracing Locals ***\n");
      return;
    case BacktraceStep::Kind::kLocal:
      stream.Print("\nFor local " + WmeText(agent, step.local) + "\n");
      return;
    case BacktraceStep::Kind::kNoMaker:
      stream.Print(" ...no trace, can't BT\n");
      return;
    case BacktraceStep::Kind::kItem:
      stream.Print(" ... BT through the proposal of the item\n" + TestedText(agent, "Grounds", step.grounds));
      return;
    case BacktraceStep::Kind::kEnd:
      stream.Print("\n*** Adding Grounded Negated Conditions ***\n\n");
      return;
  }
}

void BacktracePrinter::PrintFiring(const Agent& agent, const BacktraceStep& step) {
  std::string text = fmt::format(" ... BT through instantiation of {}\n", RuleName(agent, step.firing));
  text += TestedText(agent, "Grounds", step.grounds) + "\n" + TestedText(agent, "Locals", step.locals);
  text += "\n  -->Negated:\n";
  if (step.negated != nullptr) {
    for (const kernel::Condition& condition : step.negated->conditions) {
      AppendNegation(text, agent, condition);
      text += "\n";
    }
  }
  session_.stream().Print(text + "\n");
}

void AppendNegation(std::string& text, const Agent& agent, const kernel::Condition& condition) {
  if (condition.kind != kernel::ConditionKind::kConjunctiveNegation) {
    text += "   ";
    kernel::AppendCondition(text, agent.symbols(), condition);
    return;
  }
  std::string_view before = "  -{ ";
  for (const kernel::Condition& inner : condition.conditions()) {
    text += before;
    kernel::AppendCondition(text, agent.symbols(), inner);
    before = "\n   ";
  }
  text += "}";
}

}  // namespace soarbox::cli
