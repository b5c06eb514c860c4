// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::editors {

/// The Model Context Protocol for coding assistants: tools that give them the data of the kernel.
///
/// An assistant can read files and run agents, but it cannot change the user's files. Files must be below one folder,
/// with links resolved. Each command is a separate process with limited time and output. Its recordings are in a
/// temporary folder of the server. All requests are answered, including invalid ones; no message ends the server.
class McpServer {
 public:
  using Json = nlohmann::ordered_json;

  /// `program`: the path of the soarbox command. `folder`: the folder of accessible files.
  McpServer(std::filesystem::path program, std::filesystem::path folder);
  ~McpServer();
  McpServer(const McpServer&) = delete;
  McpServer& operator=(const McpServer&) = delete;

  /// Processes one message. Returns the answer, or null if there is none.
  Json Handle(const std::string& message);
  static Json Fault(const std::string& what);

 private:
  Json Request(const std::string& method, const Json& params);
  Json Call(const std::string& tool, const Json& arguments);

  /// The text of a resource of McpResources or McpResourceTemplates.
  Json ReadResource(const Json& params);
  static Json GetPrompt(const Json& params);

  Json CheckRules(const Json& arguments);
  Json FormatRules(const Json& arguments);
  Json MakeDatamap(const Json& arguments);
  Json ListLessons(const Json& arguments);
  Json ReadLesson(const Json& arguments);
  Json LessonHint(const Json& arguments);
  Json GradeLesson(const Json& arguments);
  std::filesystem::path OpenLesson(const Json& arguments, Json& said, std::string& number);
  static std::filesystem::path RulesOf(const std::filesystem::path& lesson);
  Json CompareRuns(const Json& arguments);
  Json Inspect(const Json& arguments);
  Json ListCommands(const Json& arguments);
  Json ListPercepts(const Json& arguments);
  Json ListScenarios(const Json& arguments);
  Json ReadRecording(const Json& arguments);
  Json RunMission(const Json& arguments);
  Json RunScenario(const Json& arguments);
  Json TryFuture(const Json& arguments);
  Json Why(const Json& arguments);

  /// The path of a file; throws a refusal if it is outside the folder.
  std::string FileOf(const Json& arguments, const char* name);
  /// A scenario's name, a file, or a recording that this server made.
  std::string SourceOf(const Json& arguments, const char* name);
  std::string NewRecording(std::string& name);
  /// Runs soarbox with these arguments. Returns its output, at most `most` bytes of it, and the problems it printed.
  Json Run(std::vector<std::string> arguments, std::size_t most = 60'000);
  /// The path of a file that does not exist, in a new folder.
  std::filesystem::path NewPath(const std::string& name);
  std::filesystem::path WriteText(const std::string& text, const std::string& name);

  /// own_: the server's temporary folder; empty if it could not be created.
  std::filesystem::path program_, folder_, own_;
  std::map<std::string, std::filesystem::path> recordings_;  ///< By the names that the assistant uses.
  int count_ = 0;
};

/// Serves on two file descriptors until the client closes its end. Returns the exit code of the process.
int ServeMcp(int in, int out, const std::filesystem::path& program, const std::filesystem::path& folder);

}  // namespace soarbox::editors
