// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/requests_json.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "debugger/json_fields.h"
#include "diagnostics/problem.h"

namespace soarbox::workbench {
namespace {

using debugger::kNeeded;
using debugger::kOptional;
using debugger::Need;
using debugger::Words;

// The words of each choice, in the order of its enumerators.
constexpr std::string_view kWhyAbout[] = {"agent", "operator", "command", "element", "not"};
constexpr std::string_view kEditText[] = {"type", "check", "apply", "save", "revert"};
constexpr auto kBreakNames = [] {
  std::array<std::string_view, std::size(debugger::kBreakKinds)> names{};
  std::ranges::transform(debugger::kBreakKinds, names.begin(), &debugger::BreakKindWords::name);
  return names;
}();
constexpr std::string_view kChangeBreak[] = {"clear", "enable", "disable"};
constexpr std::string_view kScriptGo[] = {"on", "into", "over", "out"};
constexpr std::string_view kFlows[] = {"begin-again"};
constexpr std::string_view kLessons[] = {"hint", "grade", "open", "cancel"};

// In the order of TraceKind.
constexpr std::string_view kTraceLevels[] = {"error", "decision", "command", "event",
                                             "input", "percept",  "rule",    "element"};

}  // namespace

Json ToJson(const PanelSet& panels) {
  Json list = Json::array();
  for (const PanelInfo& info : kPanelInfos)
    if (panels.Has(info.id)) list.push_back(std::string(info.word));
  return list;
}
debugger::FieldType ScriptTypeOf(const PanelSet*) {
  return {"readonly string[]", "list of text"};
}

// The fields of each request (debugger/json_fields.h), for parsing, printing and the reference.
void Fields(auto& visit, SelectRequest& r) {
  visit("agent", r.agent, "its name; empty: nobody", kNeeded);
}
void Fields(auto& visit, LookRequest& r) {
  visit("panels", r.panels, "the visible panels, by their words", kNeeded);
}
void Fields(auto& visit, OpenFileRequest& r) {
  visit("file", r.file, "the file", kNeeded);
  visit("line", r.line, "where to look first; 0: anywhere", kOptional);
}
void Fields(auto& visit, ConsoleRequest& r) {
  visit("agent", r.agent, "whose command line it is", kNeeded);
  visit("line", r.line, "the command", kNeeded);
}
void Fields(auto& visit, CompleteRequest& r) {
  visit("agent", r.agent, "whose command line it is", kNeeded);
  visit("line", r.line, "what is typed so far", kNeeded);
}
void Fields(auto& visit, KeepLineRequest& r) {
  visit("agent", r.agent, "whose command line it is", kNeeded);
  visit("line", r.line, "what is typed so far; empty: nothing", kNeeded);
}
void Fields(auto&, ClearConsoleRequest&) {}
void Fields(auto&, ClearProblemsRequest&) {}
void Fields(auto& visit, SeekRequest& r) {
  visit("tick", r.tick, "the tick to show", kNeeded);
}
void Fields(auto&, LiveRequest&) {}
void Fields(auto&, ResumeRequest&) {}
void Fields(auto& visit, SpeedRequest& r) {
  visit("speed", r.speed, "simulated seconds per second", kNeeded);
}
void Fields(auto&, SavePictureRequest&) {}
void Fields(auto& visit, TellRequest& r) {
  visit("text", r.text, "the remark", kNeeded);
}
void Fields(auto& visit, TraceRequest& r) {
  visit("level", r.level, kTraceLevels, "lines of this kind and of those before it", kOptional);
  visit("agent", r.agent, "not empty: only lines about the selected agent", kOptional);
  visit("text", r.text,
        "words that the line contains; rule:NAME, op:NAME, command:NAME and ^attribute: lines about these", kOptional);
}
void Fields(auto& visit, StateRequest& r) {
  visit("state", r.state, "\"S1\"; empty: the lowest", kNeeded);
}
void Fields(auto& visit, ObjectRequest& r) {
  visit("id", r.id, "an identifier of working memory", kNeeded);
  visit("is_open", r.is_open, "whether it is unfolded", kOptional);
}
void Fields(auto& visit, ElementRequest& r) {
  visit("timetag", r.timetag, "its time tag; 0: no element any more", kNeeded);
}
void Fields(auto& visit, SearchMemoryRequest& r) {
  visit("text", r.text, "the text that elements must contain; empty: nothing is searched", kNeeded);
}
void Fields(auto& visit, RuleRequest& r) {
  visit("rule", r.rule, "its name; empty: no rule any more", kNeeded);
}
void Fields(auto&, CoverageRequest&) {}
void Fields(auto& visit, SearchKnownRequest& r) {
  visit("text", r.text, "the text that objects must contain; empty: all", kNeeded);
}
void Fields(auto& visit, EpisodeRequest& r) {
  visit("number", r.number, "counted from 1; 0: no episode any more", kNeeded);
}
void Fields(auto& visit, LearnedRuleRequest& r) {
  visit("rule", r.rule, "its name; empty: no rule any more", kNeeded);
}
void Fields(auto& visit, CurveRequest& r) {
  visit("rule", r.rule, "a rule with a value that is learned", kNeeded);
  visit("is_on", r.is_on, "false: no longer", kOptional);
}
void Fields(auto& visit, WhyRequest& r) {
  visit("about", r.about, kWhyAbout, "what is asked about", kNeeded);
  visit("what", r.what, "a name, or the time tag of an element; not needed for `agent`", kOptional);
}
void Fields(auto& visit, ImagineRequest& r) {
  visit("state", r.state, "the scene of this state, \"S1\"; empty: what the agent made up in any state", kOptional);
  visit("record", r.record, "with lines that show why the answer of this record is so; empty: none", kOptional);
}
void Fields(auto& visit, PlotRequest& r) {
  visit("agent", r.agent, "the agent that has the number", kNeeded);
  visit("what", r.what, "one of `plottable`, or a percept's path", kNeeded);
  visit("is_on", r.is_on, "false: no longer", kOptional);
}
void Fields(auto& visit, EditRequest& r) {
  visit("file", r.file, "the file, or its name alone", kNeeded);
  visit("line", r.line, "where to look first; 0: anywhere", kOptional);
  visit("rule", r.rule, "or the rule to look at", kOptional);
}
void Fields(auto& visit, EditTextRequest& r) {
  visit("what", r.what, kEditText, "what to do", kNeeded);
  visit("text", r.text, "the complete text as it is typed now", kNeeded);
}
void Fields(auto&, SaveAllRequest&) {}
void Fields(auto& visit, OpenRunRequest& r) {
  visit("what", r.what, "a scenario's name or path, or a recording", kNeeded);
}
void Fields(auto& visit, WatchRequest& r) {
  visit("what", r.what, "a value, \"S1.io.input-link.self.health\", or a Soar command", kNeeded);
  visit("is_on", r.is_on, "false: no longer", kOptional);
}
void Fields(auto& visit, BesideRequest& r) {
  visit("agent", r.agent, "whose mind", kNeeded);
  visit("is_on", r.is_on, "false: no longer", kOptional);
}
void Fields(auto& visit, SearchRequest& r) {
  visit("text", r.text, "what to find; empty: nothing", kNeeded);
}
void Fields(auto& visit, OfferRequest& r) {
  visit("is_on", r.is_on, "false: no longer", kOptional);
}
void Fields(auto& visit, BreakRequest& r) {
  visit("kind", r.kind, kBreakNames, "what it waits for", kNeeded);
  visit("agent", r.agent, "the agent that it is about; empty: any", kOptional);
  visit("what", r.what,
        "a rule, `ID ^attribute value`, `^attribute < number`, an operator, an impasse, a command, a check or a "
        "second; * "
        "stands for anything",
        kOptional);
}
void Fields(auto& visit, ChangeBreakRequest& r) {
  visit("number", r.number, "the breakpoint's", kNeeded);
  visit("what", r.what, kChangeBreak, "what to do", kNeeded);
}
void Fields(auto& visit, LineStopRequest& r) {
  visit("file", r.file, "a script of the run, or its name alone", kNeeded);
  visit("line", r.line, "the line; if no function executes it, the next one that a function executes", kNeeded);
  visit("is_on", r.is_on, "false: no longer", kOptional);
  visit("condition", r.condition,
        "an expression of Lua that changes nothing, such as `agent:GetHealth() < 50`: scripts stop only if it is true, "
        "or if it has no value",
        kOptional);
}
void Fields(auto& visit, ErrorStopRequest& r) {
  visit("is_on", r.is_on, "false: no longer", kOptional);
}
void Fields(auto& visit, ScriptGoRequest& r) {
  visit("how", r.how, kScriptGo, "to the next stop, into a call, over the line, or out of the function", kNeeded);
}
void Fields(auto& visit, ScriptCallRequest& r) {
  visit("call", r.call, "its number; 0: the innermost", kNeeded);
}
void Fields(auto& visit, ScriptValueRequest& r) {
  visit("key", r.key, "the path of the variable: \"locals/target\"", kNeeded);
  visit("is_open", r.is_open, "whether it is unfolded", kOptional);
}
void Fields(auto& visit, ScriptWatchRequest& r) {
  visit("what", r.what, "an expression of Lua that changes nothing: `agent:GetPosition().x > 3`", kNeeded);
  visit("is_on", r.is_on, "false: no longer", kOptional);
}
void Fields(auto& visit, LessonRequest& r) {
  visit("what", r.what, kLessons, "the next hint, a grade, or another lesson", kNeeded);
  visit("lesson", r.lesson, "which one to open", kOptional);
}
void Fields(auto& visit, FlowRequest& r) {
  visit("what", r.what, kFlows, "the only command that a document contains", kNeeded);
}

namespace {

/// Parses the fields of a request. Keeps the first error.
struct Reader {
  static constexpr std::size_t kLongestText = std::size_t{4} << 20;

  const Json& json;
  std::string_view request;
  std::vector<std::string_view> known = {"request", "id"};
  std::string mistake = {}, hint = {};

  void Refuse(std::string_view name, const std::string& what, const std::string& remedy = {}) {
    if (!mistake.empty()) return;
    mistake = std::string(name) + " " + what;
    hint = remedy;
  }
  /// Null if the field is absent.
  const Json* Find(std::string_view name, Need need) {
    known.push_back(name);
    const auto found = json.find(name);
    if (found != json.end()) return &*found;
    if (need == kNeeded) Refuse(name, "is missing");
    return nullptr;
  }
  void operator()(std::string_view name, std::string& value, std::string_view, Need need) {
    const Json* const found = Find(name, need);
    if (found == nullptr) return;
    if (!found->is_string()) return Refuse(name, "is to be a text");
    value = found->get<std::string>();
    if (value.size() > kLongestText) Refuse(name, "is longer than 4 MiB");
  }
  void operator()(std::string_view name, bool& value, std::string_view, Need need) {
    const Json* const found = Find(name, need);
    if (found == nullptr) return;
    if (!found->is_boolean()) return Refuse(name, "is to be true or false");
    value = found->get<bool>();
  }
  void operator()(std::string_view name, double& value, std::string_view, Need need) {
    const Json* const found = Find(name, need);
    if (found == nullptr) return;
    if (!found->is_number()) return Refuse(name, "is to be a number");
    value = found->get<double>();
  }
  template <typename Whole>
  void ReadWhole(std::string_view name, Whole& value, Need need) {
    const Json* const found = Find(name, need);
    if (found == nullptr) return;
    const bool is_whole = found->is_number_integer() &&
                          (found->is_number_unsigned() || found->get<std::int64_t>() >= 0) &&
                          std::in_range<Whole>(found->get<std::uint64_t>());
    if (!is_whole) return Refuse(name, "must be a whole number, 0 or more");
    value = static_cast<Whole>(found->get<std::uint64_t>());
  }
  /// For int and unsigned types of every size: std::size_t and std::uint64_t are two types on some platforms.
  template <std::integral Whole>
  void operator()(std::string_view name, Whole& value, std::string_view, Need need) {
    ReadWhole(name, value, need);
  }
  void operator()(std::string_view name, PanelSet& value, std::string_view, Need need) {
    const Json* const found = Find(name, need);
    if (found == nullptr) return;
    if (!found->is_array()) return Refuse(name, "must be a list of words of panels");
    std::vector<std::string_view> words;
    for (const PanelInfo& info : kPanelInfos) words.push_back(info.word);
    for (const Json& word : *found) {
      const std::string text = word.is_string() ? word.get<std::string>() : word.type_name();
      const std::optional<PanelId> panel = FindPanel(text);
      if (!panel) return RefuseWord(name, text, words);
      value.Add(*panel);
    }
  }
  template <typename Enum>
  void operator()(std::string_view name, Enum& value, Words words, std::string_view, Need need) {
    const Json* const found = Find(name, need);
    if (found == nullptr) return;
    const std::string text = found->is_string() ? found->get<std::string>() : found->type_name();
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] != text) continue;
      value = static_cast<Enum>(i);
      return;
    }
    RefuseWord(name, text, {words.begin(), words.end()});
  }
  void RefuseWord(std::string_view name, const std::string& text, const std::vector<std::string_view>& words) {
    const std::string_view near = Suggest(text, words);
    std::string remedy = near.empty() ? "it is one of" : "did you mean '" + std::string(near) + "'?";
    for (std::size_t i = 0; near.empty() && i < words.size(); ++i) remedy += " " + std::string(words[i]);
    Refuse(name, "cannot be '" + text + "'", remedy);
  }
};

struct Row {
  std::string_view name, about;
  std::vector<debugger::TypeField> (*list)(debugger::TypeLister& types);
  Request (*read)(Reader& reader);
  bool (*write)(const Request& request, Json& json);  ///< Returns false if the request is of another kind.
};

template <typename R>
constexpr Row RowOf(std::string_view name, std::string_view about) {
  return {name, about, [](debugger::TypeLister& types) { return types.FieldsOf<R>(); },
          [](Reader& reader) -> Request {
            R request;
            Fields(reader, request);
            return request;
          },
          [](const Request& request, Json& json) {
            const R* const mine = std::get_if<R>(&request);
            if (mine == nullptr) return false;
            R copy = *mine;
            debugger::FieldWriter writer(json);
            Fields(writer, copy);
            return true;
          }};
}

/// All requests.
constexpr Row kRows[] = {
    RowOf<SelectRequest>("select", "Select an agent of the world; most contents are about it."),
    RowOf<LookRequest>("look", "Set the visible panels; the others get no contents."),
    RowOf<OpenFileRequest>("open-file", "Open a file in the user's own editor; in a window only."),
    RowOf<ConsoleRequest>("console", "Carry out a line of the Soar command language for an agent."),
    RowOf<CompleteRequest>("complete", "Complete the last word of a line."),
    RowOf<KeepLineRequest>("keep-line", "Store a line that was typed but not sent."),
    RowOf<ClearConsoleRequest>("clear-console", "Forget what the selected agent's console has printed."),
    RowOf<ClearProblemsRequest>("clear-problems", "Forget the problems so far."),
    RowOf<SeekRequest>("seek", "Show a past tick; a run pauses."),
    RowOf<LiveRequest>("live", "Show the newest tick, and follow it."),
    RowOf<ResumeRequest>("resume", "Go on from the tick that is shown; what came after it becomes the old future."),
    RowOf<SpeedRequest>("set-speed", "Set the speed of the world."),
    RowOf<SavePictureRequest>("save-picture", "Write the window as a picture; in a window only."),
    RowOf<TellRequest>("tell", "Show a notice to the user."),
    RowOf<TraceRequest>("trace", "Select the lines of the trace that are shown."),
    RowOf<StateRequest>("state", "Show the operators of this state."),
    RowOf<ObjectRequest>("object", "Unfold an object of working memory, or fold it."),
    RowOf<ElementRequest>("element", "Show everything about an element."),
    RowOf<SearchMemoryRequest>("search-memory", "Find elements of working memory."),
    RowOf<RuleRequest>("rule", "Show everything about a rule."),
    RowOf<CoverageRequest>("coverage", "Report which rules took part so far, and how far the others match now."),
    RowOf<SearchKnownRequest>("search-known", "Find objects of long-term memory."),
    RowOf<EpisodeRequest>("episode", "Look at an episode of the selected agent."),
    RowOf<LearnedRuleRequest>("learned-rule", "Show how a rule was learned, and where it fired."),
    RowOf<CurveRequest>("curve", "Draw the learned value of a rule as a curve."),
    RowOf<WhyRequest>("ask", "Explain why something is so, or is not so."),
    RowOf<ImagineRequest>("imagine", "Draw what the selected agent imagines over the world."),
    RowOf<PlotRequest>("plot", "Draw a number of an agent over time."),
    RowOf<EditRequest>("edit", "Edit a file that the run was made from."),
    RowOf<EditTextRequest>("edit-text", "Check, apply, save or revert the edited text."),
    RowOf<SaveAllRequest>("save-all", "Write all files that have changes."),
    RowOf<OpenRunRequest>("open-run", "Show another world or recording; in a window only."),
    RowOf<WatchRequest>("watch", "Show a value, or the output of a command, after each decision."),
    RowOf<BesideRequest>("beside", "Show an agent's mind next to those of others."),
    RowOf<SearchRequest>("search", "Find a text in rules, scripts, memory and the trace."),
    RowOf<OfferRequest>("offer", "List what can be opened and searched."),
    RowOf<BreakRequest>("break", "Stop the world when something happens in a mind."),
    RowOf<ChangeBreakRequest>("change-break", "Remove a breakpoint, or switch it on or off."),
    RowOf<LineStopRequest>("line-stop", "Let scripts stop at a line, in the middle of a tick."),
    RowOf<ErrorStopRequest>("error-stop", "Let scripts stop at errors that they do not catch."),
    RowOf<ScriptGoRequest>("script-go", "Let the stopped script continue, or take a step in it."),
    RowOf<ScriptCallRequest>("script-call", "Show the variables of a call of the stopped script."),
    RowOf<ScriptValueRequest>("script-value", "Unfold a variable of the stopped script, or fold it."),
    RowOf<ScriptWatchRequest>("script-watch", "Show the value of an expression while a script is stopped."),
    RowOf<LessonRequest>("lesson", "Get a hint or the grade of a lesson, or open another lesson."),
    RowOf<FlowRequest>("flow", "Control the run; serve_protocol.md lists all commands."),
};
static_assert(std::size(kRows) == std::variant_size_v<Request>);

}  // namespace

std::vector<RequestInfo> RequestInfos() {
  debugger::TypeLister types;
  std::vector<RequestInfo> infos;
  for (const Row& row : kRows) {
    RequestInfo& info = infos.emplace_back(RequestInfo{row.name, row.about, {}});
    for (debugger::TypeField& field : row.list(types))
      info.fields.push_back(
          {field.name, std::move(field.type.words), std::move(field.type.script), field.about, field.is_needed});
  }
  return infos;
}

Result<Request> ReadRequest(const Json& json) {
  const auto named = json.is_object() ? json.find("request") : json.end();
  if (!json.is_object() || named == json.end() || !named->is_string())
    return NewProblem("a request is an object with a field 'request'", R"(as {"request": "seek", "tick": 120})");
  const auto name = named->get<std::string>();
  std::vector<std::string_view> names;
  for (const Row& row : kRows) {
    names.push_back(row.name);
    if (row.name != name) continue;
    Reader reader{json, row.name};
    Request request = row.read(reader);
    for (const auto& [key, value] : json.items()) {
      const std::string_view near = Suggest(key, reader.known);
      if (std::find(reader.known.begin(), reader.known.end(), key) == reader.known.end())
        reader.Refuse(key, "is not one of its fields", near.empty() ? "" : "did you mean '" + std::string(near) + "'?");
    }
    if (!reader.mistake.empty()) return NewProblem("request " + name + ": " + reader.mistake, reader.hint);
    return request;
  }
  const std::string_view near = Suggest(name, names);
  return NewProblem("there is no request '" + name + "'",
                    near.empty() ? "docs/workbench.md lists them" : "did you mean '" + std::string(near) + "'?");
}

Json ToJson(const Request& request) {
  Json json;
  for (const Row& row : kRows) {
    json["request"] = std::string(row.name);
    if (row.write(request, json)) break;
  }
  return json;
}

}  // namespace soarbox::workbench
