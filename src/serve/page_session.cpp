// SPDX-License-Identifier: BSD-2-Clause
#include "serve/page_session.h"

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

}  // namespace

std::string ErrorMessage(const Diagnostic& problem, const std::string& id) {
  Json message{{"message", "error"}, {"error", problem.message}, {"hint", problem.hint}};
  if (!id.empty()) message["id"] = Json::parse(id, nullptr, false);
  return JsonText(message);
}

Session::Session(boost::asio::io_context& io, Work& work, const Settings& settings, Place place, MayStart may_start)
    : io_(io),
      work_(work),
      settings_(settings),
      place_(std::move(place)),
      may_start_(std::move(may_start)),
      looked_at_(Clock::now()),
      busy_timer_(io),
      life_timer_(io),
      start_timer_(io) {}

Session::~Session() {
  if (engine_ != nullptr) engine_->End();
}

void Session::Open(const std::string& what, std::function<void(const Diagnostic&)> refuse) {
  wanted_ = Wanted{what, std::move(refuse)};
  if (phase_ == Phase::kRest) Advance();
}

void Session::Advance() {
  phase_ = Phase::kRest;
  if (!wanted_) return;
  phase_ = Phase::kAsking;
  const auto words = std::make_shared<std::vector<std::string>>();
  work_.Do(
      place_.id(),
      [this, self = shared_from_this(), words, what = wanted_->what] { *words = settings_.engine(what, place_); },
      [this, self = shared_from_this(), words, what = wanted_->what] {
        // Meanwhile the user has requested another world, or End was called.
        if (!wanted_ || wanted_->what != what) return Advance();
        Result<void> may = words->empty()       ? NewProblem("there is nothing called '" + what + "' to open",
                                                             "the first page lists what there is")
                           : engine_ == nullptr ? may_start_(*this)
                                                : Result<void>();
        if (may) return EndForNext(what, *words);
        const Wanted refused = *std::exchange(wanted_, std::nullopt);
        phase_ = Phase::kRest;
        if (engine_ == nullptr) lock_.reset();
        if (refused.refuse) refused.refuse(may.error());
      });
}

void Session::EndForNext(const std::string& what, const std::vector<std::string>& words) {
  if (engine_ == nullptr) return StartLater(what, words);
  phase_ = Phase::kEnding;
  Forget();
  const std::shared_ptr<EngineProcess> ending = std::exchange(engine_, nullptr);
  ending->End([this, alive = std::weak_ptr<int>(alive_), what, words] {
    if (!alive.expired()) StartLater(what, words);
  });
}

void Session::StartLater(const std::string& what, const std::vector<std::string>& words) {
  // A place starts at most two processes per second.
  constexpr auto kEvery = std::chrono::milliseconds(500);
  phase_ = Phase::kStarting;
  start_timer_.expires_at(std::max(Clock::now(), began_ + kEvery));
  start_timer_.async_wait([this, alive = std::weak_ptr<int>(alive_), what, words](boost::system::error_code error) {
    if (!error && !alive.expired()) StartNext(what, words);
  });
}

void Session::StartNext(const std::string& what, const std::vector<std::string>& words) {
  struct Started {
    std::optional<PlaceLock> lock;
    Result<EngineProcess::Spawned> process = NewProblem("not started");
  };
  if (!wanted_) lock_.reset();
  if (!wanted_ || wanted_->what != what) return Advance();
  const auto started = std::make_shared<Started>();
  began_ = Clock::now();
  work_.Do(
      place_.id(),
      [this, self = shared_from_this(), started, words, is_locked = lock_.has_value()] {
        if (!is_locked) {
          Result<PlaceLock> lock = PlaceLock::Take(place_.root());
          if (!lock) {
            started->process = lock.error();
            return;
          }
          started->lock = std::move(*lock);
        }
        started->process = EngineProcess::Spawn(words, place_, settings_.limits);
      },
      [this, self = shared_from_this(), started, what] {
        if (started->lock) lock_ = std::move(started->lock);
        if (started->process) return OnStarted(what, *started->process);
        lock_.reset();
        phase_ = Phase::kRest;
        if (!wanted_) return;
        const Wanted refused = *std::exchange(wanted_, std::nullopt);
        if (refused.refuse) refused.refuse(started->process.error());
      });
}

void Session::OnStarted(const std::string& what, const EngineProcess::Spawned& spawned) {
  const std::weak_ptr<int> alive = alive_;
  EngineProcess::Hooks hooks;
  hooks.on_frame = [this, alive](Frame frame) {
    if (!alive.expired()) OnFrame(std::move(frame));
  };
  hooks.on_end = [this, alive](EngineProcess::Ending ending) {
    if (!alive.expired()) OnEnd(ending);
  };
  engine_ = EngineProcess::Adopt(io_, spawned, std::move(hooks));
  phase_ = Phase::kRest;
  reason_.clear();
  what_ = what;
  began_ = looked_at_ = Clock::now();
  activity_.Begin(what, began_);
  silent_checks_ = 0;
  // Meanwhile another world was requested, or the run was ended before it had begun.
  if (!wanted_) return End("The run was ended before it had begun.");
  if (wanted_->what != what) return Advance();
  wanted_.reset();
  TellPresence();
  ListenForLife();
}

void Session::Forget() {
  hello_ = watcher_hello_ = flow_ = nullptr;
  contents_.clear();
  blocks_.clear();
}

void Session::Join(Viewer& viewer, const std::string& tab) {
  viewers_.push_back(&viewer);
  looked_at_ = Clock::now();
  if (viewer.MayAsk()) {
    tabs_[&viewer] = tab;
    // A tab that has lost its connection may reconnect before the server notices the loss. It may then continue to
    // edit.
    const bool is_back = editor_ != nullptr && !tab.empty() && tabs_[editor_] == tab;
    HandTextsTo(editor_ == nullptr || is_back ? &viewer : editor_);
    if (const std::string greeting = greeting_ ? greeting_() : ""; !greeting.empty())
      viewer.SendText(Shared(greeting), "class");
  }
  if (engine_ == nullptr) {
    if (!is_running()) viewer.SendText(Shared(R"({"message":"none"})"), {});
    return;
  }
  if (hello_ != nullptr) viewer.SendText(viewer.MayAsk() ? hello_ : watcher_hello_, "hello");
  if (flow_ != nullptr) viewer.SendText(flow_, "flow");
  for (const auto& [name, text] : contents_) viewer.SendText(text, name);
  for (const auto& [block, is_full] : blocks_) viewer.SendScene(block, is_full);
  TellPresence();
}

void Session::Greet() {
  const std::string greeting = greeting_ ? greeting_() : "";
  if (greeting.empty()) return;
  const Bytes shared = Shared(greeting);
  for (Viewer* viewer : std::vector<Viewer*>(viewers_))
    if (viewer->MayAsk()) viewer->SendText(shared, "class");
}

Activity::Standing Session::Standing() {
  const Clock::time_point now = Clock::now();
  if (engine_ == nullptr) return {};
  const auto find = [&](const char* name) {
    const auto found = contents_.find(name);
    return found == contents_.end() ? nullptr : found->second;
  };
  // Parses the contents only after they have changed, because this takes time.
  const std::array<Bytes, 3> told = {find("edit"), find("problems"), find("mission")};
  const auto text = [&](std::size_t i) { return told[i] == nullptr ? std::string() : *told[i]; };
  if (std::exchange(looked_, told) != told) activity_.Look(text(0), text(1), text(2), now);
  return activity_.At(now);
}

void Session::HandTextsTo(const Viewer* viewer) {
  editor_ = viewer;
  for (Viewer* each : std::vector<Viewer*>(viewers_))
    if (each->MayAsk())
      each->SendText(
          Shared(each == viewer ? R"({"message":"tabs","may_type":true})" : R"({"message":"tabs","may_type":false})"),
          "tabs");
}

void Session::Leave(Viewer& viewer) {
  std::erase(viewers_, &viewer);
  watched_.erase(&viewer);
  tabs_.erase(&viewer);
  looked_at_ = Clock::now();
  if (editor_ == &viewer) {
    editor_ = nullptr;
    const auto next = std::ranges::find_if(viewers_, [](const Viewer* each) { return each->MayAsk(); });
    if (next != viewers_.end()) HandTextsTo(*next);
  }
  TellPresence();
}

void Session::TellPresence() {
  if (engine_ == nullptr) return;
  std::set<std::string> watched;
  for (const auto& [viewer, panels] : watched_) watched.insert(panels.begin(), panels.end());
  const auto controlling = std::ranges::count_if(viewers_, [](const Viewer* viewer) { return viewer->MayAsk(); });
  engine_->Send(JsonText(
      Json{{"request", "presence"}, {"pages", viewers_.size()}, {"controlling", controlling}, {"watched", watched}}));
}

void Session::AskForScene() {
  if (engine_ != nullptr) engine_->Send(R"({"request":"scene"})");
}

void Session::Take(Viewer& viewer, std::string text) {
  const std::optional<PageMessage> message = ReadPageMessage(text);
  const auto refuse = [&](const Diagnostic& problem) {
    viewer.SendText(Shared(ErrorMessage(problem, message ? message->id : "")), {});
  };
  if (!message)
    return refuse(NewProblem("this is not a request",
                             "a request is a JSON object with the field `request`, at most 256 fields in an object and "
                             "20,000 values in all (docs/serve_protocol.md)"));
  const std::string& request = message->request;
  if (!viewer.MayAsk() && request == "look") {
    const Result<void> watched = Watch(viewer, *message);
    if (!watched) refuse(watched.error());
    return;
  }
  if (!viewer.MayAsk()) return refuse(NewProblem("you only watch this run", "the person whose run it is can do this"));
  activity_.NoteRequest(*message, Clock::now());
  if (request == "presence") return refuse(NewProblem("only the server says who is present"));
  if (request == "open") {
    // The page may be closed when the reply arrives.
    return Open(message->what, [this, who = &viewer, id = message->id](const Diagnostic& problem) {
      if (std::ranges::find(viewers_, who) != viewers_.end()) who->SendText(Shared(ErrorMessage(problem, id)), {});
    });
  }
  if (request == "take-over") return HandTextsTo(&viewer);
  if (engine_ == nullptr) {
    // A run is about to start and will send all its data. A request before that is ignored.
    if (is_running() || wanted_) return;
    return refuse(NewProblem("there is no run", "open one first"));
  }
  if (request == "edit-text" && editor_ != &viewer)
    return refuse(
        NewProblem("another tab edits the texts of this place", "choose Edit here, and that tab can only read"));
  engine_->Send(std::move(text));
  AwaitAnswer();
}

Result<void> Session::Watch(const Viewer& viewer, const PageMessage& message) {
  if (!message.panels) return NewProblem("look needs panels", "a list of words of panels (docs/workbench.md)");
  watched_[&viewer] = *message.panels;
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

void Session::ListenForLife() {
  constexpr int kChecksPerSecond = 2, kBusyAfter = 4;
  // A large world takes long to build.
  constexpr int kTimesToBegin = 3;
  life_timer_.expires_after(std::chrono::milliseconds(1000 / kChecksPerSecond));
  life_timer_.async_wait([this, alive = std::weak_ptr<int>(alive_)](boost::system::error_code error) {
    if (error || alive.expired() || engine_ == nullptr) return;
    // Counts checks instead of time, because no check runs while the machine is suspended.
    ++silent_checks_;
    if (hello_ != nullptr && silent_checks_ >= kBusyAfter && !std::exchange(is_busy_, true))
      Tell(R"({"message":"busy"})");
    const int most = settings_.limits.hang_s * kChecksPerSecond * (hello_ == nullptr ? kTimesToBegin : 1);
    if (silent_checks_ < most) return ListenForLife();
    End("This world has not answered for " + std::to_string(most / kChecksPerSecond) +
        " s: it was ended. What was saved and the recording are kept.");
  });
}

void Session::Tell(const std::string& text, const std::string& key) {
  const Bytes shared = Shared(text);
  for (Viewer* viewer : std::vector<Viewer*>(viewers_)) viewer->SendText(shared, key);
}

void Session::OnFrame(Frame frame) {
  // Any message is a sign of life: not every request ends with "done".
  NoLongerBusy();
  silent_checks_ = 0;
  switch (frame.kind) {
    case FrameKind::kAlive:
    case FrameKind::kDone:
      return;
    case FrameKind::kText:
      return Tell(frame.bytes);
    case FrameKind::kReason:
      reason_ = std::move(frame.bytes);
      return;
    case FrameKind::kHello: {
      // Adds the name with which the run was requested. The engine does not have it.
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

void Session::OnEnd(EngineProcess::Ending ending) {
  using Ending = EngineProcess::Ending;
  engine_.reset();
  if (phase_ == Phase::kRest) lock_.reset();
  const std::string why = !reason_.empty()             ? reason_
                          : ending == Ending::kGood    ? "The run has ended."
                          : ending == Ending::kRefused ? "This world needs more memory than the server gives it."
                                                       : "The run has crashed. Drafts and the recording up to then "
                                                         "are kept.";
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
  wanted_.reset();
  if (engine_ == nullptr) return;
  phase_ = Phase::kEnding;
  Forget();
  const std::shared_ptr<EngineProcess> ending = std::exchange(engine_, nullptr);
  ending->End([this, alive = std::weak_ptr<int>(alive_)] {
    if (alive.expired()) return;
    lock_.reset();
    Advance();
  });
  NoLongerBusy();
  Tell(JsonText(Json{{"message", "ended"}, {"text", why}, {"can_open_again", true}}));
}

}  // namespace soarbox::serve
