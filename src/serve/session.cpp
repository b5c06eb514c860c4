// SPDX-License-Identifier: BSD-2-Clause
#include "serve/session.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "diagnostics/json_text.h"
#include "diagnostics/problem.h"

namespace soarbox::serve {
namespace {

using Json = nlohmann::ordered_json;

Bytes Shared(std::string text) {
  return std::make_shared<const std::string>(std::move(text));
}

/// The last line that says what was wrong.
std::string LastError(const std::string& words) {
  std::string last;
  for (std::size_t at = 0; at < words.size();) {
    const std::size_t end = std::min(words.find('\n', at), words.size());
    const std::string line = words.substr(at, end - at);
    if (const std::size_t error = line.find("error: "); error != std::string::npos) last = line.substr(error + 7);
    at = end + 1;
  }
  return last;
}

}  // namespace

std::string ErrorMessage(const Diagnostic& problem, const std::string& id) {
  Json message{{"message", "error"}, {"error", problem.message}, {"hint", problem.hint}};
  if (!id.empty()) message["id"] = Json::parse(id, nullptr, false);
  return JsonText(message);
}

Session::Session(boost::asio::io_context& io, const Settings& settings, Place place)
    : io_(io), settings_(settings), place_(std::move(place)), looked_at_(Clock::now()), busy_timer_(io) {}

Session::~Session() {
  if (engine_ != nullptr) engine_->End();
}

Result<void> Session::Open(const std::string& what) {
  const std::vector<std::string> words = settings_.engine(what, place_);
  if (words.empty())
    return NewProblem("there is nothing called '" + what + "' to open", "the first page lists what there is");
  if (!lock_) {
    Result<PlaceLock> lock = PlaceLock::Take(place_.root());
    if (!lock) return lock.error();
    lock_ = std::move(*lock);
  }
  if (engine_ != nullptr) engine_->End();
  engine_.reset();
  hello_ = watcher_hello_ = flow_ = nullptr;
  contents_.clear();
  blocks_.clear();
  const std::weak_ptr<int> alive = alive_;
  EngineProcess::Hooks hooks;
  hooks.on_frame = [this, alive](Frame frame) {
    if (!alive.expired()) OnFrame(std::move(frame));
  };
  hooks.on_end = [this, alive](const std::string& last_words, bool is_good) {
    if (!alive.expired()) OnEnd(last_words, is_good);
  };
  Result<std::shared_ptr<EngineProcess>> engine =
      EngineProcess::Start(io_, words, place_, settings_.limits, std::move(hooks));
  if (!engine) {
    lock_.reset();
    return engine.error();
  }
  engine_ = std::move(*engine);
  what_ = what;
  began_ = looked_at_ = Clock::now();
  TellPresence();
  return {};
}

void Session::Join(Viewer& viewer) {
  viewers_.push_back(&viewer);
  looked_at_ = Clock::now();
  if (engine_ == nullptr) return viewer.SendText(Shared(R"({"message":"none"})"), {});
  if (hello_ != nullptr) viewer.SendText(viewer.MayAsk() ? hello_ : watcher_hello_, "hello");
  if (flow_ != nullptr) viewer.SendText(flow_, "flow");
  for (const auto& [name, text] : contents_) viewer.SendText(text, name);
  for (const auto& [block, is_full] : blocks_) viewer.SendScene(block, is_full);
  TellPresence();
}

void Session::Leave(Viewer& viewer) {
  std::erase(viewers_, &viewer);
  watched_.erase(&viewer);
  looked_at_ = Clock::now();
  TellPresence();
}

void Session::TellPresence() {
  if (engine_ == nullptr) return;
  std::set<std::string> watched;
  for (const auto& [viewer, panels] : watched_) watched.insert(panels.begin(), panels.end());
  engine_->Send(JsonText(Json{{"request", "presence"}, {"pages", viewers_.size()}, {"watched", watched}}));
}

void Session::Take(Viewer& viewer, std::string text) {
  const Json json = Json::parse(text, nullptr, false);
  const auto refuse = [&](const Diagnostic& problem) {
    const auto id = json.is_object() ? json.find("id") : json.end();
    viewer.SendText(
        Shared(ErrorMessage(problem, json.is_object() && id != json.end() && id->is_primitive() ? JsonText(*id) : "")),
        {});
  };
  const auto request = json.is_object() ? json.find("request") : json.end();
  if (!json.is_object() || request == json.end() || !request->is_string())
    return refuse(
        NewProblem("this is no request", "a request is a JSON object with the field `request` (docs/serve.md)"));
  if (!viewer.MayAsk() && *request == "look") {
    const Result<void> watched = Watch(viewer, text);
    if (!watched) refuse(watched.error());
    return;
  }
  if (!viewer.MayAsk()) return refuse(NewProblem("you only watch this run", "the person whose run it is can do this"));
  if (*request == "presence") return refuse(NewProblem("the server itself says who is present"));
  if (*request == "open") {
    const auto what = json.find("what");
    const Result<void> opened = Open(what != json.end() && what->is_string() ? what->get<std::string>() : "");
    if (!opened) refuse(opened.error());
    return;
  }
  if (engine_ == nullptr) return refuse(NewProblem("there is no run", "open one first"));
  engine_->Send(std::move(text));
  AwaitAnswer();
}

Result<void> Session::Watch(const Viewer& viewer, const std::string& text) {
  constexpr std::size_t kMostPanels = 64, kMostBytes = 40;
  const Json json = Json::parse(text, nullptr, false);
  const auto panels = json.find("panels");
  std::vector<std::string> words;
  bool is_good = panels != json.end() && panels->is_array() && panels->size() <= kMostPanels;
  if (is_good)
    for (const Json& panel : *panels) {
      is_good &= panel.is_string() && panel.get_ref<const std::string&>().size() <= kMostBytes;
      if (is_good) words.push_back(panel.get<std::string>());
    }
  if (!is_good) return NewProblem("look needs panels", "a list of words of panels (docs/workbench.md)");
  watched_[&viewer] = std::move(words);
  TellPresence();
  return {};
}

void Session::AwaitAnswer() {
  if (std::exchange(awaits_, true)) return;
  constexpr auto kPatience = std::chrono::milliseconds(200);
  busy_timer_.expires_after(kPatience);
  busy_timer_.async_wait([this, alive = std::weak_ptr<int>(alive_)](boost::system::error_code error) {
    if (error || alive.expired() || !awaits_) return;
    is_busy_ = true;
    Tell(R"({"message":"busy"})");
  });
}

void Session::NoLongerBusy() {
  awaits_ = false;
  busy_timer_.cancel();
  if (std::exchange(is_busy_, false)) Tell(R"({"message":"ready"})");
}

void Session::Tell(const std::string& text, const std::string& key) {
  const Bytes shared = Shared(text);
  for (Viewer* viewer : std::vector<Viewer*>(viewers_)) viewer->SendText(shared, key);
}

void Session::OnFrame(Frame frame) {
  // Whatever it says, it answers: not every request ends with "done".
  NoLongerBusy();
  switch (frame.kind) {
    case FrameKind::kDone:
      return;
    case FrameKind::kText:
      return Tell(frame.bytes);
    case FrameKind::kHello: {
      // It does not know by what name it was asked for.
      Json hello = Json::parse(frame.bytes, nullptr, false);
      if (!hello.is_object()) return;
      hello["what"] = what_;
      hello_ = Shared(JsonText(hello));
      hello["may_edit"] = false;
      watcher_hello_ = Shared(JsonText(hello));
      flow_ = nullptr;
      contents_.clear();
      blocks_.clear();
      for (Viewer* viewer : std::vector<Viewer*>(viewers_))
        viewer->SendText(viewer->MayAsk() ? hello_ : watcher_hello_, "hello");
      return;
    }
    case FrameKind::kFlow:
      flow_ = Shared(std::move(frame.bytes));
      return Tell(*flow_, "flow");
    case FrameKind::kContents: {
      const std::size_t end = frame.bytes.find('\0');
      if (end == std::string::npos) return;
      const std::string name = frame.bytes.substr(0, end);
      std::string text = R"({"message":"contents","contents":{")" + name + "\":";
      text.append(frame.bytes, end + 1).append("}}");
      const Bytes shared = contents_[name] = Shared(std::move(text));
      for (Viewer* viewer : std::vector<Viewer*>(viewers_)) viewer->SendText(shared, name);
      return;
    }
    case FrameKind::kFull:
      blocks_.clear();
      [[fallthrough]];
    case FrameKind::kScene: {
      const bool is_full = frame.kind == FrameKind::kFull;
      blocks_.emplace_back(Shared(std::move(frame.bytes)), is_full);
      const Bytes block = blocks_.back().first;
      for (Viewer* viewer : std::vector<Viewer*>(viewers_)) viewer->SendScene(block, is_full);
      return;
    }
  }
}

void Session::OnEnd(const std::string& last_words, bool is_good) {
  engine_.reset();
  lock_.reset();
  std::string why = LastError(last_words);
  if (why.empty())
    why = is_good ? "The run has ended." : "The run has crashed. What you typed and the recording are kept.";
  NoLongerBusy();
  Tell(JsonText(Json{{"message", "ended"}, {"text", why}, {"can_open_again", true}}));
}

void Session::EndIfIdle() {
  if (engine_ == nullptr) return;
  const auto now = Clock::now();
  if (viewers_.empty() && now - looked_at_ > std::chrono::minutes(settings_.limits.idle_min))
    End("Nobody looked at this run for " + std::to_string(settings_.limits.idle_min) + " minutes: it has ended.");
  else if (now - began_ > std::chrono::hours(settings_.limits.run_hours))
    End("This run has lasted " + std::to_string(settings_.limits.run_hours) +
        " hours, the longest that this server allows.");
}

void Session::End(const std::string& why) {
  if (engine_ == nullptr) return;
  engine_->End();
  engine_.reset();
  lock_.reset();
  NoLongerBusy();
  Tell(JsonText(Json{{"message", "ended"}, {"text", why}, {"can_open_again", true}}));
}

}  // namespace soarbox::serve
