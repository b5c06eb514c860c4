// SPDX-License-Identifier: BSD-2-Clause
// Lua scripts in the Debug Adapter Protocol: threads, calls, variables, line breakpoints.
#include <algorithm>
#include <fstream>
#include <iterator>

#include "editors/dap_server.h"
#include "editors/dap_words.h"

namespace soarbox::editors {
namespace {

constexpr std::size_t kNoCall = 1'000'000;  ///< Frame::level for a script that is not running.

std::string TextOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

}  // namespace

std::optional<std::uint32_t> DapServer::ScriptOf(const Json& arguments) {
  const auto number = arguments.value("threadId", std::int64_t{1});
  if (number >= 0 && number < kFirstScriptThread) return std::nullopt;
  std::optional<std::uint32_t> owner;
  Lua().With([&](script::ScriptDebugger& scripts) {
    for (const script::ScriptView::Machine& machine : scripts.view().Machines())
      if (kFirstScriptThread + std::int64_t{machine.owner} == number) owner = machine.owner;
  });
  if (!owner) throw DapRefusal{"there is no thread " + std::to_string(number)};
  return owner;
}

ScriptDebuggee& DapServer::Lua() {
  ScriptDebuggee* const scripts = Minds().Scripts();
  if (scripts == nullptr) throw DapRefusal{"there are no scripts here: launch a scenario or a recording"};
  return *scripts;
}

std::optional<std::uint32_t> DapServer::PausedScript() {
  std::optional<std::uint32_t> owner;
  if (debuggee_ != nullptr && debuggee_->Scripts() != nullptr && debuggee_->Scripts()->IsPaused())
    debuggee_->Scripts()->With([&](script::ScriptDebugger& scripts) { owner = scripts.view().owner(); });
  return owner;
}

Json DapServer::SetScriptBreakpoints(const std::filesystem::path& file, const Json& arguments) {
  const std::vector<int> lines = script::LinesOfScript(TextOf(file));
  std::vector<script::ScriptBreakpoint>& marks = script_marks_[file.string()];
  marks.clear();
  std::erase_if(script_logs_, [&](const auto& log) { return log.first.first == file.string(); });
  Json list = Json::array();
  const auto breakpoints = arguments.find("breakpoints");
  if (breakpoints != arguments.end() && breakpoints->is_array()) {
    for (const Json& one : *breakpoints) {
      const int wanted = one.at("line").get<int>();
      const auto line = std::ranges::lower_bound(lines, wanted);
      if (line == lines.end()) {
        list.push_back({{"verified", false},
                        {"line", wanted},
                        {"message", lines.empty() ? "this file cannot be read, or it does not compile"
                                                  : "nothing is executed in this line or after it"}});
        continue;
      }
      marks.push_back({*line, one.value("condition", std::string())});
      if (const std::string log = one.value("logMessage", std::string()); !log.empty())
        script_logs_[{file.string(), *line}] = log;
      list.push_back({{"verified", true}, {"line", *line}});
    }
  }
  UpdateStops();
  return {{"breakpoints", list}};
}

Json DapServer::SetErrorStops(const Json& arguments) {
  stop_at_errors_ = false;
  Json list = Json::array();
  const auto filters = arguments.find("filters");
  if (filters != arguments.end() && filters->is_array()) {
    for (const Json& filter : *filters) {
      stop_at_errors_ = stop_at_errors_ || filter == "scripts";
      list.push_back({{"verified", filter == "scripts"}});
    }
  }
  UpdateStops();
  return {{"breakpoints", list}};
}

void DapServer::AddScriptThreads(Json& list) {
  const std::vector<std::string> minds = debuggee_->Agents();
  if (debuggee_->Scripts() == nullptr) return;
  debuggee_->Scripts()->With([&](script::ScriptDebugger& scripts) {
    for (const script::ScriptView::Machine& machine : scripts.view().Machines()) {
      const bool has_mind = std::ranges::find(minds, machine.name) != minds.end();
      list.push_back(
          {{"id", kFirstScriptThread + machine.owner}, {"name", machine.name + (has_mind ? " (script)" : "")}});
    }
  });
}

Json DapServer::ScriptStack(std::uint32_t owner) {
  std::vector<script::ScriptFrame> calls;
  if (PausedScript() == owner)
    debuggee_->Scripts()->With([&](script::ScriptDebugger& scripts) { calls = scripts.view().Frames(); });
  Json list = Json::array();
  for (std::size_t level = 0; level < calls.size(); ++level) {
    const script::ScriptFrame& call = calls[level];
    frames_.push_back({{}, {}, {}, owner, level});
    Json frame = {
        {"id", frames_.size()}, {"name", call.function}, {"line", call.line}, {"column", call.line > 0 ? 1 : 0}};
    if (!call.file.empty())
      frame["source"] = {{"name", std::filesystem::path(call.file).filename().string()}, {"path", call.file}};
    list.push_back(std::move(frame));
  }
  if (list.empty()) {
    // A frame for a script that is not running, so that its global variables can be inspected.
    frames_.push_back({{}, {}, {}, owner, kNoCall});
    list.push_back({{"id", frames_.size()}, {"name", "not running now"}, {"line", 0}, {"column", 0}});
  }
  const std::size_t total = list.size();
  return {{"stackFrames", std::move(list)}, {"totalFrames", total}};
}

Json DapServer::ScriptScopes(std::size_t frame_number) {
  const Frame frame = frames_[frame_number - 1];
  Json list = Json::array();
  const auto add = [&](const char* name, Held::Kind kind, bool expensive) {
    Held held;
    held.kind = kind;
    held.script = *frame.script;
    held.number = static_cast<int>(frame.level);
    held_.push_back(std::move(held));
    list.push_back({{"name", name}, {"variablesReference", held_.size()}, {"expensive", expensive}});
  };
  if (frame.level != kNoCall) {
    add("Locals", Held::Kind::kLocals, false);
    add("Upvalues", Held::Kind::kUpvalues, false);
  }
  add("Globals", Held::Kind::kGlobals, frame.level != kNoCall);
  return {{"scopes", list}};
}

Json DapServer::VariablesAsJson(const std::vector<script::ScriptVariable>& variables) {
  Json list = Json::array();
  for (const script::ScriptVariable& variable : variables) {
    int number = 0;
    if (variable.reference > 0) {
      Held held;
      held.kind = Held::Kind::kFields;
      held.number = variable.reference;
      held_.push_back(std::move(held));
      number = static_cast<int>(held_.size());
    }
    list.push_back(
        {{"name", variable.name}, {"value", variable.value}, {"type", variable.type}, {"variablesReference", number}});
  }
  return list;
}

Json DapServer::ScriptVariables(int held_number) {
  const Held held = held_[static_cast<std::size_t>(held_number) - 1];
  std::vector<script::ScriptVariable> variables;
  Lua().With([&](script::ScriptDebugger& debugger) {
    script::ScriptView& scripts = debugger.view();
    const auto level = static_cast<std::size_t>(held.number);
    switch (held.kind) {
      case Held::Kind::kLocals:
        variables = scripts.Locals(level);
        break;
      case Held::Kind::kUpvalues:
        variables = scripts.Upvalues(level);
        break;
      case Held::Kind::kGlobals:
        variables = scripts.Globals(held.script);
        break;
      default:
        variables = scripts.Fields(held.number);
    }
  });
  return {{"variables", VariablesAsJson(variables)}};
}

Json DapServer::EvaluateInScript(std::uint32_t owner, std::size_t level, const std::string& expression,
                                 bool in_console) {
  const bool is_paused = PausedScript() == owner;
  Result<script::ScriptVariable> value = Diagnostic{};
  Lua().With([&](script::ScriptDebugger& debugger) {
    script::ScriptView& scripts = debugger.view();
    value = is_paused ? scripts.Evaluate(level == kNoCall ? 0 : level, expression)
                      : scripts.EvaluateGlobal(owner, expression);
  });
  if (!value && in_console && !PausedScript()) {
    // Statements and calls of the script's own functions may change the world. They become an input of the world, like
    // text that is typed in its console.
    Lua().Run(owner, expression);
    return {{"result", "runs in the next tick"}, {"variablesReference", 0}};
  }
  if (!value) throw DapRefusal{value.error().message};
  const Json shown = VariablesAsJson({*value});
  return {{"result", value->value}, {"type", value->type}, {"variablesReference", shown[0]["variablesReference"]}};
}

Json DapServer::StepScript(const std::string& command, std::uint32_t owner) {
  const script::ScriptStep step = command == "next"     ? script::ScriptStep::kOver
                                  : command == "stepIn" ? script::ScriptStep::kInto
                                                        : script::ScriptStep::kOut;
  stopped_at_.clear();
  const StopReasons why = Lua().Advance(step, owner);
  TellNews();
  EndIfOver();
  const bool is_step = why.empty() || why.front().kind == StopReason::Kind::kScriptStep;
  Stop(is_step ? "step" : "breakpoint", why.empty() ? std::string() : why.front().text);
  return Json::object();
}

}  // namespace soarbox::editors
