// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/finder.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <utility>

#include "viewer/panels/document_spans.h"
#include "viewer/panels/widgets.h"
#include "workbench/document/build.h"

namespace soarbox::viewer {
namespace {

constexpr std::size_t kMostShown = 60;

/// Whether the text contains each typed word.
bool Fits(const std::string& text, const std::string& typed) {
  std::istringstream words(typed);
  for (std::string word; words >> word;)
    if (!HasPart(text, word)) return false;
  return true;
}

std::string NameOf(const std::string& file) {
  return std::filesystem::path(file).filename().string();
}

const char* KindName(workbench::FoundPlace::Kind kind) {
  switch (kind) {
    case workbench::FoundPlace::Kind::kRule:
      return "rule text";
    case workbench::FoundPlace::Kind::kFile:
      return "file text";
    case workbench::FoundPlace::Kind::kMemory:
      return "memory";
    case workbench::FoundPlace::Kind::kTrace:
      return "trace";
    case workbench::FoundPlace::Kind::kMessage:
      return "message";
  }
  return "";
}

const char* HintOf(Finder::For what) {
  switch (what) {
    case Finder::For::kAnything:
      return "A command, a panel, an agent, a rule, a file, or any text";
    case Finder::For::kScenario:
      return "A scenario, or the path of a folder, a .toml, .lua or .soar file";
    case Finder::For::kRecording:
      return "A recording, or its path";
  }
  return "";
}

}  // namespace

void Finder::Open(For what) {
  for_ = what;
  is_open_ = wants_focus_ = true;
  wants_close_ = false;
  text_.clear();
  asked_.reset();
  at_ = 0;
}

void Finder::Leave(PanelFrame& frame) {
  is_open_ = wants_close_ = false;
  frame.Ask(workbench::SearchRequest{});
  frame.Ask(workbench::OfferRequest{false});
}

void Finder::AddPlaces(PanelFrame& frame, std::vector<Item>& items) const {
  using Kind = workbench::FoundPlace::Kind;
  using workbench::PanelId;
  if (frame.contents.searched != text_) return;
  for (const workbench::FoundPlace& place : frame.contents.places) {
    workbench::document::Action action{workbench::SeekRequest{place.tick}, PanelId::kMessages};
    if (place.kind == Kind::kTrace) action.panel = PanelId::kTrace;
    if (place.kind == Kind::kMemory) action = {workbench::ObjectRequest{place.id, true}, PanelId::kMemory};
    if (place.kind == Kind::kRule || place.kind == Kind::kFile)
      action = *workbench::document::FileLink(frame.contents, place.file, place.line, {}).action;
    items.push_back({KindName(place.kind), place.title, place.detail, [&frame, action] { Press(frame, action); }});
  }
}

void Finder::AddAnything(PanelFrame& frame, const std::vector<Action>& more, std::vector<Item>& items) const {
  const auto add = [&](const char* kind, std::string title, std::string detail, std::function<void()> act) {
    if (Fits(title + " " + kind, text_)) items.push_back({kind, std::move(title), std::move(detail), std::move(act)});
  };
  for (const world::AgentSnapshot& agent : frame.scene.agents)
    add("agent", agent.name, agent.team, [&frame, id = agent.id] { frame.selected = id; });
  for (const workbench::PanelInfo& info : workbench::kPanelInfos)
    add("panel", std::string(info.title), std::string(info.about), [&frame, id = info.id] { frame.layout.Show(id); });
  for (const CommandInfo& info : Commands())
    add("command", std::string(info.title), std::string(info.keys),
        [&frame, command = info.command] { frame.Command(command); });
  for (const Action& action : more) {
    if (action.title.empty()) continue;
    add("command", action.menu + ": " + action.title, action.keys.empty() ? action.about : action.keys, action.act);
  }
  for (const explain::RuleFact& rule : frame.contents.rules) {
    add("rule", rule.name, rule.file.empty() ? rule.type : NameOf(rule.file) + ":" + std::to_string(rule.line),
        [&frame, name = rule.name] { frame.AskIn(workbench::PanelId::kRules, workbench::RuleRequest{name}); });
  }
  for (const std::string& file : frame.contents.all_files)
    add("file", NameOf(file), file,
        [&frame, action = *workbench::document::FileLink(frame.contents, file, 1, {}).action] {
          Press(frame, action);
        });
  for (const workbench::ScenarioOffer& offer : frame.contents.scenarios)
    add("scenario", offer.name, offer.about,
        [&frame, name = offer.name] { frame.Ask(workbench::OpenRunRequest{name}); });
}

void Finder::AddOffers(PanelFrame& frame, std::vector<Item>& items) const {
  const bool recordings = for_ == For::kRecording;
  const auto is_recording = [](const std::string& name) { return name.ends_with(".soarrec"); };
  const auto open = [&frame](const std::string& what) {
    return [&frame, what] { frame.Ask(workbench::OpenRunRequest{what}); };
  };
  for (const std::string& recent : frame.contents.recent) {
    if (is_recording(recent) == recordings && Fits(recent, text_))
      items.push_back({"recent", recent, "", open(recent)});
  }
  for (const workbench::ScenarioOffer& offer : frame.contents.scenarios) {
    if (is_recording(offer.name) == recordings && Fits(offer.name + " " + offer.about, text_))
      items.push_back({recordings ? "recording" : "scenario", offer.name, offer.about, open(offer.name)});
  }
  // A path that is not in the list.
  if (!text_.empty()) items.push_back({"path", text_, "open this path", open(text_)});
}

std::vector<Finder::Item> Finder::Items(PanelFrame& frame, const std::vector<Action>& more) const {
  std::vector<Item> items;
  if (for_ == For::kAnything) {
    AddAnything(frame, more, items);
    AddPlaces(frame, items);
  } else {
    AddOffers(frame, items);
  }
  return items;
}

void Finder::Draw(PanelFrame& frame, float width, float height, const std::vector<Action>& more) {
  if (!is_open_) return;
  if (wants_close_) return Leave(frame);
  if (asked_ != text_) {
    asked_ = text_;
    at_ = 0;
    frame.Ask(workbench::OfferRequest{true});
    frame.Ask(workbench::SearchRequest{text_});
  }
  const float wide = std::min(frame.Px(640), width - 20), high = std::min(frame.Px(420), height - 40);
  ImGui::SetNextWindowPos({(width - wide) / 2, std::min(frame.Px(70), height * 0.1f)});
  ImGui::SetNextWindowSize({wide, high});
  ImGui::SetNextWindowFocus();
  BeginOver("Find", nullptr, ImGuiWindowFlags_NoTitleBar);
  if (std::exchange(wants_focus_, false)) FocusNextField();
  SearchField("##find", HintOf(for_), text_);
  const bool entered = WasEntered();
  const std::vector<Item> items = Items(frame, more);
  const std::size_t count = std::min(items.size(), kMostShown);
  const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
  if (pressed(ImGuiKey_DownArrow) && at_ + 1 < count) ++at_;
  if (pressed(ImGuiKey_UpArrow) && at_ > 0) --at_;
  if (count > 0) at_ = std::min(at_, count - 1);
  {
    const Part rows("rows");
    if (items.empty()) EmptyNote("Nothing matches.", "Type less, or another part of the name.");
    DrawRows(frame, items, entered);
  }
  ImGui::End();
}

void Finder::DrawRows(PanelFrame& frame, const std::vector<Item>& items, bool entered) {
  std::size_t chosen = entered ? at_ : items.size();
  const float kind_width = ImGui::CalcTextSize("recording  ").x;
  for (std::size_t i = 0; i < std::min(items.size(), kMostShown); ++i) {
    const Item& item = items[i];
    const IdScope id(static_cast<int>(i));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##row", i == at_)) chosen = i;
    if (i == at_ && !ImGui::IsItemVisible()) ImGui::SetScrollHereY(0.5f);
    ImGui::SetCursorScreenPos(at);
    ColoredText(theme::kQuiet, item.kind);
    ImGui::SameLine(kind_width);
    const float room = ImGui::GetContentRegionAvail().x;
    CutText(item.title, item.detail.empty() ? room : room * 0.6f);
    if (!item.detail.empty()) {
      ImGui::SameLine(kind_width + room * 0.62f);
      CutText(item.detail, theme::kQuiet);
    }
  }
  if (items.size() > kMostShown)
    ColoredText(theme::kQuiet, std::to_string(items.size() - kMostShown) + " more: type more of the name");
  if (chosen >= items.size()) return;
  const std::function<void()> act = items[chosen].act;
  Leave(frame);
  act();
}

}  // namespace soarbox::viewer
