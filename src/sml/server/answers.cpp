// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/answers.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

#include "diagnostics/diagnostic.h"
#include "sml/server/hosted_agent.h"

namespace soarbox::server {

namespace {

wire::Element Convert(const cli::ResultNode& node) {
  wire::Element element(node.tag);
  element.attributes = node.attributes;
  element.text = node.text;
  element.children.reserve(node.children.size());
  for (const cli::ResultNode& child : node.children) element.children.push_back(Convert(child));
  return element;
}

}  // namespace

void AddLineResult(wire::Message& response, const cli::CommandResult& result, bool structured) {
  if (!result.ok) {
    wire::AddError(response, structured ? std::string_view() : std::string_view(result.text), "1");
    return;
  }
  if (!structured) {
    wire::AddRawResult(response, result.text);
    return;
  }
  if (!result.structured.children.empty()) {
    wire::Element answer = Convert(result.structured);
    // The printed text is next to the elements that `print` returns.
    const std::string& first = answer.children.front().tag;
    if ((first == "id" || first == "wme") && !answer.Arg("message")) {
      wire::Element& arg = answer.Add("arg");
      arg.Set("param", "message").Set("type", "string").text = result.text;
    }
    response.root.children.push_back(std::move(answer));
  } else if (result.text.empty()) {
    wire::AddRawResult(response, "true");
  } else {
    wire::Element& arg = response.root.Add("result").Add("arg");
    arg.Set("param", "message").Set("type", "string").text = result.text;
  }
}

std::shared_ptr<const wire::Element> StructuredDocument(const cli::CommandResult& result) {
  wire::Message response = wire::MakeResponse("0");
  AddLineResult(response, result, true);
  auto root = std::make_shared<wire::Element>(std::move(response.root));
  root->Set("ack", "0").Set("doctype", "response").Set("id", "0").Set("smlversion", std::string(wire::kSmlVersion));
  return root;
}

std::string ErrorDetails(const cli::CommandResult& result) {
  // Printed errors are at the beginning of lines. An index of the lines keeps the search fast for many errors.
  std::unordered_map<std::string_view, std::size_t> line_begins;
  const std::string_view printed = result.text;
  for (std::size_t begin = 0, end; begin < printed.size(); begin = end) {
    end = std::min(printed.find('\n', begin), printed.size() - 1) + 1;
    line_begins.emplace(printed.substr(begin, end - begin), begin);
  }
  std::unordered_set<std::string> added;
  std::string details = result.text;
  for (const Diagnostic& diagnostic : result.diagnostics) {
    if (diagnostic.line == 0 && diagnostic.hint.empty()) continue;
    std::string text = Format(diagnostic);
    const auto line = line_begins.find(std::string_view(text).substr(0, text.find('\n') + 1));
    if (line != line_begins.end() && printed.substr(line->second).starts_with(text)) continue;
    const auto [place, is_new] = added.insert(std::move(text));
    if (!is_new) continue;
    if (!details.empty() && details.back() != '\n') details += '\n';
    details += *place;
  }
  return details;
}

std::string Warnings(const cli::CommandResult& result) {
  std::string warnings;
  for (const Diagnostic& trap : result.traps) warnings += Format(trap);
  return warnings;
}

wire::Element InputReceivedCommand(HostedAgent& agent, std::span<const InputWme> wmes) {
  wire::Element command("command");
  command.Set("name", "event").AddArg("eventid", "xml-input-received").AddArg("agent", agent.name());
  for (const InputWme& wme : wmes) wire::AddWme(command, wme);
  return command;
}

std::shared_ptr<const wire::Element> InputReceivedDocument(HostedAgent& agent, std::span<const InputWme> wmes) {
  auto root = std::make_shared<wire::Element>("sml");
  root->Set("doctype", "call").Set("id", "0").Set("smlversion", std::string(wire::kSmlVersion));
  root->children.push_back(InputReceivedCommand(agent, wmes));
  return root;
}

}  // namespace soarbox::server
