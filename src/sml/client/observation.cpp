// SPDX-License-Identifier: BSD-2-Clause
#include <array>
#include <charconv>
#include <string>
#include <string_view>
#include <utility>

#include "cli/object_printer.h"
#include "cli/stack_printer.h"
#include "kernel/agent.h"
#include "kernel/observer.h"
#include "sml/client/agent_data.h"
#include "sml/client/decision_reason.h"
#include "sml/client/local_agent_link.h"
#include "soarbox_Observation.h"

namespace soarbox {
namespace {

using cli::SymbolText;
using kernel::Event;

/// "S1", made in place.
class IdentifierText {
 public:
  IdentifierText(const kernel::Agent& agent, kernel::Symbol symbol) {
    if (!symbol.IsIdentifier()) {
      other_ = SymbolText(agent, symbol);
      return;
    }
    text_[0] = agent.symbols().Letter(symbol);
    const char* const end = std::to_chars(text_ + 1, text_ + sizeof text_, agent.symbols().Number(symbol)).ptr;
    size_ = static_cast<std::size_t>(end - text_);
  }
  std::string_view view() const { return size_ == 0 ? std::string_view(other_) : std::string_view(text_, size_); }

 private:
  char text_[24] = {};
  std::size_t size_ = 0;
  std::string other_;  ///< Of operators that are constants.
};

/// Names as they are printed. The same few come again and again, and it takes a while to see whether one needs bars.
class PrintedNames {
 public:
  /// Valid until the next call.
  std::string_view Of(const kernel::Agent& agent, kernel::Symbol symbol) {
    if (!symbol.IsString()) return other_ = SymbolText(agent, symbol);
    const std::string_view text = agent.symbols().Text(symbol);
    Entry& entry = entries_[text.empty() ? 0 : static_cast<unsigned char>(text.back()) % entries_.size()];
    if (entry.printed.empty() || entry.text != text) entry = {std::string(text), SymbolText(agent, symbol)};
    return entry.printed;
  }

 private:
  struct Entry {
    std::string text, printed;
  };
  std::array<Entry, 8> entries_;
  std::string other_;
};

/// Passes on what a kernel in this process tells of one agent.
class LocalObservation final : public Observation, kernel::Observer {
 public:
  LocalObservation(kernel::Agent& agent, MindObserver& listener, MindDetail detail)
      : agent_(agent), listener_(listener) {
    kernel::EventMask events = Event::kDecision | Event::kRun | Event::kOutput;
    if (detail == MindDetail::kWritten) events = Event::kPrint | Event::kRun;
    if (detail == MindDetail::kAll) events = events | Event::kFiring | Event::kWme;
    agent_.AddObserver(*this, events);
  }
  ~LocalObservation() override { agent_.RemoveObserver(*this); }
  void BeforeRun() override { forced_ = agent_.selected_operator(); }

 private:
  void OnDecision(const kernel::Agent& agent, const kernel::GoalInfo& goal, std::uint64_t) override {
    const IdentifierText state(agent, goal.goal);
    if (goal.op) {
      const IdentifierText op(agent, goal.op);
      listener_.OnOperator(static_cast<int>(goal.level), state.view(), op.view(), NameOf(agent, goal.op));
      reason_.clear();
      const bool is_forced = !forced_.empty() && op.view() == forced_;
      AppendReasonOfOperator(agent, goal, is_forced, reason_);
      if (is_forced) forced_.clear();
      listener_.OnReason(reason_);
    } else {
      listener_.OnState(static_cast<int>(goal.level), state.view(), cli::ImpasseName(goal.impasse),
                        goal.on_operator ? "operator" : "state");
      listener_.OnReason(ReasonOfState(agent, goal));
    }
  }
  void OnStateRemoved(const kernel::Agent& agent, const kernel::GoalInfo& goal, kernel::GoalRemoval why) override {
    if (why == kernel::GoalRemoval::kWithSuperstate) return;
    listener_.OnStateGone(static_cast<int>(goal.level), SymbolText(agent, goal.goal));
  }
  void OnPrint(const kernel::Agent&, std::string_view text) override { listener_.OnWritten(text); }
  void OnError(const kernel::Agent&, std::string_view text) override { listener_.OnWritten(text); }
  void OnWarning(const kernel::Agent&, kernel::WarningKind kind, std::string_view text) override {
    // Of the warnings, what matters to whoever reads what rules write.
    // Once: it comes in each decision from then on.
    if (kind == kernel::WarningKind::kMaxElaborationsPropose || kind == kernel::WarningKind::kMaxElaborationsApply) {
      if (!std::exchange(told_of_elaborations_, true))
        listener_.OnWritten("Warning: reached max-elaborations: its rules fire again and again in one phase\n");
    }
    if (kind == kernel::WarningKind::kMaxDecisionTime || kind == kernel::WarningKind::kOther) listener_.OnWritten(text);
  }
  void OnRuleInterrupt(const kernel::Agent& agent, kernel::ProductionId rule, std::uint32_t) override {
    listener_.OnWritten("interrupted by the rule " + std::string(agent.production(rule).name) + "\n");
  }
  void OnHalt(const kernel::Agent&) override { listener_.OnHalt(); }
  void OnOutput(const kernel::Agent& agent) override {
    const kernel::Symbol link = agent.output().identifier();
    for (const kernel::OutputChange& change : agent.output().changes()) {
      if (!change.added || change.id != link) continue;
      listener_.OnCommand(change.timetag, names_.Of(agent, change.attribute),
                          RuleOfOutput(agent, change.attribute, change.timetag));
    }
  }
  void OnFiring(const kernel::Agent&, const kernel::FiringInfo& info) override {
    listener_.OnFiring(info.name, static_cast<int>(info.level), false);
  }
  void OnRetracting(const kernel::Agent&, const kernel::FiringInfo& info) override {
    listener_.OnFiring(info.name, static_cast<int>(info.level), true);
  }
  void OnWmeAdded(const kernel::Agent& agent, const kernel::WmeInfo& wme) override { Tell(agent, wme, true); }
  void OnWmeRemoved(const kernel::Agent& agent, const kernel::WmeInfo& wme) override { Tell(agent, wme, false); }

  void Tell(const kernel::Agent& agent, const kernel::WmeInfo& wme, bool added) {
    listener_.OnElement(added, wme.timetag, SymbolText(agent, wme.id), SymbolText(agent, wme.attribute),
                        SymbolText(agent, wme.value), wme.acceptable);
  }

  /// The operator's ^name; empty if it has none. Valid until the next name is asked for.
  std::string_view NameOf(const kernel::Agent& agent, kernel::Symbol op) {
    if (!op.IsIdentifier()) return {};
    // The symbol may have been swept, and its place taken by another.
    const kernel::SymbolTable& symbols = agent.symbols();
    if (!name_ || !symbols.IsLive(name_) || symbols.Text(name_) != "name") name_ = symbols.FindString("name");
    if (!name_) return {};
    const kernel::Symbol value = agent.memory().ValueOf(op, name_);
    return value ? names_.Of(agent, value) : std::string_view();
  }

  kernel::Agent& agent_;
  MindObserver& listener_;
  bool told_of_elaborations_ = false;
  kernel::Symbol name_;  ///< "name".
  PrintedNames names_;
  std::string forced_;  ///< The operator that `select` or `predict` had settled before the run; empty: none.
  std::string reason_;  ///< Keeps its memory from decision to decision.
};

/// Null if the kernel is in another process.
kernel::Agent* KernelAgent(sml::Agent& agent) {
  auto* link = dynamic_cast<sml::LocalAgentLink*>(sml::AgentData::Of(agent).link.get());
  return link == nullptr ? nullptr : &link->hosted().agent();
}

}  // namespace

std::unique_ptr<Observation> ObserveMind(sml::Agent& agent, MindObserver& observer, MindDetail detail) {
  kernel::Agent* mind = KernelAgent(agent);
  if (mind == nullptr) return nullptr;
  return std::make_unique<LocalObservation>(*mind, observer, detail);
}

CallBatch::CallBatch(sml::Agent& agent) {
  sml::KernelLink* link = sml::AgentData::Of(agent).kernel_data().link.get();
  if (link == nullptr) return;
  held_ = &link->mutex();
  held_->lock();
}
CallBatch::~CallBatch() {
  if (held_ != nullptr) held_->unlock();
}

std::size_t MindMemoryBytes(sml::Agent& agent) {
  const kernel::Agent* mind = KernelAgent(agent);
  return mind == nullptr ? 0 : mind->MemoryBytes();
}

std::uint32_t MindMatchLimit(sml::Agent& agent) {
  const kernel::Agent* mind = KernelAgent(agent);
  return mind == nullptr ? 0 : mind->settings().max_partial_matches;
}

void SetMindMatchLimit(sml::Agent& agent, std::uint32_t most) {
  if (kernel::Agent* mind = KernelAgent(agent)) mind->mutable_settings().max_partial_matches = most;
}

}  // namespace soarbox
