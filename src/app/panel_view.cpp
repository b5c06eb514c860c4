// SPDX-License-Identifier: BSD-2-Clause
#include "app/panel_view.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/kernel_address.h"
#include "diagnostics/problem.h"
#include "record/reader.h"
#include "record/recorder.h"
#include "sim/scenario_file.h"
#include "workbench/desk.h"
#include "workbench/document/panels.h"
#include "world/world.h"

namespace soarbox::app {
namespace {

/// Implements the services of a desk without a user: they do nothing.
class NoUser final : public workbench::Surroundings {
 public:
  bool IsPaused() const override { return true; }
  void Pause() override {}
  void GoOn() override {}
  void SetSpeed(double) override {}
  void Tell(std::string) override {}
};

/// A run that cannot go back.
class ForwardRun final : public workbench::LiveRun {
 public:
  explicit ForwardRun(std::unique_ptr<sim::Simulation> simulation) : simulation_(std::move(simulation)) {}
  sim::Simulation& simulation() override { return *simulation_; }
  sim::MindDetail LeastDetail() const override { return sim::MindDetail::kAll; }
  void Watch(OnTick on_tick) override {
    on_tick_ = std::move(on_tick);
    Report();
  }
  void SetOnEdit(OnEdit) override {}
  void GoOnWith(std::unique_ptr<sim::Simulation>, const record::TickRecord&,
                const std::vector<record::TickInputs>&) override {}
  void Tick() {
    simulation_->Tick();
    Report();
  }

 private:
  void Report() {
    record::Observe(*simulation_, simulation_->TakeEvents(), record::Level::kAll, last_);
    if (on_tick_) on_tick_(last_);
  }

  std::unique_ptr<sim::Simulation> simulation_;
  record::TickRecord last_;
  OnTick on_tick_;
};

Result<std::string> DrawPanel(workbench::Desk& desk, const InspectOptions& options, workbench::PanelId panel) {
  workbench::PanelExchange panels;
  const workbench::Contents& contents = panels.contents;
  const auto serve = [&](workbench::Request request) {
    panels.requests.push_back(std::move(request));
    desk.Serve(panels);
    while (!desk.IsSettled()) desk.Serve(panels);
  };
  workbench::LookRequest look;
  look.panels.Add(panel);
  serve(look);
  std::string agent = options.agent;
  if (agent.empty() && !contents.soar_agents.empty()) agent = contents.soar_agents.front();
  serve(workbench::SelectRequest{agent});
  if (contents.agent != agent)
    return NewProblem("there is no agent '" + agent + "' at that moment", "--view agents lists all agents");
  const workbench::document::Nodes nodes = workbench::document::DocumentOf(panel, contents);
  return options.json ? workbench::document::ToJson(nodes).dump() + "\n"
                      : workbench::document::ToText(nodes, contents.moment.step_s);
}

Result<std::string> OfRecording(const InspectOptions& options, workbench::PanelId panel, const sim::DataFolders& data,
                                record::Reader& reader) {
  const auto wanted = static_cast<std::uint64_t>(std::llround(options.at_s / reader.header().step_s));
  const std::uint64_t tick = std::clamp(wanted, reader.first_tick(), reader.last_tick());
  NoUser user;
  workbench::Desk desk(reader, data, {reader.first_tick(), tick}, user);
  desk.Show(tick);
  return DrawPanel(desk, options, panel);
}

Result<std::string> OfScenario(const InspectOptions& options, workbench::PanelId panel, const sim::DataFolders& data) {
  const Result<sim::Scenario> scenario = sim::FindScenario(options.source, data, options.extra_folders);
  if (!scenario) return scenario.error();
  sim::SimulationSettings settings;
  settings.mind_detail = sim::MindDetail::kAll;
  if (!options.kernel.empty()) {
    if (const Result<void> read = ReadKernelAddress(options.kernel, settings.soar); !read) return read.error();
  }
  settings.seed = sim::SeedOf(*scenario, options.seed);
  Result<std::unique_ptr<sim::Simulation>> made = sim::Simulation::Create(*scenario, settings);
  if (!made) return made.error();
  const double step_s = (*made)->world().settings().step_s;
  ForwardRun run(std::move(*made));
  NoUser user;
  workbench::Desk desk(run, record::HeaderOf(*scenario, settings, step_s, record::Level::kAll), *scenario, settings,
                       user);
  const auto last = static_cast<std::uint64_t>(std::llround(options.at_s / step_s));
  while (run.simulation().tick() < last) {
    desk.Prepare();
    run.Tick();
  }
  return DrawPanel(desk, options, panel);
}

}  // namespace

Result<std::string> ShowPanel(const InspectOptions& options, const std::string& panel, const sim::DataFolders& data) {
  const std::optional<workbench::PanelId> id = workbench::FindPanel(panel);
  if (!id || !workbench::document::HasDocument(*id)) {
    std::string words;
    for (const workbench::document::PanelDocument& each : workbench::document::kPanelDocuments)
      words += (words.empty() ? "" : ", ") + std::string(workbench::InfoOf(each.panel).word);
    return NewProblem("no panel '" + panel + "' can be printed", "name one of " + words);
  }
  if (!options.until.empty() || options.recorded)
    return NewProblem("a panel is shown at a moment, not with --until or --recorded", "--at SECONDS says which moment");
  if (const Result<std::unique_ptr<record::Reader>> opened = record::Reader::Open(options.source); opened)
    return OfRecording(options, *id, data, **opened);
  return OfScenario(options, *id, data);
}

}  // namespace soarbox::app
