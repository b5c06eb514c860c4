// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include "cli/lookup.h"
#include "cli/percepts.h"

namespace soarbox::cli {

using kernel::InputElement;
using kernel::InputLink;
using kernel::InputObject;

PerceptPlayer::PerceptPlayer(kernel::Agent& agent, PerceptFile file, std::function<void(const std::string&)> tell)
    : agent_(agent), file_(std::move(file)), tell_(std::move(tell)) {
  agent_.random().Seed(file_.seed);
  agent_.input().SetTap(this);
}

PerceptPlayer::~PerceptPlayer() {
  if (agent_.input().tap() == this) agent_.input().SetTap(nullptr);
}

void PerceptPlayer::GiveUp(const PerceptAction* action, const std::string& why) {
  playing_ = false;
  awaited_.clear();
  tell_(fmt::format("The replay of input ended in cycle {}{}: {}.", cycle_,
                    action ? fmt::format(" (line {} of the recording)", action->line) : "", why));
  agent_.RequestStop();
}

void PerceptPlayer::OnInputPhase(InputLink& link) {
  if (!playing_) return;
  ++cycle_;
  if (cycle_ > file_.last_cycle && next_ == file_.actions.size()) {
    playing_ = false;
    tell_(fmt::format("The recorded input is used up after {} cycles; clients are heard again.", file_.last_cycle));
    return;
  }
  link.DropPending();
  awaited_.clear();
  for (; playing_ && next_ < file_.actions.size(); ++next_) {
    const PerceptAction& action = file_.actions[next_];
    if (action.kind == PerceptAction::Kind::kInit) {
      if (action.cycle >= cycle_) return;
      GiveUp(&action, "the recorded run was initialised (init-soar) here");
      return;
    }
    if (action.cycle > cycle_) return;
    if (!Play(link, action)) return;
  }
}

InputObject PerceptPlayer::Object(InputLink& link, const std::string& name) {
  if (const auto made = objects_.find(name); made != objects_.end()) {
    if (link.Identifier(made->second)) return made->second;
    // Its identifier may be created in this phase.
    for (const PerceptAction* action : awaited_) {
      const auto* value = std::get_if<PerceptAction::Identifier>(&action->value);
      if (value && value->is_new && value->name == name) return made->second;
    }
    objects_.erase(made);
  }
  const kernel::Symbol identifier = FindIdentifier(agent_, name);
  return identifier ? link.ObjectFor(identifier) : InputObject::kNone;
}

bool PerceptPlayer::Play(InputLink& link, const PerceptAction& action) {
  if (action.kind == PerceptAction::Kind::kRemove) {
    const auto made = elements_.find(action.timetag);
    if (made == elements_.end()) {
      GiveUp(&action, fmt::format("there is no element of the input link with time tag {}", action.timetag));
      return false;
    }
    awaited_.push_back(&action);
    link.Remove(made->second);
    elements_.erase(made);
    return true;
  }
  const InputObject parent = Object(link, action.parent);
  if (parent == InputObject::kNone) {
    GiveUp(&action, fmt::format("there is no identifier {}", action.parent));
    return false;
  }
  kernel::InputValue value;
  if (const auto* integer = std::get_if<std::int64_t>(&action.value)) {
    value = *integer;
  } else if (const auto* real = std::get_if<double>(&action.value)) {
    value = *real;
  } else if (const auto* text = std::get_if<std::string>(&action.value)) {
    value = std::string_view(*text);
  } else {
    const auto& identifier = std::get<PerceptAction::Identifier>(action.value);
    InputObject object;
    if (identifier.is_new) {
      object = objects_[identifier.name] = link.NewObject();
    } else {
      object = Object(link, identifier.name);
    }
    if (object == InputObject::kNone) {
      GiveUp(&action, fmt::format("there is no identifier {}", identifier.name));
      return false;
    }
    value = object;
  }
  awaited_.push_back(&action);
  elements_[action.timetag] = link.Add(parent, action.attribute, value);
  return true;
}

void PerceptPlayer::OnInputChange(const kernel::InputChange& change) {
  if (!playing_ || awaited_.empty()) return;
  // The link calls this only for changes that it has made. After a change that it could not make, the next one does not
  // fit, and the run differs.
  const PerceptAction* expected = awaited_.front();
  awaited_.pop_front();
  if (differs_ ||
      (expected->timetag == change.timetag && change.added == (expected->kind == PerceptAction::Kind::kAdd))) {
    return;
  }
  differs_ = true;
  tell_(
      fmt::format("From cycle {} on this run is not the recorded one: line {} of the recording has time tag {}, here "
                  "it is {}. Replay into an agent with the same rules, from the same beginning.",
                  cycle_, expected->line, expected->timetag, change.timetag));
}

void PerceptPlayer::OnInputReset() {
  if (!playing_) return;
  elements_.clear();
  objects_.clear();
  awaited_.clear();
  if (next_ < file_.actions.size() && file_.actions[next_].kind == PerceptAction::Kind::kInit &&
      file_.actions[next_].cycle == cycle_) {
    ++next_;
    return;
  }
  GiveUp(nullptr, "the agent was initialised, which the recorded one was not");
}

}  // namespace soarbox::cli
