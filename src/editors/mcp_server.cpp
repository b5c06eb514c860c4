// SPDX-License-Identifier: BSD-2-Clause
#include "editors/mcp_server.h"

#include <stdlib.h>

#include <algorithm>
#include <fstream>

#include "diagnostics/read_text.h"
#include "editors/byte_pipe.h"
#include "editors/mcp_prompts.h"
#include "editors/mcp_tools.h"
#include "editors/message_stream.h"
#include "editors/run_program.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::editors {
namespace {

namespace fs = std::filesystem;
using McpJson = McpServer::Json;

constexpr int kMcpParseError = -32700, kMcpInvalidRequest = -32600, kMcpNoSuchMethod = -32601,
              kMcpInvalidParams = -32602;
constexpr double kLongest_s = 600;

struct McpRefusal {
  int code;
  std::string message;
};

McpJson McpError(const McpJson& id, int code, const std::string& message) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}};
}

/// The result of a tool.
McpJson TextAnswer(const std::string& text, bool is_error = false) {
  return {{"content", McpJson::array({{{"type", "text"}, {"text", text}}})}, {"isError", is_error}};
}

std::string WordOf(const McpJson& arguments, const char* name, bool required = false) {
  const auto found = arguments.find(name);
  if (found == arguments.end() || found->is_null()) {
    if (required) throw McpRefusal{kMcpInvalidParams, std::string(name) + " is missing"};
    return {};
  }
  if (!found->is_string()) throw McpRefusal{kMcpInvalidParams, std::string(name) + " is not a string"};
  std::string word = found->get<std::string>();
  if (word.find('\0') != std::string::npos)
    throw McpRefusal{kMcpInvalidParams, std::string(name) + " holds a zero byte"};
  return word;
}

/// A word for the command line. Refuses words that the command would parse as an option.
std::string PlainWord(const McpJson& arguments, const char* name, bool required = false) {
  std::string word = WordOf(arguments, name, required);
  if (word.starts_with('-')) throw McpRefusal{kMcpInvalidParams, std::string(name) + " may not begin with -"};
  return word;
}

void AddNumber(std::vector<std::string>& words, const char* option, const McpJson& arguments, const char* name,
               double most = 36'000) {
  const auto found = arguments.find(name);
  if (found == arguments.end() || found->is_null()) return;
  if (!found->is_number() || found->get<double>() < 0 || found->get<double>() > most)
    throw McpRefusal{kMcpInvalidParams,
                     std::string(name) + " is not a number from 0 to " + std::to_string(static_cast<long>(most))};
  words.insert(words.end(), {option, found->dump()});
}

void AddWord(std::vector<std::string>& words, const char* option, const McpJson& arguments, const char* name) {
  if (const std::string word = PlainWord(arguments, name); !word.empty()) words.insert(words.end(), {option, word});
}

}  // namespace

McpServer::McpServer(fs::path program, fs::path folder) : program_(std::move(program)) {
  std::error_code error;
  folder_ = fs::canonical(folder, error);
  std::string own = (fs::temp_directory_path(error) / "soarbox-mcp-XXXXXX").string();
  if (mkdtemp(own.data()) == nullptr) return;
  own_ = own;
  // The commands store recordings and a learner's progress below this folder. Those of an assistant must be separate
  // from those of the user.
  setenv("XDG_STATE_HOME", own.c_str(), 1);
}

McpServer::~McpServer() {
  std::error_code error;
  if (!own_.empty()) fs::remove_all(own_, error);
}

McpJson McpServer::Fault(const std::string& what) {
  return McpError(nullptr, kMcpParseError, what);
}

McpJson McpServer::Handle(const std::string& text) {
  const McpJson message = McpJson::parse(text, nullptr, false);
  if (message.is_discarded()) return McpError(nullptr, kMcpParseError, "this message is not JSON");
  if (!message.is_object()) return McpError(nullptr, kMcpInvalidRequest, "this message is not an object");
  const auto id_field = message.find("id");
  const bool is_request = id_field != message.end() && (id_field->is_string() || id_field->is_number_integer());
  const McpJson id = is_request ? *id_field : McpJson();
  const auto method = message.find("method");
  if (method == message.end() || !method->is_string())
    return McpError(id, kMcpInvalidRequest, "this message has no method");
  if (!is_request) return nullptr;
  const auto params_field = message.find("params");
  const McpJson params = params_field == message.end() ? McpJson::object() : *params_field;
  try {
    return {{"jsonrpc", "2.0"}, {"id", id}, {"result", Request(method->get<std::string>(), params)}};
  } catch (const McpRefusal& refused) {
    return McpError(id, refused.code, refused.message);
  } catch (const std::exception& wrong) {
    return McpError(id, kMcpInvalidParams, wrong.what());
  }
}

McpJson McpServer::Request(const std::string& method, const McpJson& params) {
  if (method == "ping") return McpJson::object();
  if (method == "initialize") {
    constexpr const char* kVersion = "2024-11-05";
    return {{"protocolVersion", kVersion},
            {"capabilities",
             {{"tools", McpJson::object()}, {"prompts", McpJson::object()}, {"resources", McpJson::object()}}},
            {"serverInfo", {{"name", "soarbox"}, {"version", SOARBOX_VERSION}}},
            {"instructions",
             "Tools to write Soar agents: check rules with the kernel's own reader, look up percepts and commands, run "
             "scenarios and missions, and ask why an agent does what it does. Files are named relative to " +
                 folder_.string() + "; nothing is changed there."}};
  }
  if (method == "tools/list") return {{"tools", McpTools()}};
  if (method == "tools/call") {
    const auto arguments = params.find("arguments");
    return Call(params.at("name").get<std::string>(), arguments == params.end() ? McpJson::object() : *arguments);
  }
  if (method == "prompts/list") return {{"prompts", McpPrompts()}};
  if (method == "prompts/get") return GetPrompt(params);
  if (method == "resources/list") return {{"resources", McpResources()}};
  if (method == "resources/templates/list") return {{"resourceTemplates", McpResourceTemplates()}};
  if (method == "resources/read") return ReadResource(params);
  throw McpRefusal{kMcpNoSuchMethod, "there is no method " + method};
}

McpJson McpServer::GetPrompt(const McpJson& params) {
  const std::string name = WordOf(params, "name", true);
  const auto arguments = params.find("arguments");
  std::string missing;
  const std::optional<std::string> text =
      McpPrompt(name, arguments == params.end() ? McpJson::object() : *arguments, missing);
  if (!text) throw McpRefusal{kMcpInvalidParams, "there is no prompt " + name};
  if (!missing.empty()) throw McpRefusal{kMcpInvalidParams, missing + " is missing"};
  return {{"messages", McpJson::array({{{"role", "user"}, {"content", {{"type", "text"}, {"text", *text}}}}})}};
}

McpJson McpServer::ReadResource(const McpJson& params) {
  const std::string uri = WordOf(params, "uri", true);
  constexpr std::string_view kLesson = "soarbox://lesson/";
  McpJson answer;
  if (uri == "soarbox://percepts") {
    answer = ListPercepts(McpJson::object());
  } else if (uri == "soarbox://commands") {
    answer = ListCommands(McpJson::object());
  } else if (uri == "soarbox://options") {
    constexpr std::size_t kLong = 1'000'000;
    answer = Run({"help", "--markdown"}, kLong);
  } else if (uri == "soarbox://scenarios") {
    answer = ListScenarios(McpJson::object());
  } else if (uri == "soarbox://lessons") {
    answer = ListLessons(McpJson::object());
  } else if (uri.starts_with(kLesson)) {
    const McpJson number = McpJson::parse(uri.substr(kLesson.size()), nullptr, false);
    answer = ReadLesson({{"lesson", number.is_discarded() ? McpJson() : number}});
  } else {
    throw McpRefusal{kMcpInvalidParams, "there is no resource " + uri};
  }
  std::string text;
  for (const McpJson& part : answer["content"]) text += (text.empty() ? "" : "\n") + part["text"].get<std::string>();
  return {{"contents", McpJson::array({{{"uri", uri}, {"mimeType", "text/markdown"}, {"text", text}}})}};
}

McpJson McpServer::Call(const std::string& tool, const McpJson& arguments) {
  using Handler = McpJson (McpServer::*)(const McpJson&);
  static const std::map<std::string, Handler> kHandlers = {
      {"check_rules", &McpServer::CheckRules},
      {"compare_runs", &McpServer::CompareRuns},
      {"format_rules", &McpServer::FormatRules},
      {"grade_lesson", &McpServer::GradeLesson},
      {"inspect", &McpServer::Inspect},
      {"lesson_hint", &McpServer::LessonHint},
      {"list_commands", &McpServer::ListCommands},
      {"list_lessons", &McpServer::ListLessons},
      {"list_percepts", &McpServer::ListPercepts},
      {"list_scenarios", &McpServer::ListScenarios},
      {"make_datamap", &McpServer::MakeDatamap},
      {"read_lesson", &McpServer::ReadLesson},
      {"read_recording", &McpServer::ReadRecording},
      {"run_mission", &McpServer::RunMission},
      {"run_scenario", &McpServer::RunScenario},
      {"try_future", &McpServer::TryFuture},
      {"why", &McpServer::Why},
  };
  const auto handler = kHandlers.find(tool);
  if (handler == kHandlers.end()) throw McpRefusal{kMcpInvalidParams, "there is no tool " + tool};
  if (!arguments.is_object()) throw McpRefusal{kMcpInvalidParams, "arguments is not an object"};
  if (own_.empty()) return TextAnswer("the folder for recordings of runs cannot be created", true);
  return (this->*handler->second)(arguments);
}

std::string McpServer::FileOf(const McpJson& arguments, const char* name) {
  const fs::path named = PlainWord(arguments, name, true);
  std::error_code error;
  const fs::path file = fs::weakly_canonical(named.is_absolute() ? named : folder_ / named, error);
  const fs::path relative = file.lexically_relative(folder_);
  if (error || folder_.empty() || relative.empty() || *relative.begin() == "..")
    throw McpRefusal{kMcpInvalidParams, named.string() + " lies outside of " + folder_.string()};
  return file.string();
}

std::string McpServer::SourceOf(const McpJson& arguments, const char* name) {
  const std::string word = PlainWord(arguments, name, true);
  if (const auto own = recordings_.find(word); own != recordings_.end()) return own->second.string();
  // A plain name that is not a file may be a scenario of the program.
  std::error_code error;
  if (word.find('/') == std::string::npos && word.find('.') == std::string::npos && !fs::exists(folder_ / word, error))
    return word;
  return FileOf(arguments, name);
}

std::string McpServer::NewRecording(std::string& name) {
  name = "run-" + std::to_string(++count_);
  return (own_ / (name + ".soarrec")).string();
}

fs::path McpServer::NewPath(const std::string& name) {
  const fs::path file = own_ / std::to_string(++count_) / name;
  std::error_code error;
  fs::create_directory(file.parent_path(), error);
  return file;
}

fs::path McpServer::WriteText(const std::string& text, const std::string& name) {
  const fs::path file = NewPath(name);
  if (!(std::ofstream(file, std::ios::binary) << text).flush())
    throw McpRefusal{kMcpInvalidParams, "these rules cannot be kept for the run"};
  return file;
}

McpJson McpServer::Run(std::vector<std::string> arguments, std::size_t most) {
  arguments.insert(arguments.begin(), program_.string());
  const ProgramEnd end = RunProgram(arguments);
  std::string text = end.out;
  // The assistant does not see the path of the server's own folder.
  const auto hide = [&](std::string& of) {
    for (std::size_t at = of.find(own_.string()); at != std::string::npos; at = of.find(own_.string(), at))
      of.erase(at, std::min(own_.string().size() + 1, of.size() - at));
  };
  std::string problems = end.err;
  hide(text);
  hide(problems);
  if (text.size() > most) {
    text.resize(most);
    text += "\n... and more: ask for a shorter part\n";
  }
  if (!problems.empty()) text += (text.empty() || text.ends_with('\n') ? "" : "\n") + problems.substr(0, most);
  if (end.hung) text += "\nIt took too long and was ended.\n";
  constexpr int kProblems = 1;  // Errors in the user's files; the command itself succeeded.
  return TextAnswer(text.empty() ? "(nothing)" : text, end.hung || end.code < 0 || end.code > kProblems);
}

McpJson McpServer::CheckRules(const McpJson& arguments) {
  if (const std::string text = WordOf(arguments, "text"); !text.empty())
    return Run({"check", "--json", WriteText(text, "rules.soar").string()});
  const std::string file = FileOf(arguments, "path");
  McpJson answer = Run({"check", "--json", file});
  return answer;
}

McpJson McpServer::FormatRules(const McpJson& arguments) {
  const fs::path file = WriteText(WordOf(arguments, "text", true), "rules.soar");
  McpJson said = Run({"format", file.string()});
  if (said["isError"] == true) return said;
  return TextAnswer(ReadText(file).value_or(""));
}

McpJson McpServer::MakeDatamap(const McpJson& arguments) {
  const std::string rules = FileOf(arguments, "path");
  const fs::path file = NewPath("project.vsa.json");
  McpJson said = Run({"datamap", rules, "-o", file.string()});
  const std::optional<std::string> text = ReadText(file);
  return text ? TextAnswer(*text) : said;
}

McpJson McpServer::ListPercepts(const McpJson& arguments) {
  const std::string filter = WordOf(arguments, "filter");
  std::string text;
  for (const vocabulary::PerceptRow& row : vocabulary::Percepts()) {
    if (row.path.find(filter) == std::string_view::npos) continue;
    const std::string range = vocabulary::DescribeRange(row.unit, row.min, row.max, row.words);
    text += "^io.input-link." + std::string(row.path) + " (" + std::string(vocabulary::NameOf(row.type)) +
            (range.empty() ? "" : ", " + range) + "): " + std::string(row.meaning) + "\n";
  }
  return TextAnswer(text.empty() ? "no percept has this in its path" : text);
}

McpJson McpServer::ListCommands(const McpJson& arguments) {
  const std::string filter = WordOf(arguments, "filter");
  std::string text;
  const auto tell = [&](const vocabulary::ParameterRow& one) {
    const std::string range = vocabulary::DescribeRange(one.unit, one.min, one.max, one.words);
    text += "  ^" + std::string(one.name) + (one.required ? " (required)" : "") + ": " + std::string(one.meaning) +
            (range.empty() ? "" : " (" + range + ")") + "\n";
  };
  for (const vocabulary::CommandRow& row : vocabulary::Commands()) {
    if (row.name.find(filter) == std::string_view::npos) continue;
    text += "^io.output-link." + std::string(row.name) + ": " + std::string(row.meaning) + "\n";
    for (const vocabulary::ParameterRow& one : row.parameters) tell(one);
    if (row.place != vocabulary::TakesPlace::kNo)
      for (const vocabulary::ParameterRow& one : vocabulary::PlaceParameters()) tell(one);
  }
  return TextAnswer(text.empty() ? "no command has this in its name" : text);
}

McpJson McpServer::ListScenarios(const McpJson&) {
  return Run({"list"});
}

McpJson McpServer::RunScenario(const McpJson& arguments) {
  std::string name;
  std::vector<std::string> words = {"run", SourceOf(arguments, "scenario"), "--headless", "--json"};
  if (!arguments.contains("seconds")) words.insert(words.end(), {"--seconds", "20"});
  AddNumber(words, "--seconds", arguments, "seconds", kLongest_s);
  AddNumber(words, "--seed", arguments, "seed", 4e9);
  const std::string recording = NewRecording(name);
  words.insert(words.end(), {"--record", recording, "--record-level", "all", "--record-limit", "200"});
  McpJson answer = Run(std::move(words));
  std::error_code error;
  if (!fs::exists(recording, error)) return answer;
  recordings_[name] = recording;
  answer["content"].push_back({{"type", "text"}, {"text", "recording: " + name}});
  return answer;
}

McpJson McpServer::RunMission(const McpJson& arguments) {
  std::vector<std::string> words = {"test", SourceOf(arguments, "path"), "--json", "--no-keep"};
  AddWord(words, "--seeds", arguments, "seeds");
  return Run(std::move(words));
}

McpJson McpServer::Why(const McpJson& arguments) {
  std::vector<std::string> words = {"why", SourceOf(arguments, "source")};
  if (const std::string topic = PlainWord(arguments, "topic"); !topic.empty()) words.push_back(topic);
  AddWord(words, "--agent", arguments, "agent");
  AddNumber(words, "--at", arguments, "at");
  AddNumber(words, "--seed", arguments, "seed", 4e9);
  return Run(std::move(words));
}

McpJson McpServer::Inspect(const McpJson& arguments) {
  std::vector<std::string> words = {"inspect", SourceOf(arguments, "source"), "--view",
                                    PlainWord(arguments, "view", true)};
  AddWord(words, "--agent", arguments, "agent");
  AddNumber(words, "--at", arguments, "at");
  AddNumber(words, "--seed", arguments, "seed", 4e9);
  return Run(std::move(words));
}

McpJson McpServer::ReadRecording(const McpJson& arguments) {
  std::vector<std::string> words = {"replay", SourceOf(arguments, "recording"), "--headless"};
  AddNumber(words, "--from", arguments, "from");
  AddNumber(words, "--to", arguments, "to");
  return Run(std::move(words));
}

McpJson McpServer::TryFuture(const McpJson& arguments) {
  const std::string past = SourceOf(arguments, "recording");
  std::string name;
  std::vector<std::string> words = {"resume", past, "--json", "--rules",
                                    WriteText(WordOf(arguments, "rules", true), "rules.soar").string()};
  if (!arguments.contains("at")) throw McpRefusal{kMcpInvalidParams, "at is missing"};
  AddNumber(words, "--at", arguments, "at");
  AddNumber(words, "--seconds", arguments, "seconds", kLongest_s);
  AddWord(words, "--agent", arguments, "agent");
  const std::string recording = NewRecording(name);
  words.insert(words.end(), {"--record", recording});
  McpJson answer = Run(std::move(words), 20'000);
  std::error_code error;
  if (answer["isError"] == true || !fs::exists(recording, error)) return answer;
  recordings_[name] = recording;
  const McpJson differences = Run({"compare", past, recording}, 20'000);
  for (const McpJson& part : differences["content"]) answer["content"].push_back(part);
  answer["content"].push_back({{"type", "text"}, {"text", "recording: " + name}});
  return answer;
}

McpJson McpServer::ListLessons(const McpJson&) {
  return Run({"learn"});
}

/// Creates the folder with the files of a lesson and returns it. `said` receives what `soarbox learn` prints, `number`
/// the lesson's number.
fs::path McpServer::OpenLesson(const McpJson& arguments, McpJson& said, std::string& number) {
  const auto found = arguments.find("lesson");
  if (found == arguments.end() || !found->is_number_unsigned())
    throw McpRefusal{kMcpInvalidParams, "lesson is the number of a lesson"};
  number = found->dump();
  const fs::path all = own_ / "lessons";
  said = Run({"learn", number, "--headless", "--folder", all.string()});
  const std::string begin = (number.size() == 1 ? "0" : "") + number + "-";
  std::error_code error;
  for (fs::directory_iterator it(all, error), end; !error && it != end; it.increment(error))
    if (it->path().filename().string().starts_with(begin)) return it->path();
  throw McpRefusal{kMcpInvalidParams, "there is no lesson " + number + "; list_lessons names them"};
}

/// The file that the learner edits: the only file of rules in the lesson's folder. Refuses if there is not exactly one.
fs::path McpServer::RulesOf(const fs::path& lesson) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(lesson, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".soar") files.push_back(it->path());
  if (files.size() == 1) return files.front();
  throw McpRefusal{kMcpInvalidParams, "this lesson is not about one file of rules"};
}

McpJson McpServer::ReadLesson(const McpJson& arguments) {
  McpJson answer;
  std::string number;
  const fs::path folder = OpenLesson(arguments, answer, number);
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->is_regular_file(error)) files.push_back(it->path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    answer["content"].push_back(
        {{"type", "text"}, {"text", file.filename().string() + ":\n" + ReadText(file).value_or("")}});
  return answer;
}

McpJson McpServer::LessonHint(const McpJson& arguments) {
  McpJson said;
  std::string number;
  OpenLesson(arguments, said, number);
  return Run({"learn", "hint", number, "--folder", (own_ / "lessons").string()});
}

McpJson McpServer::GradeLesson(const McpJson& arguments) {
  const std::string rules = WordOf(arguments, "rules", true);
  McpJson said;
  std::string number;
  const fs::path file = RulesOf(OpenLesson(arguments, said, number));
  if (!(std::ofstream(file, std::ios::binary) << rules).flush())
    throw McpRefusal{kMcpInvalidParams, "these rules cannot be kept for the grading"};
  return Run({"learn", "check", number, "--folder", (own_ / "lessons").string()});
}

McpJson McpServer::CompareRuns(const McpJson& arguments) {
  return Run({"compare", SourceOf(arguments, "recording"), SourceOf(arguments, "other")});
}

int ServeMcp(int in, int out, const fs::path& program, const fs::path& folder) {
  McpServer server(program, folder);
  BytePipe pipe(in, out);
  LineStream stream;
  while (!pipe.is_broken()) {
    if (const std::optional<MessageStream::Message> message = stream.Next()) {
      if (message->fault.empty() && message->body.find_first_not_of(" \t") == std::string::npos) continue;
      const McpJson answer = message->fault.empty() ? server.Handle(message->body) : McpServer::Fault(message->fault);
      if (!answer.is_null()) pipe.Write(answer.dump(-1, ' ', false, McpJson::error_handler_t::replace) + "\n");
      continue;
    }
    const BytePipe::Got got = pipe.Read(-1);
    if (got.ended) break;
    stream.Add(got.bytes);
  }
  return 0;
}

}  // namespace soarbox::editors
