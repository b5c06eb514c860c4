// SPDX-License-Identifier: BSD-2-Clause
#include "app/window/window_desk.h"

#include <filesystem>
#include <system_error>

#include "app/data_folders.h"
#include "app/window/open_editor.h"
#include "sim/scenario.h"
#include "viewer/palette.h"
#include "workbench/recent.h"

namespace soarbox::app {
namespace {

std::vector<viewer::Ghost> GhostsOf(const std::vector<workbench::GhostBody>& bodies) {
  std::vector<viewer::Ghost> ghosts;
  for (const workbench::GhostBody& body : bodies) {
    viewer::Ghost ghost;
    ghost.name = body.name;
    ghost.agent_id = body.agent_id;
    ghost.position = body.position;
    ghost.forward = body.forward;
    if (body.agent_id != 0)
      ghost.color = body.team.empty() ? viewer::AgentColor(body.kind) : viewer::TeamColor(body.team);
    ghost.opacity = 0.8f;
    ghost.radius_m = body.radius_m;
    ghost.height_m = body.height_m;
    ghosts.push_back(std::move(ghost));
  }
  return ghosts;
}

}  // namespace

void WindowDesk::Serve(workbench::Desk& desk) {
  SaveAwaitedPicture(desk);
  workbench::PanelSet visible;
  for (const workbench::PanelInfo& info : workbench::kPanelInfos)
    if (viewer_.panel_visible(info.id)) visible.Add(info.id);
  panels_.requests.emplace_back(workbench::SelectRequest{desk.NameOf(viewer_.selected_agent())});
  panels_.requests.emplace_back(workbench::LookRequest{visible});
  if (!desk.Serve(panels_)) return;
  const workbench::Contents& contents = panels_.contents;
  viewer_.SetGhosts(GhostsOf(contents.ghosts), contents.shapes, contents.answer_lines);
}

Result<void> WindowDesk::OpenInEditor(const std::string& file, int line) {
  return app::OpenInEditor(file, line);
}

Result<void> WindowDesk::OpenRun(const std::string& what, const std::string& lesson) {
  Result<NextRun> next = FindNextRun(what);
  if (!next) return next.error();
  next->lesson = lesson;
  wants_run_ = std::move(*next);
  return {};
}

void WindowDesk::SavePicture() {
  // The menu from which the picture was requested is closed by then.
  constexpr int kSoon = 6;
  picture_in_frames_ = kSoon;
}

void WindowDesk::SaveAwaitedPicture(workbench::Desk& desk) {
  if (picture_in_frames_ == 0 || --picture_in_frames_ > 0) return;
  const std::string name = "soarbox-" + std::to_string(desk.past().shown_tick());
  std::string file = name + ".png";
  std::error_code error;  // Existing files are kept.
  for (int i = 2; std::filesystem::exists(file, error); ++i) file = name + "-" + std::to_string(i) + ".png";
  if (const Result<void> saved = viewer_.SaveScreenshot(file); !saved) {
    desk.NoteProblem(saved.error(), {});
  } else {
    viewer_.Tell("Saved as " + file);
  }
}

std::vector<workbench::ScenarioOffer> WindowDesk::Scenarios() {
  // The program's scenarios, with the descriptions in their files.
  static const std::vector<workbench::ScenarioOffer> shipped = [] {
    std::vector<workbench::ScenarioOffer> offers;
    const Result<sim::DataFolders> data = FindDataFolders();
    if (!data) return offers;
    for (const std::string& name : sim::ListScenarios(*data))
      offers.push_back({name, sim::DescribeScenario(name, *data)});
    return offers;
  }();
  return shipped;
}

std::vector<std::string> WindowDesk::RecentRuns() {
  return workbench::RecentRuns();
}

std::optional<workbench::Flow> FlowOf(viewer::ViewerCommand command) {
  // Both enumerations have the same order.
  using viewer::ViewerCommand;
  using workbench::Flow;
  static_assert(static_cast<int>(ViewerCommand::kTogglePause) == static_cast<int>(Flow::kTogglePause));
  static_assert(static_cast<int>(ViewerCommand::kStepChange) == static_cast<int>(Flow::kStepChange));
  static_assert(static_cast<int>(ViewerCommand::kUnlimited) == static_cast<int>(Flow::kUnlimited));
  static_assert(static_cast<int>(ViewerCommand::kQuit) == static_cast<int>(Flow::kQuit));
  if (command > ViewerCommand::kQuit) return std::nullopt;
  if (command == ViewerCommand::kSingleStep) return Flow::kStepTurn;
  return static_cast<Flow>(command);
}

}  // namespace soarbox::app
