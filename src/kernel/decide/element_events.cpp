// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/element_events.h"

#include <string>

#include "kernel/base/symbol_table.h"
#include "kernel/decide/agent_counters.h"
#include "kernel/decide/descriptions.h"
#include "kernel/decide/goal_dependency_set.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/modules.h"
#include "kernel/decide/observers.h"
#include "kernel/decide/run_control.h"
#include "kernel/io/input_link.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

void ElementEvents::AttributeUsed(Symbol attribute) {
  uses_.modules.AttributeUsed(attribute);
}

void ElementEvents::DependencyLost(WmeId wme) {
  uses_.gds.MemberLeaves(wme);
}

void ElementEvents::DependencyForgotten(WmeId wme) {
  uses_.gds.Forget(wme);
}

void ElementEvents::InputElementRemoved(std::uint32_t element) {
  uses_.input.Forget(element);
}

bool ElementEvents::FlushBegins(std::size_t added, std::size_t removed) {
  uses_.run.StopIfBroken();
  uses_.counters.wme_additions += added;
  uses_.counters.wme_removals += removed;
  return uses_.observers.Wants(Event::kWme);
}

void ElementEvents::FirstWasLost(WmeId lost) {
  const Wme& wme = uses_.memory.wme(lost);
  const auto text = [&](Symbol symbol) { return ToString(uses_.symbols, symbol); };
  uses_.observers.Warn(WarningKind::kAddedAndRemoved, "(" + std::to_string(wme.timetag) + ": " + text(wme.id) + " ^" +
                                                          text(wme.attribute) + " " + text(wme.value) +
                                                          (wme.acceptable ? " +)" : ")"));
}

void ElementEvents::Entered(WmeId wme) {
  const WmeInfo info = uses_.descriptions.Describe(wme);
  uses_.observers.Notify(Event::kWme, [&](Observer& o) { o.OnWmeAdded(uses_.agent, info); });
}

void ElementEvents::Left(WmeId wme) {
  const WmeInfo info = uses_.descriptions.Describe(wme);
  uses_.observers.Notify(Event::kWme, [&](Observer& o) { o.OnWmeRemoved(uses_.agent, info); });
}

void ElementEvents::RuleInterrupts() {
  uses_.run.TellInterrupts();
}

void ElementEvents::Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) {
  // (Without states, init-soar is emptying working memory.)
  if (uses_.modules.Wants(ModuleHook::kFlush) && !uses_.goals.empty()) uses_.modules.Flushed(added, removed);
}

}  // namespace soarbox::kernel
