// SPDX-License-Identifier: BSD-2-Clause
#include "sim/apply_input.h"

#include <optional>
#include <utility>

#include "script/keep_state.h"
#include "script/script_host.h"
#include "sim/foreign_bodies.h"
#include "sim/input_names.h"
#include "sim/soar_host.h"
#include "world/world.h"

namespace soarbox::sim {
namespace {

script::InputEvent MouseEvent(float x_px, float y_px) {
  script::InputEvent event;
  event.source = script::InputEvent::Source::kMouse;
  event.x = x_px;
  event.y = y_px;
  return event;
}

struct Applier {
  const InputTargets& to;
  bool recorded;

  void Warn(std::string message, std::string hint = {}) const {
    Diagnostic warning;
    warning.message = std::move(message);
    warning.hint = std::move(hint);
    to.warn(std::move(warning));
  }

  const world::Agent* Find(const std::string& name) const {
    std::vector<std::string_view> names;
    for (const world::EntityId id : to.world.AgentIds()) {
      const world::Agent* agent = std::as_const(to.world).FindAgent(id);
      if (agent->name() == name) return agent;
      names.push_back(agent->name());
    }
    const std::string_view near = Suggest(name, names);
    Warn("there is no agent '" + name + "' for this input from outside",
         near.empty() ? "" : "did you mean '" + std::string(near) + "'?");
    return nullptr;
  }

  void operator()(const KeyInput& in) const { to.scripts.HandleInput(script::KeyEvent(in.key, in.pressed)); }

  void operator()(const ButtonInput& in) const {
    script::InputEvent event = MouseEvent(in.x_px, in.y_px);
    event.button = in.button;
    event.pressed = in.pressed;
    to.scripts.HandleInput(event);
  }

  void operator()(const PointerInput& in) const {
    script::InputEvent event = MouseEvent(in.x_px, in.y_px);
    event.dx = in.dx_px;
    event.dy = in.dy_px;
    to.scripts.HandleInput(event);
  }

  void operator()(const WheelInput& in) const {
    script::InputEvent event = MouseEvent(in.x_px, in.y_px);
    event.wheel = in.notches;
    to.scripts.HandleInput(event);
  }

  void operator()(const PanelInput& in) const {
    if (to.scripts.PressButton(in.button)) return;
    const std::vector<std::string> buttons = to.world.ui().ButtonNames();
    const std::string_view near = Suggest(in.button, {buttons.begin(), buttons.end()});
    Warn("no script has put a button '" + in.button + "' on the screen",
         near.empty() ? "" : "did you mean '" + std::string(near) + "'?");
  }

  void operator()(const PadInput& in) const {
    script::InputEvent event;
    event.source = script::InputEvent::Source::kGamepad;
    event.pad = in.pad;
    if (IsPadButton(in.part)) {
      event.button = in.part;
      event.pressed = in.value != 0;
    } else {
      event.axis = in.part;
      event.value = in.value;
    }
    to.scripts.HandleInput(event);
  }

  void operator()(const ScreenInput& in) const { to.world.SetScreenSize(in.width_px, in.height_px); }

  void operator()(const CameraInput& in) const { to.world.camera().FollowViewer(in.position, in.orientation); }

  void operator()(const CommandInput& in) const {
    // Without an agent: lines of the log of a recorded client.
    if (in.agent.empty()) return to.client(in.line);
    to.answer(in, to.soar.Execute(in.agent, in.line, recorded));
  }

  void operator()(const ScriptInput& in) const {
    world::EntityId id = world::EntityId::kSandbox;
    if (!in.agent.empty()) {
      const world::Agent* agent = Find(in.agent);
      if (agent == nullptr) return;
      id = agent->id();
    }
    std::string answer;
    const auto error = to.scripts.RunText(id, in.text, &answer);
    if (error && script::ReadReload(in.text)) {
      to.warn(error->diagnostic);
    } else if (error) {
      to.answer({in.agent, in.text}, error->diagnostic);
    } else if (!answer.empty()) {
      to.answer({in.agent, in.text}, answer);
    }
  }

  void operator()(const OrderInput& in) const {
    const world::Agent* agent = Find(in.agent);
    if (agent == nullptr) return;
    to.scripts.AddOrder(agent->id(), in.order);
    to.order(agent->id(), in.order);
  }

  void operator()(const ForeignBodyInput& in) const { to.foreign.Apply(in, to.kinds); }
  void operator()(const ForeignGoneInput& in) const { to.foreign.Apply(in); }
  void operator()(const ForeignShotInput& in) const { to.foreign.Apply(in); }
  void operator()(const ForeignMessageInput& in) const { to.foreign.Apply(in); }
};

}  // namespace

void ApplyInput(const Input& input, const InputTargets& targets) {
  std::visit(Applier{targets, input.recorded}, input.value);
}

}  // namespace soarbox::sim
