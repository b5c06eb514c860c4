// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_debugger.h"

#include <algorithm>
#include <lua.hpp>
#include <set>
#include <utility>

#include "script/lua_machine.h"
#include "script/lua_protected.h"
#include "script/script_path.h"

namespace soarbox::script {
namespace {

std::filesystem::path Plain(const std::filesystem::path& file) {
  std::error_code failed;
  std::filesystem::path plain = std::filesystem::weakly_canonical(file, failed);
  return failed ? file.lexically_normal() : plain;
}

}  // namespace

void ScriptDebugger::SetBreakpoints(const std::filesystem::path& file, std::vector<ScriptBreakpoint> breakpoints) {
  marks_by_script_.clear();
  if (breakpoints.empty()) {
    marks_.erase(Plain(file));
  } else {
    marks_[Plain(file)] = std::move(breakpoints);
  }
  lines_.clear();
  for (const auto& [path, marks] : marks_) {
    for (const ScriptBreakpoint& mark : marks) {
      const auto line = static_cast<std::size_t>(std::max(mark.line, 0));
      if (line >= lines_.size()) lines_.resize(line + 1);
      lines_[line] = true;
    }
  }
}

void ScriptDebugger::ForgetStep() {
  stop_in_.reset();
  EndStep();
}

bool ScriptDebugger::IsWanted() const {
  return enabled_ && (!marks_.empty() || stop_at_errors_ || stop_in_ || step_ != ScriptStep::kGo);
}

void ScriptDebugger::OnWorld() {
  // References to another world's machines are void.
  view_.references_.clear();
  view_.machines_.clear();
  marks_by_script_.clear();
  step_ = ScriptStep::kGo;
  step_machine_ = nullptr;
  step_from_ = {};
  hits_.clear();
}

void ScriptDebugger::OnMachine(LuaMachine& machine) {
  view_.machines_.push_back(&machine);
}

void ScriptDebugger::OnGone(LuaMachine& machine) {
  if (step_machine_ == &machine) EndStep();
  std::erase_if(hits_, [&](const Place& hit) { return hit.machine == &machine; });
  view_.Forget(machine);
}

const std::vector<ScriptBreakpoint>* ScriptDebugger::MarksOf(const LuaMachine& machine, std::string_view script) const {
  const auto known = marks_by_script_.find(script);
  if (known != marks_by_script_.end()) return known->second;
  const auto found = marks_.find(Plain(machine.path().PathOf(script)));
  return marks_by_script_.emplace(script, found == marks_.end() ? nullptr : &found->second).first->second;
}

ScriptObserver::Wants ScriptDebugger::WantsOf(const LuaMachine& machine) {
  if (!enabled_) return {};
  const bool steps = step_ != ScriptStep::kGo && step_machine_ == &machine;
  if (steps || stop_in_ == machine.owner()) return {.lines = true};
  if (marks_.empty()) return {};
  return {.lines = std::ranges::any_of(machine.files(),
                                       [&](const std::string& file) { return MarksOf(machine, file) != nullptr; })};
}

const ScriptBreakpoint* ScriptDebugger::BreakpointAt(LuaMachine& machine, lua_State* state, lua_Debug& frame) const {
  const auto line = static_cast<std::size_t>(std::max(frame.currentline, 0));
  if (line >= lines_.size() || !lines_[line]) return nullptr;
  lua_Debug info = frame;
  lua_getinfo(state, "S", &info);
  if (info.source == nullptr || info.source[0] != '@') return nullptr;
  const std::vector<ScriptBreakpoint>* marks = MarksOf(machine, info.source + 1);
  if (marks == nullptr) return nullptr;
  const auto found = std::ranges::find(*marks, frame.currentline, &ScriptBreakpoint::line);
  return found == marks->end() ? nullptr : &*found;
}

bool ScriptDebugger::IsStepOver(const LuaMachine& machine, lua_State* state, const lua_Debug& frame) const {
  if (step_ == ScriptStep::kGo || step_machine_ != &machine) return false;
  if (step_from_.state == nullptr) return true;
  if (state != step_from_.state) {
    if (step_ == ScriptStep::kInto) return true;
    // A coroutine that continues is stepped over, but not if the stepped coroutine waits or has ended.
    lua_Debug call;
    return lua_status(step_from_.state) != 0 || lua_getstack(step_from_.state, 0, &call) == 0;
  }
  const bool is_same = frame.i_ci == step_from_.call;
  switch (step_) {
    case ScriptStep::kInto:
      return !is_same || frame.currentline != step_from_.line;
    case ScriptStep::kOver:
      return frame.i_ci < step_from_.call || (is_same && frame.currentline != step_from_.line);
    default:
      return frame.i_ci < step_from_.call;
  }
}

bool ScriptDebugger::IsHit(const Place& place) {
  // Deeper calls have returned, and a call that has reached another line may pause again.
  std::erase_if(hits_, [&](const Place& hit) {
    return hit.state == place.state && (hit.call > place.call || (hit.call == place.call && hit.line != place.line));
  });
  // Lua reports a line again when a call in it returns.
  return std::ranges::any_of(hits_,
                             [&](const Place& hit) { return hit.state == place.state && hit.call == place.call; });
}

void ScriptDebugger::OnLine(LuaMachine& machine, lua_State* state, lua_Debug& frame) {
  if (!enabled_ || view_.is_paused()) return;
  const int line = frame.currentline;
  const bool is_hit = IsHit({&machine, state, frame.i_ci, line});
  std::string reason, fault;
  if (const ScriptBreakpoint* mark = is_hit ? nullptr : BreakpointAt(machine, state, frame)) {
    const Result<bool> holds = mark->condition.empty()
                                   ? Result<bool>(true)
                                   : ScriptView::Holds(machine, state, mark->condition, mark->may_call);
    if (!holds) fault = "the condition '" + mark->condition + "' has no value: " + holds.error().message;
    if (!holds || *holds) reason = "breakpoint";
  }
  if (reason.empty() && (IsStepOver(machine, state, frame) || stop_in_ == machine.owner())) reason = "step";
  if (reason.empty()) return;
  std::erase_if(hits_, [&](const Place& hit) { return hit.state == state && hit.call == frame.i_ci; });
  hits_.push_back({&machine, state, frame.i_ci, line});
  PauseHere(machine, state, 0, std::move(reason), std::move(fault));
  if (next_step_ == ScriptStep::kGo) return EndStep();
  BeginStep(machine, state, frame);
}

void ScriptDebugger::OnError(LuaMachine& machine, lua_State* state) {
  if (!enabled_ || !stop_at_errors_ || view_.is_paused()) return;
  const char* message = lua_tostring(state, -1);
  PauseHere(machine, state, 1, "error", message == nullptr ? "an error that is not a string" : message);
  EndStep();
  // The call has ended: a step leads to the next one.
  if (next_step_ == ScriptStep::kGo) return;
  step_ = ScriptStep::kInto;
  step_machine_ = &machine;
}

void ScriptDebugger::OnEnd(LuaMachine& machine) {
  std::erase_if(hits_, [&](const Place& hit) { return hit.machine == &machine; });
  if (step_machine_ != &machine || step_ == ScriptStep::kGo) return;
  // The stepped function has returned to the world: the step ends in the next call.
  EndStep();
  step_ = ScriptStep::kInto;
  step_machine_ = &machine;
}

void ScriptDebugger::PauseHere(LuaMachine& machine, lua_State* state, int first_level, std::string reason,
                               std::string error) {
  EndStep();
  stop_in_.reset();
  next_step_ = ScriptStep::kGo;
  view_.BeginPause(machine, state, first_level, std::move(reason), std::move(error));
  pause_();
  view_.EndPause();
  // Breakpoints may have changed, also for machines that wait for this one to return.
  for (LuaMachine* other : view_.machines_) other->UpdateHooks();
}

void ScriptDebugger::BeginStep(LuaMachine& machine, lua_State* state, const lua_Debug& frame) {
  step_ = next_step_;
  step_machine_ = &machine;
  step_from_ = {&machine, state, frame.i_ci, frame.currentline};
  step_thread_ = LUA_NOREF;
  const auto failed = Guarded(state, [&](lua_State* inner) {
    lua_pushthread(inner);
    step_thread_ = luaL_ref(inner, LUA_REGISTRYINDEX);
  });
  if (failed) step_from_ = {};
  machine.UpdateHooks();
}

void ScriptDebugger::EndStep() {
  if (step_from_.state != nullptr && step_machine_ != nullptr) step_machine_->Release(step_thread_);
  step_ = ScriptStep::kGo;
  step_machine_ = nullptr;
  step_from_ = {};
}

}  // namespace soarbox::script
