// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/ui_script.h"

#include <SDL.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <string_view>

namespace soarbox::viewer {
namespace {

/// Minimum number of frames that a step waits for its text. It also waits for kLeastWait, because fast windows draw
/// hundreds of frames per second.
constexpr int kMostWait = 400;
constexpr std::chrono::seconds kLeastWait{8};
/// Frames between a step and the next, so that the window can react.
constexpr int kSettle = 2;

constexpr std::array<std::string_view, 16> kWords{
    "click", "click-agent", "double-click", "right-click", "hover", "click-at", "drag",  "type",
    "key",   "expect",      "expect-not",   "wait",        "until", "picture",  "audit", "measure"};

void Push(SDL_Event event) {
  SDL_PushEvent(&event);
}

void MoveTo(ImVec2 at) {
  SDL_Event event{};
  event.type = SDL_MOUSEMOTION;
  event.motion.x = static_cast<int>(at.x);
  event.motion.y = static_cast<int>(at.y);
  Push(event);
}

void PressButton(ImVec2 at, int button, bool pressed) {
  SDL_Event event{};
  event.type = pressed ? SDL_MOUSEBUTTONDOWN : SDL_MOUSEBUTTONUP;
  event.button.button = static_cast<Uint8>(button);
  event.button.x = static_cast<int>(at.x);
  event.button.y = static_cast<int>(at.y);
  Push(event);
}

void Click(ImVec2 at, int button) {
  MoveTo(at);
  PressButton(at, button, true);
  PressButton(at, button, false);
}

void PressKey(SDL_Scancode code, int modifiers) {
  for (const std::uint32_t type : {SDL_KEYDOWN, SDL_KEYUP}) {
    SDL_Event event{};
    event.type = type;
    event.key.keysym.scancode = code;
    // Modifiers are released together with the key.
    event.key.keysym.mod = static_cast<Uint16>(type == SDL_KEYDOWN ? modifiers : 0);
    Push(event);
  }
}

void Type(std::string_view text) {
  while (!text.empty()) {
    // As much as an event can contain, without cutting a character.
    std::size_t length = std::min<std::size_t>(text.size(), SDL_TEXTINPUTEVENT_TEXT_SIZE - 1);
    while (length < text.size() && length > 1 && (static_cast<unsigned char>(text[length]) & 0xc0) == 0x80) --length;
    SDL_Event event{};
    event.type = SDL_TEXTINPUT;
    std::copy_n(text.data(), length, event.text.text);
    Push(event);
    text.remove_prefix(length);
  }
}

/// Converts "Ctrl+Shift+R" to a key and its modifiers.
bool ReadKey(const std::string& name, SDL_Scancode& code, int& modifiers) {
  std::string_view rest = name;
  modifiers = 0;
  for (const auto& [word, bit] :
       {std::pair<std::string_view, int>{"Ctrl+", KMOD_LCTRL}, {"Shift+", KMOD_LSHIFT}, {"Alt+", KMOD_LALT}}) {
    if (rest.substr(0, word.size()) != word) continue;
    rest.remove_prefix(word.size());
    modifiers |= bit;
  }
  code = SDL_GetScancodeFromName(std::string(rest).c_str());
  return code != SDL_SCANCODE_UNKNOWN;
}

}  // namespace

Result<UiScript> UiScript::Load(const std::filesystem::path& file) {
  Diagnostic problem;
  problem.file = file.string();
  std::ifstream in(file);
  if (!in) {
    problem.message = "the script of the window cannot be read";
    return problem;
  }
  UiScript script;
  script.file_ = file.string();
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    std::istringstream words(line);
    Step step;
    step.line = number;
    if (!(words >> step.word) || step.word.front() == '#') continue;
    if (std::find(kWords.begin(), kWords.end(), step.word) == kWords.end()) {
      problem.line = number;
      problem.message = "the window's scripts have no '" + step.word + "'";
      const std::vector<std::string_view> candidates(kWords.begin(), kWords.end());
      if (const auto near = Suggest(step.word, candidates); !near.empty())
        problem.hint = "did you mean '" + std::string(near) + "'?";
      return problem;
    }
    for (std::string argument; words >> std::quoted(argument);) step.arguments.push_back(argument);
    if (step.arguments.empty()) {
      problem.line = number;
      problem.message = "'" + step.word + "' requires a text";
      return problem;
    }
    script.steps_.push_back(std::move(step));
  }
  return script;
}

void UiScript::Advance(const UiStage& stage) {
  if (is_over() || !stage.is_idle) return;
  if (settle_ > 0) {
    --settle_;
    return;
  }
  const Step& step = steps_[at_];
  const auto now = std::chrono::steady_clock::now();
  if (waited_ == 0) waits_since_ = now;
  // For long operations such as grading, the script may specify a time in seconds after the text.
  std::chrono::duration<double> patience = kLeastWait;
  if (step.word.starts_with("expect") && step.arguments.size() > 1)
    patience = std::chrono::duration<double>(std::atof(step.arguments[1].c_str()));
  if (Do(step, stage)) {
    ++at_;
    waited_ = 0;
    settle_ = kSettle;
  } else if (!failure_ && ++waited_ > kMostWait && now - waits_since_ > patience) {
    Fail(step, "'" + step.word + " \"" + step.arguments[0] + "\"' timed out", stage);
  }
}

bool UiScript::Do(const Step& step, const UiStage& stage) {
  const std::string& what = step.arguments[0];
  if (step.word == "expect") return FindText(stage.shown, what).run != nullptr;
  if (step.word == "expect-not") return FindText(stage.shown, what).run == nullptr;
  if (step.word == "wait") return waited_ >= std::min(std::atoi(what.c_str()), kMostWait);
  if (step.word == "until") {
    waited_ = 0;  // The world may take its time.
    return stage.time_s >= std::atof(what.c_str());
  }
  if (step.word == "type") {
    Type(what);
    return true;
  }
  if (step.word == "key") {
    SDL_Scancode code{};
    int modifiers = 0;
    if (!ReadKey(what, code, modifiers)) {
      Fail(step, "there is no key '" + what + "'", stage);
      return false;
    }
    PressKey(code, modifiers);
    return true;
  }
  if (step.word == "picture") {
    if (const Result<void> saved = stage.save_picture(what); !saved) Fail(step, saved.error().message, stage);
    return true;
  }
  if (step.word == "audit") {
    std::string complaints;
    for (const std::string& complaint : stage.audit()) complaints += "\n     " + complaint;
    if (!complaints.empty()) Fail(step, what + " does not look as it should:" + complaints, stage);
    return true;
  }
  if (step.word == "measure") {
    stage.measure(what);
    return true;
  }
  return DoMouse(step, stage);
}

bool UiScript::DoMouse(const Step& step, const UiStage& stage) {
  const auto number = [&](std::size_t i) {
    return i < step.arguments.size() ? static_cast<float>(std::atof(step.arguments[i].c_str())) : 0.0f;
  };
  if (step.word == "drag") {
    const ImVec2 from{number(0), number(1)}, to{number(2), number(3)};
    MoveTo(from);
    PressButton(from, SDL_BUTTON_LEFT, true);
    MoveTo({(from.x + to.x) / 2, (from.y + to.y) / 2});
    MoveTo(to);
    PressButton(to, SDL_BUTTON_LEFT, false);
    return true;
  }
  if (step.word == "click-at") {
    Click({number(0), number(1)}, SDL_BUTTON_LEFT);
    return true;
  }
  if (step.word == "click-agent") return ClickAgent(step.arguments[0], stage);
  ImVec2 at;
  {
    const int which = step.arguments.size() > 1 ? std::max(1, std::atoi(step.arguments[1].c_str())) : 1;
    const TextPlace place = FindText(stage.shown, step.arguments[0], which);
    if (place.run == nullptr) return false;
    at = place.run->MiddleOf(place.first, step.arguments[0].size());
  }
  if (step.word == "hover") {
    MoveTo(at);
  } else {
    Click(at, step.word == "right-click" ? SDL_BUTTON_RIGHT : SDL_BUTTON_LEFT);
    if (step.word == "double-click") Click(at, SDL_BUTTON_LEFT);
  }
  return true;
}

bool UiScript::ClickAgent(const std::string& agent, const UiStage& stage) {
  constexpr int kPatience = 8;  // Frames until the effect of the click must be visible.
  if (clicked_ && stage.selected == agent) {
    clicked_ = false;
    return true;
  }
  if (waited_ % kPatience != 0) return false;
  const auto place = stage.place_of(agent);
  if (!place) return false;
  Click(*place, SDL_BUTTON_LEFT);
  clicked_ = true;
  return false;
}

void UiScript::Fail(const Step& step, std::string message, const UiStage& stage) {
  Diagnostic problem;
  problem.file = file_;
  problem.line = step.line;
  problem.message = std::move(message);
  problem.hint = "at " + std::to_string(stage.time_s) + " s the window shows:";
  for (const ShownText& run : stage.shown) problem.hint += "\n     " + run.text;
  failure_ = std::move(problem);
}

}  // namespace soarbox::viewer
