// SPDX-License-Identifier: BSD-2-Clause
// Sends entire calls to the server. Each line of the input is a document from a client, complete or without its root
// (<command name="..."> is a call, <result> a reply). With a "2" at the beginning, the second client sends it; a line
// "-" replaces that client by another one. While the server waits for a reply, and while agents run, the following
// documents are processed, as if they arrived on a socket.
//
// Commands that access files are left out, and runs are limited.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "cli/command.h"
#include "growth_limit.h"
#include "sml/server/answers.h"
#include "sml/server/connection.h"
#include "sml/server/dispatcher.h"
#include "sml/server/kernel_host.h"
#include "sml/server/output_documents.h"
#include "sml/wire/message.h"
#include "sml/wire/xml_reader.h"
#include "sml/wire/xml_writer.h"

namespace {

using namespace soarbox;
using server::HostedAgent;

constexpr int kMaxDocuments = 60;

bool TouchesFiles(std::string_view command) {
  for (const std::string_view name : {"load", "save", "output", "cd", "pushd", "popd", "ls", "visualize"}) {
    if (command == name) return true;
  }
  return false;
}

/// Limits runs, independent of the command.
class ShortRuns : public server::KernelHost {
 public:
  kernel::RunResult Run(cli::Session& session, const cli::RunRequest& request) override {
    cli::RunRequest cut = request;
    if (cut.unit == kernel::RunUnit::kForever) cut.unit = kernel::RunUnit::kDecision;
    cut.count = std::min<std::uint64_t>(cut.count, 4);
    for (HostedAgent* hosted : agents()) {
      kernel::AgentSettings& settings = hosted->agent().mutable_settings();
      settings.max_elaborations = std::min(settings.max_elaborations, 20);
      settings.max_goal_depth = std::min(settings.max_goal_depth, 6);
      settings.max_partial_matches = std::min(settings.max_partial_matches, 10000u);
      settings.max_nil_output_cycles = std::min(settings.max_nil_output_cycles, 5);
    }
    return KernelHost::Run(session, cut);
  }

  bool IsSafe(std::string_view line) {
    cli::CommandReader reader(line);
    std::vector<cli::Word> words;
    while (true) {
      const cli::CommandReader::Status status = reader.Next(words);
      if (status == cli::CommandReader::Status::kEnd) return true;
      if (status == cli::CommandReader::Status::kError) return true;  // The rest is not executed.
      const std::size_t count = words.size();
      interpreter().aliases().Expand(words);
      std::string error;
      const cli::CommandInfo* command = words.empty() ? nullptr : cli::FindCommand(words.front().text, error);
      if (!command) continue;
      if (TouchesFiles(command->name)) return false;
      // `debug time COMMAND` executes another command; `alias` may hide one.
      if ((command->name == "debug" || command->name == "alias") && std::max(count, words.size()) > 2) return false;
    }
  }

  /// The same limits for commands that rules execute.
  void GuardAgents() {
    for (HostedAgent* hosted : agents()) {
      hosted->agent().SetCommandRunner([this, hosted](kernel::Agent&, std::string_view line) {
        return IsSafe(line) ? Execute(hosted, line, {}).text : std::string();
      });
      if (limited_.insert(&hosted->agent()).second) limit_.Guard(hosted->agent());
    }
  }

 private:
  GrowthLimit limit_;
  std::unordered_set<const kernel::Agent*> limited_;
};

class Stream;

/// A client that only consists of the documents that it sends.
class Client : public server::Connection {
 public:
  Client(ShortRuns& host, Stream& stream, bool embedded) : host_(host), stream_(stream), embedded_(embedded) {
    host_.AddConnection(*this);
  }
  ~Client() override { host_.RemoveConnection(*this); }

  bool embedded() const override { return embedded_; }
  void Serve(const wire::Message& call);

  void OnSystemEvent(int) override { Wait(); }
  void OnUpdateEvent(int, int) override { Wait(); }
  void OnAgentEvent(HostedAgent& agent, int) override { Tell(agent.name()); }
  void OnRunEvent(HostedAgent& agent, int, int) override { Tell(agent.name()); }
  void OnProductionEvent(HostedAgent&, int, std::string_view name) override { Write(name); }
  void OnPrint(HostedAgent&, const std::string& text) override { Write(text); }
  void OnEcho(HostedAgent&, const std::string& text, bool) override { Write(text); }
  void OnXmlTrace(HostedAgent&, std::string_view pieces) override {
    // The tracer must write a well-formed document.
    if (!wire::ReadXml("<trace>" + std::string(pieces) + "</trace>")) __builtin_trap();
  }
  void OnXmlInput(HostedAgent& agent, std::span<const server::InputWme> wmes) override {
    static_cast<void>(wire::ToXml(server::InputReceivedCommand(agent, wmes)));
  }
  void OnOutput(HostedAgent& agent, std::span<const kernel::OutputChange> changes) override {
    wire::Element command("command");
    server::AddOutput(command, agent.agent(), changes, true);
    Tell(wire::ToXml(command));
  }
  void OnOutputInit(HostedAgent& agent) override { Tell(agent.name()); }
  std::optional<std::string> OnFunction(HostedAgent*, int event, std::string_view name,
                                        std::string_view argument) override {
    Write(name);
    Write(argument);
    std::optional<std::string> answer = Wait();
    // A filter replies with a command line in a document.
    if (event == sml::smlEVENT_FILTER && answer && !answer->empty()) {
      const Result<wire::Element> read = wire::ReadXml(*answer);
      const std::string* line = read ? read.value().Attribute("command") : nullptr;
      if (line && !host_.IsSafe(*line)) return std::nullopt;
    }
    return answer;
  }

 private:
  static void Write(std::string_view text) {
    std::string written;
    wire::AppendEscaped(written, text);
  }
  void Tell(std::string_view text) {
    Write(text);
    Wait();
  }
  /// Processes documents until a reply arrives; none if there are no more documents.
  std::optional<std::string> Wait();

  ShortRuns& host_;
  Stream& stream_;
  const bool embedded_;
};

/// The documents in their order.
class Stream {
 public:
  Stream(ShortRuns& host, std::string_view text) : host_(host), text_(text) {
    clients_[0] = std::make_unique<Client>(host, *this, true);
    clients_[1] = std::make_unique<Client>(host, *this, false);
    host_.SetPump([this] { Next(); });
    host_.RequestPump();
  }
  ~Stream() { host_.SetPump({}); }

  void ServeAll() {
    while (Next()) {
    }
  }

  /// Processes one document; false if there is none. `answer`: receives it if it is a reply.
  bool Next(std::optional<std::string>* answer = nullptr) {
    if (text_.empty() || ++count_ > kMaxDocuments) return false;
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    std::string_view line = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    const bool second = line.starts_with('2');
    if (second) line.remove_prefix(1);
    if (line == "-") {
      if (depth_ == 0) clients_[second ? 1 : 0] = std::make_unique<Client>(host_, *this, !second);
      return true;
    }
    std::string document(line);
    if (line.starts_with("<command")) document = "<sml doctype=\"call\" id=\"1\">" + document + "</sml>";
    if (line.starts_with("<result")) document = "<sml doctype=\"response\" ack=\"1\">" + document + "</sml>";
    const Result<wire::Message> message = wire::ReadMessage(document);
    if (!message) return true;
    if (message.value().type == wire::DocType::kResponse) {
      const wire::Element* result = message.value().ResultTag();
      if (answer) *answer = result ? result->text : std::string();
      return true;
    }
    if (message.value().type != wire::DocType::kCall) return true;
    ++depth_;
    clients_[second ? 1 : 0]->Serve(message.value());
    --depth_;
    host_.GuardAgents();
    host_.RequestPump();
    return true;
  }

 private:
  ShortRuns& host_;
  std::string_view text_;
  std::unique_ptr<Client> clients_[2];
  int count_ = 0;
  int depth_ = 0;
};

void Client::Serve(const wire::Message& call) {
  const wire::Element* command = call.Command();
  const std::string* line = command ? command->Arg("line") : nullptr;
  if (line && !host_.IsSafe(*line)) return;
  wire::Message response = wire::MakeResponse(call.id);
  server::Dispatcher(host_, *this).Handle(call, response);
  // Every reply must be a message.
  if (!wire::ReadMessage(wire::ToDocument(response))) __builtin_trap();
}

std::optional<std::string> Client::Wait() {
  std::optional<std::string> answer;
  while (!answer && stream_.Next(&answer)) {
  }
  return answer;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ShortRuns host;
  Stream(host, std::string_view(reinterpret_cast<const char*>(data), size)).ServeAll();
  return 0;
}
