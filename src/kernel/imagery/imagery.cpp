// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/imagery.h"

#include <algorithm>
#include <utility>

#include "kernel/decide/elaboration.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/modules.h"
#include "kernel/decide/observers.h"

namespace soarbox::kernel {

using imagery::Scene;
using imagery::StateScene;

namespace {

/// Imagery is called before long-term memory, whose places begin at 0.
constexpr int kPlace = -1;

Result<void> Refusal(std::string message) {
  Diagnostic diagnostic;
  diagnostic.message = std::move(message);
  return diagnostic;
}

}  // namespace

Imagery::Imagery(const Uses& uses) : uses_(uses), writer_(uses.symbols, uses.memory, uses.changes, uses.preferences) {
  uses_.modules.Attach(*this, kPlace);
}

Imagery::~Imagery() = default;

// Switches ------------------------------------------------------------------------------------------------------------

void Imagery::SetHooks() {
  uses_.modules.SetHooks(*this, enabled_ ? ModuleHook::kInput | ModuleHook::kOutput | ModuleHook::kStates : 0);
}

void Imagery::Settle() {
  uses_.elaboration.ApplyBufferedChanges();
}

void Imagery::Enable() {
  if (enabled_) return;
  enabled_ = look_again_ = true;
  SetHooks();
  MakeStates();
}

Result<void> Imagery::Disable() {
  if (states_.size() > 1) return Refusal("Cannot disable Spatial Visual System while in a substate. ");
  enabled_ = false;
  SetHooks();
  return {};
}

void Imagery::EnableInSubstates() {
  in_substates_ = true;
  if (enabled_) MakeStates();
}

Result<void> Imagery::DisableInSubstates() {
  if (states_.size() > 1) return Refusal("Cannot disable Spatial Visual System in substates while in a substate. ");
  in_substates_ = false;
  return {};
}

// States --------------------------------------------------------------------------------------------------------------

/// Creates scenes for all states without one. The match receives their elements only in the next input phase. Rules
/// that are loaded before that phase are in the network by then.
void Imagery::MakeStates() {
  for (GoalLevel level = 1; level <= uses_.goals.depth(); ++level) {
    const bool there =
        std::any_of(states_.begin(), states_.end(), [&](const auto& state) { return state->level() == level; });
    if (!there && (level == 1 || in_substates_)) MakeState(level);
  }
}

void Imagery::MakeState(GoalLevel level) {
  const Symbol goal = uses_.goals.at(level).id;
  std::unique_ptr<Scene> scene = level == 1 ? std::move(kept_) : nullptr;
  if (scene == nullptr) {
    const std::string name = writer_.NameOf(goal);
    scene = states_.empty() ? std::make_unique<Scene>(name) : states_.back()->scene().Clone(name);
  }
  ++gone_;
  states_.push_back(std::make_unique<StateScene>(StateScene::Parts{writer_, random_, goal, level}, std::move(scene)));
  if (level == 1) states_.back()->Draw(true, viewer_);
}

void Imagery::StateComplete(GoalLevel level) {
  if (level == 1 || in_substates_) MakeState(level);
}

void Imagery::StateEnds(GoalLevel level) {
  while (!states_.empty() && states_.back()->level() >= level) {
    gone_ += states_.back()->version() + 1;
    if (updating_) ended_.push_back(std::move(states_.back()));
    states_.pop_back();
  }
}

void Imagery::BeforeInit() {
  for (const auto& state : states_) gone_ += state->version() + 1;
  if (!states_.empty()) kept_ = states_.front()->TakeScene();
  states_.clear();
}

void Imagery::AfterInit() {
  if (!enabled_) return;
  MakeStates();
  Settle();
}

std::uint64_t Imagery::version() const {
  std::uint64_t version = gone_;
  for (const auto& state : states_) version += state->version();
  return version;
}

StateScene* Imagery::FindState(std::string_view name) {
  for (const auto& state : states_) {
    if (state->scene().name() == name) return state.get();
  }
  return nullptr;
}

// The cycle -----------------------------------------------------------------------------------------------------------

void Imagery::Input() {
  if (states_.empty()) return;
  updating_ = true;
  if (!lines_.empty()) {
    look_again_ = true;
    for (const std::string& line : std::exchange(lines_, {})) {
      constexpr std::size_t kMostRefused = 1000;
      const std::optional<imagery::LineError> error = imagery::ApplyLine(states_.front()->scene(), line);
      if (!error) continue;
      if (refused_.size() >= kMostRefused) refused_.erase(refused_.begin());
      refused_.push_back(error->ToString());
    }
  }
  // A state may be removed meanwhile, because its goal dependency set may contain a changed result.
  for (const bool writes : {true, false}) {
    for (std::size_t n = 0; n < states_.size(); ++n) {
      StateScene& state = *states_[n];
      state.Update(writes, look_again_);
    }
  }
  if (look_again_ && uses_.observers.Wants(Event::kPrint)) TellTroubles();
  look_again_ = false;
  updating_ = false;
  ended_.clear();
}

void Imagery::TellTroubles() {
  for (const auto& state : states_) {
    state->TellTroubles([&](WmeId command, const imagery::Trouble& trouble) {
      uses_.observers.Notify(Event::kPrint, [&](Observer& observer) {
        observer.OnSceneProblem(uses_.agent, command, trouble.problem, trouble.hint);
      });
    });
  }
}

void Imagery::Output(bool) {
  for (const auto& state : states_) {
    if (state->NoteCommands()) look_again_ = true;
  }
}

// Lines ---------------------------------------------------------------------------------------------------------------

bool Imagery::Send(std::string_view lines) {
  if (!enabled_) return false;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    if (end > 0) lines_.emplace_back(lines.substr(0, end));
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return true;
}

std::string Imagery::TakeRefused() {
  std::string text;
  for (const std::string& line : std::exchange(refused_, {})) text += line + "\n";
  return text;
}

std::string Imagery::Query(std::string_view queries) const {
  return enabled_ && !states_.empty() ? imagery::AnswerQueries(states_.front()->scene(), queries) : std::string();
}

std::optional<imagery::LineError> Imagery::Apply(StateScene& state, std::string_view line) {
  look_again_ = true;
  std::optional<imagery::LineError> error = imagery::ApplyLine(state.scene(), line);
  Settle();
  return error;
}

void Imagery::Clear(StateScene& state) {
  look_again_ = true;
  state.scene().Clear();
  Settle();
}

// Viewers and upkeep --------------------------------------------------------------------------------------------------

void Imagery::SetViewer(imagery::ViewerSink sink) {
  viewer_ = std::move(sink);
  for (const auto& state : states_) state->Draw(state->drawn(), viewer_);
}

void Imagery::Draw(StateScene& state, bool on) {
  if (state.drawn() != on) state.Draw(on, viewer_);
}

void Imagery::Mark(const std::function<void(Symbol)>& mark) {
  for (const auto& state : states_) state->Mark(mark);
}

std::size_t Imagery::MemoryBytes() const {
  std::size_t bytes = sizeof(Imagery);
  for (const auto& state : states_) bytes += state->MemoryBytes();
  return bytes;
}

}  // namespace soarbox::kernel
