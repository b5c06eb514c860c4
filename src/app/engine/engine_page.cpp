// SPDX-License-Identifier: BSD-2-Clause
#include "app/engine/engine_page.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "diagnostics/json_text.h"
#include "diagnostics/plain_text.h"
#include "diagnostics/problem.h"
#include "sim/input_names.h"
#include "workbench/contents_json.h"
#include "workbench/flow_info.h"
#include "workbench/requests_json.h"

namespace soarbox::app {
namespace {

using workbench::Flow;
using Json = EnginePage::Json;

std::string TextOf(const Json& json) {
  return JsonText(json);
}

std::string TextOf(const Json& json, const char* field) {
  const auto found = json.find(field);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// The number of a field, limited to +-1e6; 0 if it is not a finite number.
float FieldNumber(const Json& json, const char* field) {
  const auto found = json.find(field);
  if (found == json.end() || !found->is_number()) return 0;
  const auto number = found->get<double>();
  return std::isfinite(number) ? static_cast<float>(std::clamp(number, -1e6, 1e6)) : 0.0f;
}

bool FlagOf(const Json& json, const char* field) {
  const auto found = json.find(field);
  return found != json.end() && found->is_boolean() && found->get<bool>();
}

/// Converts a page's input to an input of the simulation: a key, a button, the pointer, the wheel, a panel of a script,
/// a gamepad or the size of the screen. Returns nothing for other kinds.
std::optional<sim::InputValue> InputOf(const Json& json) {
  const std::string kind = TextOf(json, "kind"), text = TextOf(json, "name"), name(Beginning(text, 40));
  const float x = FieldNumber(json, "x"), y = FieldNumber(json, "y");
  if (kind == "key") return sim::KeyInput{name, FlagOf(json, "pressed")};
  if (kind == "button") return sim::ButtonInput{name, FlagOf(json, "pressed"), x, y};
  if (kind == "pointer") return sim::PointerInput{x, y, FieldNumber(json, "dx"), FieldNumber(json, "dy")};
  if (kind == "panel") return sim::PanelInput{std::string(Beginning(text, 100))};
  if (kind == "pad") {
    const auto pad = static_cast<int>(FieldNumber(json, "pad"));
    const bool is_known =
        pad >= 1 && pad <= sim::kMostPads && std::binary_search(sim::PadNames().begin(), sim::PadNames().end(), name);
    if (!is_known) return std::nullopt;
    const float value = std::clamp(FieldNumber(json, "value"), -1.0f, 1.0f);
    return sim::PadInput{pad, name, sim::IsPadButton(name) ? (value >= 0.5f ? 1.0f : 0.0f) : value};
  }
  if (kind == "wheel") return sim::WheelInput{FieldNumber(json, "notches"), x, y};
  if (kind == "screen") {
    const auto pixels = [&](const char* field) {
      return std::clamp(static_cast<int>(FieldNumber(json, field)), 160, 7680);
    };
    return sim::ScreenInput{pixels("width"), pixels("height")};
  }
  return std::nullopt;
}

}  // namespace

void EnginePage::ShowLife() {
  const auto now = Clock::now();
  if (now - life_at_ < std::chrono::milliseconds(400)) return;
  life_at_ = now;
  channel_.Send(serve::FrameKind::kAlive, {});
}

void EnginePage::Receive(int most_ms, Asked& asked) {
  for (const std::string& text : channel_.Receive(most_ms)) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) {
      Refuse(NewProblem("this is not a request", "a request is a JSON object (docs/serve_protocol.md)"));
      continue;
    }
    const Result<void> taken = Take(json, asked);
    if (!taken) Refuse(taken.error(), json.value("id", Json()));
  }
  if (asked.empty() && language_ != nullptr) SayOfLanguage(language_->Idle());
}

Result<void> EnginePage::Take(const Json& json, Asked& asked) {
  const std::string request = TextOf(json, "request");
  if (request == "presence" && json.contains("draws")) {
    // From a program that started this engine without a server, such as Python.
    draws_ = FlagOf(json, "draws");
    return {};
  }
  if (request == "presence") {
    // From the server: the number of pages, how many of them may control the run (if it does not say: all), and the
    // panels of users who may only watch. Pages draw documents.
    shows_documents_ = true;
    const auto count = [&](const char* field) { return std::max(0, static_cast<int>(FieldNumber(json, field))); };
    presence_ = {};
    presence_.pages = count("pages");
    presence_.controlling = json.contains("controlling") ? count("controlling") : presence_.pages;
    for (const Json& word : json.value("watched", Json::array()))
      if (const auto panel = word.is_string() ? workbench::FindPanel(word.get<std::string>()) : std::nullopt)
        presence_.watched.Add(*panel);
    return {};
  }
  if (request == "scene") {
    wants_full_ = true;
    return {};
  }
  if (request == "flow") {
    const std::string what = TextOf(json, "what");
    if (what == "pause" || what == "go-on") {
      asked.pause = what == "pause";
      return {};
    }
    const workbench::FlowInfo* const found = workbench::FindFlow(what);
    if (found == nullptr) {
      std::string words = "pause, go-on";
      for (const workbench::FlowInfo& info : workbench::kFlowInfos)
        if (workbench::IsRequest(info.flow)) words += ", " + std::string(info.word);
      return NewProblem("flow knows no '" + what + "'", "it is one of " + words);
    }
    if (found->flow == Flow::kReset)
      if (const auto seed = json.find("seed"); seed != json.end()) {
        if (!seed->is_number_unsigned()) return NewProblem("a seed is a whole number from 0");
        asked.seed = seed->get<std::uint64_t>();
      }
    asked.flows.push_back(found->flow);
    return {};
  }
  if (request == "overlays") {
    const auto on = json.find("on");
    const auto has = [&](std::string_view word) {
      return on != json.end() && on->is_array() &&
             std::ranges::any_of(*on, [&](const Json& each) { return each == word; });
    };
    const world::OverlayWants wanted{has("navigation"), has("influence"), has("physics"), has("forces")};
    // Sends the scene again with the new overlays, even if the world is paused.
    wants_full_ |= wanted != overlay_wants_;
    overlay_wants_ = wanted;
    return {};
  }
  if (request == "language") {
    const auto message = json.find("message");
    if (message == json.end() || !message->is_object())
      return NewProblem("language needs a message", "write it as an object, in the Language Server Protocol");
    if (language_ == nullptr) return NewProblem("this server has no help with rules");
    SayOfLanguage(language_->Handle(*message));
    return {};
  }
  if (request == "input") {
    const std::optional<sim::InputValue> input = InputOf(json);
    if (!input)
      return NewProblem("input knows no such kind", "it is one of key, button, pointer, wheel, screen, panel, pad");
    asked.inputs.push_back(*input);
    return {};
  }
  Result<workbench::Request> read = workbench::ReadRequest(json);
  if (!read) return read.error();
  asked.requests.push_back(std::move(*read));
  return {};
}

void EnginePage::SayOfLanguage(const std::vector<std::string>& messages) {
  for (const std::string& message : messages)
    channel_.Send(serve::FrameKind::kText, R"({"message":"language","content":)" + message + "}");
}

void EnginePage::Say(const Json& message, serve::FrameKind kind) {
  channel_.Send(kind, TextOf(message));
}

void EnginePage::Hello(Json about) {
  Json message{{"message", "hello"}};
  message.update(about);
  Say(message, serve::FrameKind::kHello);
  told_.clear();
  shapes_ = {};
  flow_.clear();
  wants_full_ = true;
}

void EnginePage::Refuse(const Diagnostic& problem, const Json& id) {
  Json message{{"message", "error"}};
  if (id.is_primitive() && !id.is_null()) message["id"] = id;
  message["error"] = problem.message;
  message["hint"] = problem.hint;
  Say(message);
}

void EnginePage::ShowFlow(const workbench::Pace& pace, std::uint64_t tick, double time_s, bool is_stopped) {
  Json flow{{"message", "flow"}, {"paused", pace.paused() || is_stopped}};
  if (is_stopped) flow["stopped"] = true;
  // JSON has no infinity.
  flow["speed"] = std::isfinite(pace.speed()) ? Json(pace.speed()) : Json("unlimited");
  const std::string state = flow.dump();
  const auto now = Clock::now();
  if (state == flow_ && now - flow_at_ < std::chrono::milliseconds(250)) return;
  flow_ = state;
  flow_at_ = now;
  flow["tick"] = tick;
  flow["time_s"] = time_s;
  Say(flow, serve::FrameKind::kFlow);
}

void EnginePage::ShowContents(const workbench::Contents& contents, const workbench::PanelSet& panels) {
  for (const std::string_view name : workbench::ContentNames(panels, contents)) {
    const std::string content =
        TextOf(shows_documents_ ? workbench::PageJson(contents, name) : workbench::ToJson(contents, name));
    const std::size_t hash = std::hash<std::string>{}(content);
    const auto [told, is_new] = told_.try_emplace(std::string(name), hash);
    if (!is_new && std::exchange(told->second, hash) == hash) continue;
    channel_.Send(serve::FrameKind::kContents, std::string(name) + '\0' + content);
  }
}

bool EnginePage::WantsScene(std::size_t agents) const {
  const auto every = std::chrono::milliseconds(agents <= 20 ? 30 : agents <= 100 ? 60 : 100);
  return draws_ && (wants_full_ || Clock::now() - scene_at_ >= every);
}

void EnginePage::ShowScene(const world::SceneSnapshot& scene, const world::OverlaySnapshot* overlays) {
  scene_at_ = Clock::now();
  for (const ShapeContents::Told& told : shapes_.New(scene))
    channel_.Send(serve::FrameKind::kContents, told.name + '\0' + TextOf(told.content));
  const stream::Block block = encoder_.Encode(scene, overlays, wants_full_);
  wants_full_ = !channel_.SendScene(block.bytes, block.is_full);
}

}  // namespace soarbox::app
