// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "sml/server/kernel_host.h"
#include "sml/wire/xml_reader.h"
#include "sml/wire/xml_writer.h"

namespace soarbox::server {

using namespace ::sml;

namespace {

constexpr std::string_view kFilterName = "_sml::filter";

std::string FilterDocument(std::string_view line) {
  wire::Element filter("filter");
  filter.Set("command", std::string(line));
  return wire::ToXml(filter);
}

}  // namespace

bool KernelHost::SearchFilters() const {
  return std::any_of(functions_.begin(), functions_.end(),
                     [](const Function& function) { return function.name == kFilterName; });
}

/// Passes the line to each filter in turn; filters may change it. If a filter ends the line, returns its result.
std::optional<cli::CommandResult> KernelHost::PassFilters(HostedAgent& hosted, std::string& line) {
  for (std::size_t i = 0; i < functions_.size() && !hosted.doomed; ++i) {
    if (functions_[i].name != kFilterName) continue;  // Clients register filters as filters or as client messages.
    const auto answer =
        functions_[i].connection->OnFunction(&hosted, smlEVENT_FILTER, kFilterName, FilterDocument(line));
    if (!answer) continue;
    cli::CommandResult ended;
    if (answer->empty()) return ended;
    const Result<wire::Element> read = wire::ReadXml(*answer);
    if (!read) continue;
    if (const std::string* command = read.value().Attribute("command")) {
      line = *command;
      continue;
    }
    if (const std::string* output = read.value().Attribute("output")) ended.text = *output;
    const std::string* error = read.value().Attribute("error");
    ended.ok = !(error && *error == "true");
    return ended;
  }
  return std::nullopt;
}

void KernelHost::SetFence(std::vector<std::filesystem::path> folders, bool rules_only) {
  using Source = cli::Fence::Source;
  fence_ = std::make_unique<const cli::Fence>(std::move(folders), rules_only ? Source::kRulesOnly : Source::kFiles);
  recorded_fence_ = std::make_unique<const cli::Fence>(fence_->For(Source::kRecording));
}

const cli::Fence* KernelHost::FenceOf(const HostedAgent& hosted, const LineOptions& options) const {
  if (options.recorded) return recorded_fence_.get();
  if (!options.fenced) return nullptr;
  return hosted.fence ? hosted.fence.get() : fence_.get();
}

cli::CommandResult KernelHost::Execute(HostedAgent* hosted, std::string_view line, const LineOptions& options) {
  const Stay stay(*this);
  HostedAgent& addressed = *Addressed(hosted);
  std::string text(line);
  if (overhear_ && options.from && !options.from->embedded()) overhear_(addressed.name().c_str(), text.c_str());
  if (options.filter && HasFilters()) {
    if (auto ended = PassFilters(addressed, text)) return *std::move(ended);
  }
  return ExecuteUnfiltered(addressed, text, options);
}

cli::CommandResult KernelHost::ExecuteUnfiltered(HostedAgent& hosted, std::string_view line,
                                                 const LineOptions& options) {
  const bool echoes = (options.echo || hosted.session().output().echo_commands) && hosted.Listens(smlEVENT_ECHO);
  if (echoes) hosted.FireEcho(options.from, std::string(line));
  // A line of the user ends the fence of a surrounding file; a line of an untrusted file starts one.
  const cli::Interpreter::Fenced fenced(interpreter_, FenceOf(hosted, options));
  if (hosted.log && options.from) hosted.log->Line(hosted, cli::WithWholeFileName(interpreter_, line));
  cli::CommandResult result = interpreter_.Execute(hosted.session(), line);
  if (hosted.doomed) return result;
  // Memory may also run out outside of a run.
  if (hosted.agent().out_of_memory()) hosted.run_state = sml_RUNSTATE_HALTED;
  hosted.PrepareRun();
  hosted.FlushPrint();
  hosted.FlushXmlTrace();
  if (echoes) hosted.FireEcho(options.from, result.text);
  return result;
}

}  // namespace soarbox::server
