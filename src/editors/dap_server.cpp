// SPDX-License-Identifier: BSD-2-Clause
#include "editors/dap_server.h"

#include <algorithm>

#include "debugger/console.h"
#include "debugger/watch.h"
#include "debugger/why.h"
#include "editors/dap_words.h"
#include "editors/serve_stream.h"

namespace soarbox::editors {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostHeld = 100'000;

std::string WordIn(const Json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || found->is_null()) return {};
  if (!found->is_string()) throw DapRefusal{std::string(name) + " is not a string"};
  return found->get<std::string>();
}

}  // namespace

std::vector<Json> DapServer::Handle(const std::string& text) {
  out_.clear();
  after_.clear();
  const Json message = Json::parse(text, nullptr, false);
  if (message.is_discarded() || !message.is_object()) {
    Event("output", {{"category", "stderr"}, {"output", "soarbox: a message is not a JSON object\n"}});
    return std::move(out_);
  }
  const auto type = message.find("type");
  if (type == message.end() || *type != "request") return {};
  Json answer = {{"type", "response"}, {"success", true}};
  const auto number = message.find("seq");
  answer["request_seq"] = number != message.end() && number->is_number_integer() ? *number : Json(0);
  answer["command"] = "";
  try {
    const std::string command = WordIn(message, "command");
    answer["command"] = command;
    const auto arguments = message.find("arguments");
    answer["body"] = Request(command, arguments == message.end() || arguments->is_null() ? Json::object() : *arguments);
  } catch (const DapRefusal& refused) {
    answer["success"] = false;
    answer["message"] = refused.message;
    answer["body"] = {{"error", {{"id", 1}, {"format", refused.message}, {"showUser", true}}}};
  } catch (const std::exception& wrong) {
    answer["success"] = false;
    answer["message"] = wrong.what();
  }
  answer["seq"] = ++sequence_;
  out_.push_back(std::move(answer));
  for (Json& event : after_) {
    event["seq"] = ++sequence_;
    out_.push_back(std::move(event));
  }
  after_.clear();
  return std::move(out_);
}

void DapServer::Event(const std::string& name, Json body) {
  Json event = {{"type", "event"}, {"event", name}, {"body", std::move(body)}};
  event["seq"] = ++sequence_;
  out_.push_back(std::move(event));
}

Debuggee& DapServer::Minds() {
  if (debuggee_ == nullptr) throw DapRefusal{"nothing is being debugged: launch or attach comes first"};
  return *debuggee_;
}

Json DapServer::Request(const std::string& command, const Json& arguments) {
  if (!arguments.is_object()) throw DapRefusal{"arguments is not an object"};
  if (command == "initialize") {
    after_.push_back({{"type", "event"}, {"event", "initialized"}});
    return {{"supportsConfigurationDoneRequest", true},
            {"supportsFunctionBreakpoints", true},
            {"supportsStepBack", true},
            {"supportsEvaluateForHovers", true},
            {"supportsRestartRequest", true},
            {"supportsSteppingGranularity", true},
            {"supportsCompletionsRequest", true},
            {"supportsTerminateRequest", true},
            {"supportsConditionalBreakpoints", true},
            {"supportsLogPoints", true},
            {"exceptionBreakpointFilters",
             Json::array({Json{{"filter", "scripts"}, {"label", "Errors in scripts"}, {"default", false}}})},
            {"completionTriggerCharacters", {" "}}};
  }
  if (command == "launch") return Launch(arguments);
  if (command == "attach") return Attach(arguments);
  if (command == "configurationDone") {
    configured_ = true;
    if (debuggee_ == nullptr) return Json::object();
    if (stop_on_entry_) {
      Stop("entry");
    } else {
      running_ = true;
    }
    return Json::object();
  }
  if (command == "disconnect" || command == "terminate") {
    debuggee_.reset();
    running_ = false;
    over_ = command == "disconnect";
    if (!over_) after_.push_back({{"type", "event"}, {"event", "terminated"}});
    return Json::object();
  }
  if (command == "setExceptionBreakpoints") return SetErrorStops(arguments);
  if (command == "setBreakpoints") return SetBreakpoints(arguments);
  if (command == "setFunctionBreakpoints") return SetFunctionBreakpoints(arguments);
  if (command == "threads") return Threads(arguments);
  if (command == "stackTrace") return StackTrace(arguments);
  if (command == "scopes") return Scopes(arguments);
  if (command == "variables") return Variables(arguments);
  if (command == "evaluate") return Evaluate(arguments);
  if (command == "completions") return Completions(arguments);
  if (command == "continue") {
    Minds();
    running_ = true;
    return {{"allThreadsContinued", true}};
  }
  if (command == "pause") {
    Minds();
    running_ = false;
    Stop("pause");
    return Json::object();
  }
  if (command == "restart") {
    if (const Result<void> again = Minds().Restart(); !again) throw DapRefusal{WithHint(again.error())};
    ended_ = false;
    Stop("restart");
    return Json::object();
  }
  if (command == "next" || command == "stepIn" || command == "stepOut" || command == "stepBack" ||
      command == "reverseContinue")
    return StepBy(command, arguments);
  throw DapRefusal{"there is no request " + command};
}

Json DapServer::Launch(const Json& arguments) {
  LaunchRequest request;
  request.program = WordIn(arguments, "program");
  if (request.program.empty()) throw DapRefusal{"program is missing: a scenario, a file of rules or a recording"};
  request.world = arguments.value("world", true);
  if (arguments.contains("seed")) request.seed = arguments.at("seed").get<std::uint64_t>();
  if (arguments.contains("seconds")) request.seconds = std::clamp(arguments.at("seconds").get<double>(), 0.0, 36'000.0);
  stop_on_entry_ = arguments.value("stopOnEntry", true);
  if (request.world && data_ == nullptr) throw DapRefusal{"the scenarios that come with the program are not found"};
  Result<std::unique_ptr<Debuggee>> launched = request.world ? LaunchWorld(request, *data_) : LaunchKernel(request);
  if (!launched) throw DapRefusal{WithHint(launched.error())};
  Begin(std::move(*launched));
  return Json::object();
}

Json DapServer::Attach(const Json& arguments) {
  constexpr int kPort = 12121, kHighest = 65535;
  const int port = arguments.value("port", kPort);
  if (port < 1 || port > kHighest) throw DapRefusal{"port is not a number from 1 to 65535"};
  stop_on_entry_ = true;
  Result<std::unique_ptr<Debuggee>> attached = AttachKernel(port);
  if (!attached) throw DapRefusal{WithHint(attached.error())};
  Begin(std::move(*attached));
  return Json::object();
}

void DapServer::Begin(std::unique_ptr<Debuggee> debuggee) {
  debuggee_ = std::move(debuggee);
  running_ = ended_ = false;
  UpdateStops();
  TellNews();
  if (configured_ && stop_on_entry_) Stop("entry");
  running_ = configured_ && !stop_on_entry_;
}

void DapServer::TellNews() {
  for (const std::string& news : debuggee_->TakeNews())
    Event("output", {{"category", "console"}, {"output", news + (news.ends_with('\n') ? "" : "\n")}});
}

void DapServer::Stop(const std::string& reason, const std::string& text) {
  frames_.clear();
  held_.clear();
  const std::vector<std::string> agents = debuggee_->Agents();
  const auto stepped = std::ranges::find(agents, stepping_);
  const std::size_t number = agents.empty()            ? kFirstScriptThread
                             : stepped == agents.end() ? 1
                                                       : static_cast<std::size_t>(stepped - agents.begin()) + 1;
  Json body = {
      {"reason", reason}, {"threadId", number}, {"allThreadsStopped", true}, {"description", debuggee_->When()}};
  if (const std::optional<std::uint32_t> script = PausedScript()) body["threadId"] = kFirstScriptThread + *script;
  if (!text.empty()) body["text"] = text;
  after_.push_back({{"type", "event"}, {"event", "stopped"}, {"body", std::move(body)}});
}

void DapServer::EndIfOver() {
  if (ended_ || !debuggee_->HasEnded()) return;
  ended_ = true;
  Event("output", {{"category", "console"}, {"output", "the run is over (" + debuggee_->When() + ")\n"}});
}

std::vector<Json> DapServer::Advance() {
  out_.clear();
  after_.clear();
  if (!running_ || debuggee_ == nullptr) return {};
  const std::vector<std::string> agents = debuggee_->Agents();
  stopped_at_.clear();
  StopReasons why = debuggee_->Advance(Step::kTick, agents.empty() ? "" : agents.front());
  TellNews();
  if (!why.empty() && !StopsFor(why)) why.clear();
  EndIfOver();
  if (!why.empty() || ended_) {
    running_ = false;
    if (!why.empty()) {
      for (const auto& [file, marks] : marks_)
        for (const Mark& mark : marks)
          if (why.front().rule == mark.rule) stopped_at_ = mark.rule;
      stepping_ = !why.front().agent.empty() || agents.empty() ? why.front().agent : agents.front();
    }
    const bool is_error = !why.empty() && why.front().kind == StopReason::Kind::kScriptError;
    Stop(why.empty() ? "pause"
         : is_error  ? "exception"
                     : "breakpoint",
         why.empty() ? "the run is over" : why.front().text);
  }
  for (Json& event : after_) {
    event["seq"] = ++sequence_;
    out_.push_back(std::move(event));
  }
  after_.clear();
  return std::move(out_);
}

Json DapServer::StepBy(const std::string& command, const Json& arguments) {
  const std::optional<std::uint32_t> script = ScriptOf(arguments);
  const bool goes_back = command == "stepBack" || command == "reverseContinue";
  // If no script is paused, `next` in a thread of a script advances the world by a tick, as in a thread of an agent.
  if (script && !goes_back && (PausedScript() || command != "next")) return StepScript(command, *script);
  const std::string agent = script ? std::string() : AgentOf(arguments);
  Debuggee& minds = Minds();
  stepping_ = agent;
  stopped_at_.clear();
  std::string text;
  if (command == "stepBack" || command == "reverseContinue") {
    const Result<void> back = command == "stepBack" ? minds.GoBack() : minds.Restart();
    if (!back) throw DapRefusal{WithHint(back.error())};
    ended_ = false;
  } else {
    const Step step = WordIn(arguments, "granularity") == "instruction" ? Step::kPhase
                      : command == "next"                               ? Step::kTick
                                                                        : Step::kDecision;
    const auto depth = [&] {
      const std::unique_ptr<explain::Inspector> mind = minds.Inspect(agent);
      return mind == nullptr ? 0 : mind->Stack().size();
    };
    constexpr int kMostSteps = 300;
    const std::size_t before = depth();
    for (int i = 0; i < kMostSteps && text.empty() && !minds.HasEnded(); ++i) {
      const StopReasons why = minds.Advance(step, agent);
      if (!why.empty()) text = why.front().text;
      // Out of a substate: until the goal stack is shorter.
      if (command != "stepOut" || before <= 1 || depth() < before) break;
    }
  }
  TellNews();
  EndIfOver();
  Stop("step", text);
  return Json::object();
}

Json DapServer::SetBreakpoints(const Json& arguments) {
  const fs::path file = fs::path(WordIn(arguments.at("source"), "path")).lexically_normal();
  if (file.extension() == ".lua") return SetScriptBreakpoints(file, arguments);
  std::vector<Mark>& marks = marks_[file.string()];
  marks.clear();
  Json list = Json::array();
  const std::shared_ptr<const language::Document> document = workspace_.Find(file);
  const auto breakpoints = arguments.find("breakpoints");
  if (breakpoints != arguments.end() && breakpoints->is_array()) {
    for (const Json& one : *breakpoints) {
      const auto line = one.at("line").get<std::size_t>();
      const language::DocumentRule* rule = nullptr;
      if (document != nullptr && line > 0) {
        const std::size_t begin = document->lines().Begin(line - 1);
        rule = document->RuleAt(std::min(document->text().find_first_not_of(" \t", begin),
                                         begin + document->lines().Line(line - 1).size()));
      }
      if (rule == nullptr || rule->words->name.empty()) {
        list.push_back({{"verified", false},
                        {"line", line},
                        {"message", document == nullptr ? "this file cannot be read" : "no rule is in this line"}});
        continue;
      }
      const std::size_t first = document->lines().LineOf(rule->span.begin) + 1;
      const std::string condition = WordIn(one, "condition");
      if (const std::string fault = FaultOfCondition(condition); !fault.empty()) {
        list.push_back({{"verified", false}, {"line", first}, {"message", fault}});
        continue;
      }
      marks.push_back({file, rule->words->name, first, condition, WordIn(one, "logMessage")});
      list.push_back({{"verified", true}, {"line", first}, {"message", "when " + rule->words->name + " fires"}});
    }
  }
  UpdateStops();
  return {{"breakpoints", list}};
}

Json DapServer::SetFunctionBreakpoints(const Json& arguments) {
  wishes_.clear();
  Json list = Json::array();
  for (const Json& one : arguments.at("breakpoints")) {
    const std::string name = WordIn(one, "name");
    const std::optional<StopWish> wish = ReadStopWish(name);
    if (wish) {
      wishes_.push_back(*wish);
      list.push_back({{"verified", true}});
    } else {
      list.push_back(
          {{"verified", false},
           {"message",
            "write operator NAME, element ^ATTRIBUTE VALUE, impasse KIND or fire RULE; in a world also match RULE, "
            "removed "
            "^ATTRIBUTE VALUE, number ^ATTRIBUTE < NUMBER, command NAME, failed NAME, death or time SECONDS"}});
    }
  }
  UpdateStops();
  return {{"breakpoints", list}};
}

void DapServer::UpdateStops() {
  if (debuggee_ == nullptr) return;
  std::vector<std::string> rules;
  for (const auto& [file, marks] : marks_)
    for (const Mark& mark : marks)
      if (std::ranges::find(rules, mark.rule) == rules.end()) rules.push_back(mark.rule);
  debuggee_->SetStops(rules, wishes_);
  if (debuggee_->Scripts() == nullptr) return;
  debuggee_->Scripts()->With([&](script::ScriptDebugger& scripts) {
    for (const auto& [file, marks] : script_marks_) scripts.SetBreakpoints(file, marks);
    scripts.SetStopAtErrors(stop_at_errors_);
  });
}

std::string DapServer::AgentOf(const Json& arguments) {
  const std::vector<std::string> agents = Minds().Agents();
  const auto number = arguments.value("threadId", std::size_t{1});
  if (number < 1 || number > agents.size())
    throw DapRefusal{"there is no agent with the number " + std::to_string(number)};
  return agents[number - 1];
}

Json DapServer::Threads(const Json&) {
  Json list = Json::array();
  if (debuggee_ != nullptr)
    for (const std::string& agent : debuggee_->Agents()) list.push_back({{"id", list.size() + 1}, {"name", agent}});
  if (debuggee_ != nullptr) AddScriptThreads(list);
  if (list.empty()) list.push_back({{"id", 1}, {"name", "no agent"}});
  return {{"threads", list}};
}

Json DapServer::StackTrace(const Json& arguments) {
  if (const std::optional<std::uint32_t> script = ScriptOf(arguments)) return ScriptStack(*script);
  const std::string agent = AgentOf(arguments);
  const std::unique_ptr<explain::Inspector> mind = Minds().Inspect(agent);
  Json list = Json::array();
  if (mind != nullptr) {
    const std::vector<explain::StateFact> stack = mind->Stack();
    for (auto state = stack.rbegin(); state != stack.rend(); ++state) {
      frames_.push_back({agent, state->id, state->operator_id});
      std::string name = state->id;
      if (state->impasse != "none" && !state->impasse.empty()) name += " " + state->attribute + " " + state->impasse;
      if (!state->operator_id.empty())
        name += ": " + (state->operator_name.empty() ? state->operator_id : state->operator_name);
      Json frame = {{"id", frames_.size()}, {"name", name}, {"line", 0}, {"column", 0}};
      // The frame of the lowest state shows the rule that caused the stop.
      for (const auto& [file, marks] : marks_)
        for (const Mark& mark : marks)
          if (list.empty() && !stopped_at_.empty() && mark.rule == stopped_at_) {
            frame["source"] = {{"name", mark.file.filename().string()}, {"path", file}};
            frame["line"] = mark.line;
            frame["column"] = 1;
          }
      list.push_back(std::move(frame));
    }
  }
  const std::size_t total = list.size();
  return {{"stackFrames", std::move(list)}, {"totalFrames", total}};
}

Json DapServer::Scopes(const Json& arguments) {
  const auto number = arguments.at("frameId").get<std::size_t>();
  if (number < 1 || number > frames_.size()) throw DapRefusal{"there is no such state any more"};
  const Frame frame = frames_[number - 1];
  if (frame.script) return ScriptScopes(number);
  Json list = Json::array();
  list.push_back({{"name", "State " + frame.state},
                  {"variablesReference", Reference(frame.agent, frame.state)},
                  {"expensive", false}});
  if (!frame.operator_id.empty())
    list.push_back({{"name", "Operator " + frame.operator_id},
                    {"variablesReference", Reference(frame.agent, frame.operator_id)},
                    {"expensive", false}});
  if (const std::unique_ptr<explain::Inspector> mind = Minds().Inspect(frame.agent)) {
    const explain::MindFacts facts = mind->Mind();
    if (!facts.input_link.empty())
      list.push_back({{"name", "Percepts"},
                      {"variablesReference", Reference(frame.agent, facts.input_link)},
                      {"expensive", false}});
    if (!facts.output_link.empty())
      list.push_back({{"name", "Commands"},
                      {"variablesReference", Reference(frame.agent, facts.output_link)},
                      {"expensive", false}});
  }
  return {{"scopes", list}};
}

int DapServer::Reference(std::string agent, std::string id) {
  if (held_.size() >= kMostHeld) return 0;
  held_.push_back({std::move(agent), std::move(id), {}});
  return static_cast<int>(held_.size());
}

int DapServer::Reference(explain::WhyNode why) {
  if (held_.size() >= kMostHeld) return 0;
  held_.push_back({{}, {}, std::move(why), Held::Kind::kWhy});
  return static_cast<int>(held_.size());
}

Json DapServer::ElementsOf(const std::string& agent, const std::string& id) {
  Json list = Json::array();
  const std::unique_ptr<explain::Inspector> mind = Minds().Inspect(agent);
  if (mind == nullptr) return list;
  for (const explain::ElementFact& element : mind->ElementsOf(id)) {
    Json one = {{"name", "^" + element.attribute},
                {"value", element.value + (element.acceptable ? " +" : "")},
                {"evaluateName", id + "." + element.attribute},
                {"variablesReference", element.is_object ? Reference(agent, element.value) : 0}};
    list.push_back(std::move(one));
  }
  return list;
}

Json DapServer::Tree(const explain::WhyNode& why) {
  Json list = Json::array();
  for (const explain::WhyNode& below : why.below)
    list.push_back({{"name", below.kind},
                    {"value", below.text},
                    {"variablesReference", below.below.empty() ? 0 : Reference(below)}});
  return list;
}

Json DapServer::Variables(const Json& arguments) {
  const auto number = arguments.at("variablesReference").get<std::size_t>();
  if (number < 1 || number > held_.size())
    throw DapRefusal{"these variables are outdated: the run has continued since then"};
  const Held held = held_[number - 1];
  if (held.kind == Held::Kind::kElements) return {{"variables", ElementsOf(held.agent, held.id)}};
  if (held.kind == Held::Kind::kWhy) return {{"variables", Tree(held.why)}};
  return ScriptVariables(static_cast<int>(number));
}

std::string DapServer::AgentOfFrame(const Json& arguments, std::string* state) {
  const auto number = arguments.value("frameId", std::size_t{0});
  if (number >= 1 && number <= frames_.size()) {
    if (state != nullptr) *state = frames_[number - 1].state;
    return frames_[number - 1].agent;
  }
  const std::vector<std::string> agents = Minds().Agents();
  if (agents.empty()) throw DapRefusal{"there is no agent with a Soar mind"};
  return std::ranges::find(agents, stepping_) != agents.end() ? stepping_ : agents.front();
}

Json DapServer::Evaluate(const Json& arguments) {
  std::string state;
  std::string expression = WordIn(arguments, "expression");
  const std::size_t end = expression.find_last_not_of(" \t\r\n");
  expression = end == std::string::npos ? ""
                                        : expression.substr(expression.find_first_not_of(" \t\r\n"),
                                                            end + 1 - expression.find_first_not_of(" \t\r\n"));
  const bool is_typed = WordIn(arguments, "context") == "repl";
  const auto frame = arguments.value("frameId", std::size_t{0});
  if (frame >= 1 && frame <= frames_.size() && frames_[frame - 1].script)
    return EvaluateInScript(*frames_[frame - 1].script, frames_[frame - 1].level, expression, is_typed);
  if (const std::optional<std::uint32_t> script = frame == 0 ? PausedScript() : std::nullopt)
    return EvaluateInScript(*script, 0, expression, is_typed);
  const std::string agent = AgentOfFrame(arguments, &state);
  if (expression == "why" || expression.starts_with("why ")) {
    const std::string topic = expression.size() > 4 ? expression.substr(4) : "";
    Result<explain::WhyNode> why = Minds().Why(agent, topic);
    if (!why) throw DapRefusal{WithHint(why.error())};
    return {{"result", is_typed ? debugger::ToText(*why) : why->text},
            {"variablesReference", why->below.empty() ? 0 : Reference(*why)}};
  }
  if (is_typed) {
    const Result<std::string> said = Minds().Command(agent, expression);
    if (!said) throw DapRefusal{WithHint(said.error())};
    TellNews();
    return {{"result", *said}, {"variablesReference", 0}};
  }
  const std::unique_ptr<explain::Inspector> mind = Minds().Inspect(agent);
  if (mind == nullptr) throw DapRefusal{"there is no such mind"};
  if (!state.empty() && expression.starts_with('^')) expression = state + "." + expression.substr(1);
  if (!mind->ElementsOf(expression).empty())
    return {{"result", expression}, {"variablesReference", Reference(agent, expression)}};
  const debugger::WatchValue value = debugger::LookAtWatch(*mind, expression);
  if (value.is_error || value.text.empty())
    throw DapRefusal{value.text.empty() ? "there is nothing of this kind now" : value.text};
  const bool is_object = value.text.find_first_of(" \n") == std::string::npos && !mind->ElementsOf(value.text).empty();
  return {{"result", value.text}, {"variablesReference", is_object ? Reference(agent, value.text) : 0}};
}

Json DapServer::Completions(const Json& arguments) {
  const std::string text = WordIn(arguments, "text");
  const auto column = arguments.value("column", text.size() + 1);
  const std::string line = text.substr(0, std::min(column > 0 ? column - 1 : 0, text.size()));
  Json list = Json::array();
  if (const std::unique_ptr<explain::Inspector> mind = Minds().Inspect(AgentOfFrame(arguments))) {
    const debugger::Completion completion = debugger::Complete(*mind, line);
    for (const std::string& word : completion.words)
      list.push_back({{"label", word},
                      {"start", completion.begin},
                      {"length", line.size() - std::min(completion.begin, line.size())}});
  }
  return {{"targets", list}};
}

int ServeDap(int in, int out, const sim::DataFolders* data) {
  DapServer server(data);
  ServeStream(
      server, in, out,
      [&](const MessageStream::Message& message) {
        return server.Handle(message.fault.empty() ? message.body : std::string());
      },
      [](DapServer& dap) { return dap.is_running() ? 0 : -1; }, [](DapServer& dap) { return dap.Advance(); });
  return 0;
}

}  // namespace soarbox::editors
