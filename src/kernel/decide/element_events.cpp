// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/element_events.h"

#include <string>

#include "kernel/decide/engine.h"

namespace soarbox::kernel {

void ElementEvents::AttributeUsed(Symbol attribute) {
  engine_.chunker.NoteElement(attribute);
}

void ElementEvents::DependencyLost(WmeId wme) {
  engine_.gds.MemberLeaves(wme);
}

void ElementEvents::DependencyForgotten(WmeId wme) {
  engine_.gds.Forget(wme);
}

void ElementEvents::InputElementRemoved(std::uint32_t element) {
  engine_.input.Forget(element);
}

bool ElementEvents::FlushBegins(std::size_t added, std::size_t removed) {
  engine_.StopIfBroken();
  engine_.counters.wme_additions += added;
  engine_.counters.wme_removals += removed;
  return engine_.observers.Wants(Event::kWme);
}

void ElementEvents::FirstWasLost(WmeId lost) {
  const Wme& wme = engine_.memory.wme(lost);
  const auto text = [&](Symbol symbol) { return ToString(engine_.symbols, symbol); };
  engine_.observers.Warn(WarningKind::kAddedAndRemoved, "(" + std::to_string(wme.timetag) + ": " + text(wme.id) + " ^" +
                                                            text(wme.attribute) + " " + text(wme.value) +
                                                            (wme.acceptable ? " +)" : ")"));
}

void ElementEvents::Entered(WmeId wme) {
  const WmeInfo info = engine_.descriptions.Describe(wme);
  engine_.observers.Notify(Event::kWme, [&](Observer& o) { o.OnWmeAdded(engine_.agent, info); });
}

void ElementEvents::Left(WmeId wme) {
  const WmeInfo info = engine_.descriptions.Describe(wme);
  engine_.observers.Notify(Event::kWme, [&](Observer& o) { o.OnWmeRemoved(engine_.agent, info); });
}

void ElementEvents::RuleInterrupts() {
  engine_.run.TellInterrupts();
}

void ElementEvents::Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) {
  // (Without states it is init-soar that takes working memory apart.)
  if (engine_.long_term.Wants(ModuleHook::kFlush) && !engine_.goals.empty()) engine_.long_term.Flushed(added, removed);
}

}  // namespace soarbox::kernel
