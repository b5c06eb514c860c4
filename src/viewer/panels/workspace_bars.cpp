// SPDX-License-Identifier: BSD-2-Clause
// The bars of the workspace: menus, the toolbar of the run, the scrubber, and the list of keys.
#include <algorithm>
#include <cmath>

#include "viewer/panels/icons.h"
#include "viewer/panels/layout_audit.h"
#include "viewer/panels/panel_layout.h"
#include "viewer/panels/widgets.h"
#include "workbench/flow_info.h"

namespace soarbox::viewer {
namespace {

constexpr const char* kLayouts = "Layouts";

void CommandItem(PanelFrame& frame, ViewerCommand command, bool enabled = true) {
  const CommandInfo& info = InfoOf(command);
  const std::string title(info.title), keys(info.keys);
  if (ImGui::MenuItem(title.c_str(), keys.c_str(), frame.is_on(command), enabled)) frame.Command(command);
  Tooltip(info.meaning);
}

void CommandItems(PanelFrame& frame, CommandGroup group) {
  for (const CommandInfo& info : Commands()) {
    if (info.group == group && info.command != ViewerCommand::kQuit) CommandItem(frame, info.command);
  }
}

void BeginBar(const char* name, float y, float width, float height) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      {ImGui::GetStyle().WindowPadding.x, (height - ImGui::GetFrameHeight()) / 2});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, theme::kRaised);
  BeginFixed(name, {0, y}, {width, height});
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

std::string SpeedText(double speed) {
  return std::isinf(speed) ? "max" : Formatted("%.3g\xc3\x97", speed);
}

}  // namespace

void Workspace::DrawMenus(PanelFrame& frame) {
  if (!ImGui::BeginMainMenuBar()) return;
  if (ImGui::BeginMenu("File")) {
    DrawFileMenu(frame);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("View")) {
    CommandItems(frame, CommandGroup::kCamera);
    ImGui::Separator();
    CommandItems(frame, CommandGroup::kOverlay);
    ImGui::Separator();
    CommandItems(frame, CommandGroup::kSound);
    if (ImGui::BeginMenu("Sharpness of the scene")) {
      CommandItems(frame, CommandGroup::kScale);
      ImGui::EndMenu();
    }
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Run")) {
    CommandItems(frame, CommandGroup::kRun);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Agents")) {
    CommandItems(frame, CommandGroup::kSelection);
    ImGui::Separator();
    for (const world::AgentSnapshot& agent : frame.scene.agents) {
      const IdScope id(static_cast<int>(agent.id));
      if (ImGui::MenuItem(agent.name.c_str(), agent.team.c_str(), agent.id == frame.selected))
        frame.selected = agent.id;
    }
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Panels")) {
    for (const workbench::PanelInfo& info : workbench::kPanelInfos) {
      const std::string keys = std::string("Alt+") + info.key;
      if (ImGui::MenuItem(info.title.data(), keys.c_str(), layout.IsVisible(info.id))) {
        if (layout.IsVisible(info.id)) {
          layout.Close(info.id);
        } else {
          only_picture = false;
          layout.Show(info.id);
        }
      }
      Tooltip(info.about);
    }
    ImGui::Separator();
    DrawActions(frame, "Panels");
    if (ImGui::BeginMenu("Layouts")) {
      DrawLayoutMenu(frame);
      ImGui::EndMenu();
    }
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Find")) {
    DrawActions(frame, "Find");
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Help")) {
    DrawActions(frame, "Help");
    if (ImGui::BeginMenu("Lessons", !frame.contents.lessons.empty())) {
      int number = 0;
      for (const workbench::LessonOffer& lesson : frame.contents.lessons) {
        const std::string title = std::to_string(++number) + ". " + lesson.title;
        if (ImGui::MenuItem(title.c_str(), lesson.is_passed ? "done" : nullptr))
          frame.Ask(workbench::LessonRequest{workbench::LessonRequest::What::kOpen, lesson.name});
      }
      ImGui::EndMenu();
    }
    Tooltip("Learn Soar step by step: each lesson has a task, hints, and checks that show whether it is done");
    ImGui::EndMenu();
  }
  ImGui::EndMainMenuBar();
}

void Workspace::DrawFileMenu(PanelFrame& frame) {
  DrawActions(frame, "File");
  if (ImGui::BeginMenu("Open recent", !frame.contents.recent.empty())) {
    for (const std::string& recent : frame.contents.recent)
      if (ImGui::MenuItem(recent.c_str())) frame.Ask(workbench::OpenRunRequest{recent});
    ImGui::EndMenu();
  }
  ImGui::Separator();
  CommandItem(frame, ViewerCommand::kQuit);
}

void Workspace::DrawLayoutMenu(PanelFrame& frame) {
  DrawActions(frame, kLayouts);
  if (const std::vector<std::string> saved = SavedLayouts(); !saved.empty() && ImGui::BeginMenu("Delete")) {
    for (const std::string& name : saved)
      if (ImGui::MenuItem(name.c_str()))
        if (const Result<void> gone = RemoveLayout(name); !gone) layout_fault_ = gone.error().message;
    ImGui::EndMenu();
  }
  ImGui::Separator();
  ImGui::Dummy({frame.Px(190), 0});  // Wide enough for the field's hint.
  SearchField("##name", "Save as: a name, Enter", layout_name_, frame.Px(1));
  if (WasEntered() && !layout_name_.empty()) {
    const Result<void> kept = SaveLayoutAs(layout_name_, layout);
    layout_fault_ = kept ? std::string{} : kept.error().message;
    if (kept) {
      frame.Ask(workbench::TellRequest{"Layout saved as " + layout_name_});
      layout_name_.clear();
    }
  }
  if (!layout_fault_.empty()) ColoredText(theme::kBad, layout_fault_);
}

void Workspace::UseLayout(Layout wanted) {
  wanted.light = layout.light;
  wanted.SetText(layout.text_percent);
  layout = std::move(wanted);
  only_picture = false;
}

std::vector<Finder::Action> Workspace::Actions(PanelFrame& frame) {
  const auto side = [this](Area area) { return [this, area] { layout.at(area).shown = !layout.at(area).shown; }; };
  const auto text = [this](int more) { return [this, more] { layout.SetText(layout.text_percent + more); }; };
  std::vector<Finder::Action> actions{
      {"File", "Open scenario ...", "Ctrl+O", "", [this] { Find(Finder::For::kScenario); }},
      {"File", "Open recording ...", "Ctrl+Shift+O", "", [this] { Find(Finder::For::kRecording); }},
      {"File", "Save picture", "",
       "Writes the window as soarbox-TICK.png into the folder where the program was started; replaces no file",
       [&frame] { frame.Ask(workbench::SavePictureRequest{}); }},
      {"Panels", "Left side", "", "", side(Area::kLeft), layout.at(Area::kLeft).shown},
      {"Panels", "Right side", "", "", side(Area::kRight), layout.at(Area::kRight).shown},
      {"Panels", "Bottom", "", "", side(Area::kBottom), layout.at(Area::kBottom).shown},
      {"Panels", "Picture only", "F11", "", [this] { only_picture = !only_picture; }, only_picture},
      {"Panels"},
      {"Panels", "Larger text", "Ctrl +", "", text(25)},
      {"Panels", "Smaller text", "Ctrl -", "", text(-25)},
      {"Panels", "Normal text", "Ctrl 0", "", text(100 - layout.text_percent)},
      {"Panels"},
      {"Panels", "Light colors", "", "", [this] { layout.light = !layout.light; }, layout.light},
      {"Panels", "Reset the layout", "", "", [this] { UseLayout(DefaultLayout()); }},
      {"Find", "Find anything ...", "Ctrl+Shift+P",
       "Commands, panels, agents, rules, files, and any text in rules, memory and trace",
       [this] { Find(Finder::For::kAnything); }},
      {"Find", "Search in the panel", "Ctrl+F", "", [this] { FocusField(); }},
      {"Help", "Keys and mouse", "?", "", [this] { show_help = true; }},
      {"Help", "First steps", "", "Leads you through the window, one thing at a time",
       [this] {
         layout.first_steps = !layout.first_steps;
         first_steps_.Begin();
       },
       layout.first_steps}};
  const auto add = [&](const std::string& name, std::string about) {
    actions.push_back({kLayouts, name, "", std::move(about), [this, name] {
                         if (const auto found = FindLayout(name, layout)) UseLayout(*found);
                       }});
  };
  for (const NamedLayout& shipped : ShippedLayouts()) add(std::string(shipped.name), std::string(shipped.about));
  for (const std::string& name : SavedLayouts()) add(name, "saved");
  return actions;
}

void Workspace::DrawActions(PanelFrame& frame, std::string_view menu) {
  for (const Finder::Action& action : Actions(frame)) {
    if (action.menu != menu) continue;
    if (action.title.empty())
      ImGui::Separator();
    else if (ImGui::MenuItem(action.title.c_str(), action.keys.c_str(), action.is_on))
      action.act();
    Tooltip(action.about);
  }
}

void Workspace::DrawToolbar(PanelFrame& frame, const Metrics& m, float frames_per_second) {
  BeginBar("Run", m.menu, m.width, m.toolbar);
  const RunStatus& status = frame.status;
  // Time and tick have priority: if there is not enough space, buttons have no words.
  const std::string state = status.paused ? "Paused" : frame.contents.moment.is_live ? "Running" : "Replaying";
  const std::string clock = "   " + TimeText(frame.scene.time_s) + "   tick " + std::to_string(frame.scene.tick);
  const auto width_of = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  const float pad = ImGui::GetStyle().FramePadding.x, gap = ImGui::GetStyle().ItemSpacing.x;
  const float icon = ImGui::GetFontSize() + 2 * pad + frame.Px(4);
  using workbench::Flow;
  const auto word_of = [](Flow flow) { return workbench::InfoOf(flow).button; };
  float words_width = 0;
  for (const Flow flow :
       {Flow::kTogglePause, Flow::kStepTick, Flow::kStepDecision, Flow::kStepPhase, Flow::kReset, Flow::kNextSeed})
    words_width += width_of(std::string(word_of(flow))) + 0.6f * pad;
  const float speed_width = width_of("Speed") + frame.Px(40 + 80 + 4) + 3 * gap + ButtonWidth("Max");
  const float rest =
      6 * icon + frame.Px(28) + 2 * gap + width_of(state + clock) + 2 * ImGui::GetStyle().WindowPadding.x;
  const bool has_words = rest + speed_width + words_width <= m.width;
  const bool has_slider = rest + speed_width <= m.width;
  const auto button = [&](Icon sign, ViewerCommand command, std::string_view word, bool enabled = true) {
    const CommandInfo& info = InfoOf(command);
    std::string tip = std::string(info.title) + "  (" + std::string(info.keys) + ")\n" + std::string(info.meaning);
    if (IconButton(sign, info.title.data(), has_words ? word : std::string_view{}, tip, enabled))
      frame.Command(command);
    ImGui::SameLine(0, frame.Px(4));
  };
  button(status.paused ? Icon::kPlay : Icon::kPause, ViewerCommand::kTogglePause,
         status.paused ? "Run" : word_of(Flow::kTogglePause));
  button(Icon::kStepTick, ViewerCommand::kSingleStep,
         word_of(frame.contents.moment.turn_ticks > 1 ? Flow::kStepTurn : Flow::kStepTick));
  const bool is_run = !frame.contents.moment.is_recording;
  button(Icon::kStepDecision, ViewerCommand::kStepDecision, word_of(Flow::kStepDecision),
         is_run && frame.contents.has_mind);
  button(Icon::kStepPhase, ViewerCommand::kStepPhase, word_of(Flow::kStepPhase), is_run && frame.contents.has_mind);
  ImGui::SameLine(0, frame.Px(14));
  button(Icon::kReset, ViewerCommand::kReset, word_of(Flow::kReset));
  button(Icon::kNextSeed, ViewerCommand::kNextSeed, word_of(Flow::kNextSeed), is_run);
  ImGui::SameLine(0, frame.Px(14));

  if (has_slider) {
    ImGui::AlignTextToFramePadding();
    ColoredText(theme::kQuiet, "Speed");
    ImGui::SameLine();
    const float number_x = ImGui::GetCursorPosX();
    ImGui::TextUnformatted(SpeedText(status.speed).c_str());
    ImGui::SameLine(number_x + frame.Px(40));
    float speed = std::isinf(status.speed) ? 16.0f : static_cast<float>(status.speed);
    ImGui::SetNextItemWidth(frame.Px(80));
    constexpr ImGuiSliderFlags kFlags = ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput;
    if (ImGui::SliderFloat("##speed", &speed, 0.1f, 16, "", kFlags)) frame.Ask(workbench::SpeedRequest{speed});
    Tooltip("Simulated seconds per second of yours; keys + and -");
    ImGui::SameLine(0, frame.Px(4));
    if (ImGui::Button("Max")) frame.Command(ViewerCommand::kUnlimited);
    Tooltip(InfoOf(ViewerCommand::kUnlimited).meaning);
  }

  // At the right, as far as there is space: the current activity.
  std::string words = state, details = clock;
  const std::size_t agents = frame.scene.agents.size();
  std::string more = "   ";
  more.append(std::to_string(agents)).append(agents == 1 ? " agent" : " agents");
  if (frames_per_second > 0) more += Formatted("   %.0f fps", static_cast<double>(frames_per_second));
  ImGui::SameLine();
  const float left = ImGui::GetCursorPosX(), room = m.width - left - ImGui::GetStyle().WindowPadding.x;
  const auto width = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  if (width(words + details + more) > room) more.clear();
  if (width(words + details) > room) words.clear();
  if (width(words + details) > room) {
    details.clear();
    NoteTooSmall("the toolbar has no room for time and tick");
  }
  if (width(words) <= room) {
    ImGui::SetCursorPosX(left + room - width(words + details + more));
    ImGui::AlignTextToFramePadding();
    ColoredText(status.paused ? theme::kWarn : theme::kGood, words);
    ImGui::SameLine(0, 0);
    ColoredText(theme::kText, details);
    ImGui::SameLine(0, 0);
    ColoredText(theme::kQuiet, more);
    Tooltip(status.message);
  }
  ImGui::End();
}

void Workspace::DrawScrubber(PanelFrame& frame, const Metrics& m) {
  BeginBar("Time", m.height - m.scrubber, m.width, m.scrubber);
  const workbench::Moment& at = frame.contents.moment;
  const auto seek = [&](std::uint64_t tick) {
    frame.Ask(workbench::SeekRequest{std::clamp(tick, at.first_tick, at.last_tick)});
  };
  const bool offers_resume = !at.is_live && !at.is_recording;
  const bool is_newest = at.is_live || (at.is_recording && at.shown_tick >= at.last_tick);
  const char* const newest = at.is_recording ? "End" : "Live";
  const bool can = at.can_go_back;
  const char* const hint = can ? "" : "There is nothing to go back to yet";
  const auto tip = [&](const char* text) { return can ? std::string(text) : std::string(hint); };
  if (IconButton(Icon::kToBegin, "begin", "", tip("To the beginning"), can)) seek(at.first_tick);
  ImGui::SameLine(0, frame.Px(3));
  if (IconButton(Icon::kStepBack, "back", "", tip("Back by a tick"), can && at.shown_tick > at.first_tick))
    seek(at.shown_tick - 1);
  ImGui::SameLine(0, frame.Px(3));
  if (IconButton(Icon::kPlay, "on", "", tip("On by a tick"), can && !is_newest)) seek(at.shown_tick + 1);
  ImGui::SameLine(0, frame.Px(8));

  const std::string now = TimeOf(frame, at.shown_tick) + " / " + TimeOf(frame, at.last_tick);
  const float pad = ImGui::GetStyle().FramePadding.x, icon = ImGui::GetFontSize() + 2 * pad;
  const auto word = [&](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x + icon + 0.6f * pad; };
  const std::string resume(workbench::kResumeButton);
  float right = ImGui::CalcTextSize(now.c_str()).x + frame.Px(16) + word(newest) + frame.Px(6);
  if (offers_resume) right += word(resume) + frame.Px(6);
  ImGui::SetNextItemWidth(
      std::max(frame.Px(60), m.width - ImGui::GetCursorPosX() - right - ImGui::GetStyle().WindowPadding.x));
  const std::uint64_t least = at.first_tick, most = std::max(at.last_tick, at.first_tick + 1);
  std::uint64_t tick = at.shown_tick;
  ImGui::BeginDisabled(!can);
  if (offers_resume) ImGui::PushStyleColor(ImGuiCol_SliderGrab, theme::kWarn);
  if (ImGui::SliderScalar("##scrubber", ImGuiDataType_U64, &tick, &least, &most, "")) seek(tick);
  if (offers_resume) ImGui::PopStyleColor();
  ImGui::EndDisabled();
  Tooltip(tip("Drag to see any moment of the run: scene, panels and plots go along"));
  ImGui::SameLine(0, frame.Px(8));
  ColoredText(at.is_live || at.is_recording ? theme::kText : theme::kWarn, now);
  ImGui::SameLine(0, frame.Px(8));
  if (offers_resume) {
    const std::string about = at.can_resume ? "The run continues from this moment; the old future stays as ghosts, "
                                              "for comparison"
                                            : at.resume_refusal;
    if (IconButton(Icon::kBranch, "resume", resume, about, at.can_resume, true)) frame.Ask(workbench::ResumeRequest{});
    ImGui::SameLine(0, frame.Px(6));
  }
  const char* const to_newest = is_newest         ? "This is the newest moment"
                                : at.is_recording ? "To the end of the recording"
                                                  : workbench::kLiveTitle.data();
  if (IconButton(Icon::kToEnd, "live", newest, to_newest, !is_newest)) frame.Ask(workbench::LiveRequest{});
  ImGui::End();
}

void Workspace::DrawHelp(PanelFrame& frame, int width, int height) {
  ImGui::SetNextWindowPos({static_cast<float>(width) / 2, static_cast<float>(height) / 2}, ImGuiCond_Always,
                          {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(frame.Px(860), static_cast<float>(width) - 20),
                            std::min(frame.Px(600), static_cast<float>(height) - 20)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8);
  ImGui::SetNextWindowFocus();
  BeginOver("Keys and mouse", &show_help);
  ImGui::PopStyleVar();
  using Row = std::pair<std::string_view, std::string_view>;
  const auto table = [&](const char* title, std::span<const Row> rows) {
    Heading(frame, title);
    float width = frame.Px(110);
    for (const auto& [key, what] : rows) width = std::max(width, ImGui::CalcTextSize(std::string(key).c_str()).x);
    const FactTable keys(title, width, ImGuiTableFlags_RowBg);
    for (const auto& [key, what] : rows)
      if (keys.Name(key, theme::kAccent)) WrappedText(what);
  };
  const auto group = [&](const char* title, CommandGroup wanted) {
    std::vector<Row> rows;
    for (const CommandInfo& info : Commands()) {
      if (info.group == wanted) rows.emplace_back(info.keys, info.title);
    }
    table(title, rows);
    ImGui::Dummy({1, frame.Px(6)});
  };
  constexpr Row kPanelRows[] = {{"Alt + letter", "Brings a panel to the front: the menu Panels shows the letters"},
                                {"Ctrl+F", "Search in the panel under the mouse"},
                                {"Ctrl+Shift+P", "Find anything: commands, agents, rules, files, texts"},
                                {"Ctrl+O, Ctrl+Shift+O", "Open a scenario, a recording"},
                                {"Ctrl+C", "Copy what the panel under the mouse shows"},
                                {"Up, Down", "In a list that was clicked: the row above, below"},
                                {"F11", "Picture only, or with panels"},
                                {"Ctrl +, Ctrl -", "Larger, smaller text; Ctrl 0: normal"},
                                {"Right click", "On a tab: move or close the panel; or drag the tab to another side"},
                                {"Up, Down, Tab", "In the console: earlier lines, completion"},
                                {"? or H", "This list"}};
  constexpr Row kMouseRows[] = {{"Left click", "Select an agent; with Shift or Ctrl, several"},
                                {"Left drag", "Select all in a box"},
                                {"Right drag", "Look around, or circle"},
                                {"Middle drag", "Move"},
                                {"Wheel", "Zoom, or fly ahead"}};
  ImGui::Columns(2, "help", false);
  group("The run", CommandGroup::kRun);
  group("The camera", CommandGroup::kCamera);
  group("The selection", CommandGroup::kSelection);
  group("Sound", CommandGroup::kSound);
  ImGui::NextColumn();
  group("Drawn over the scene", CommandGroup::kOverlay);
  table("Panels", kPanelRows);
  ImGui::Dummy({1, frame.Px(6)});
  table("Mouse, on the scene", kMouseRows);
  ImGui::Columns(1);
  ImGui::End();
}

}  // namespace soarbox::viewer
