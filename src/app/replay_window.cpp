// SPDX-License-Identifier: BSD-2-Clause
#include "app/replay_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "app/exit_codes.h"
#include "app/pace.h"
#include "app/run_session.h"
#include "viewer/viewer.h"

namespace soarbox::app {
namespace {

/// Where in a recording the user is, and what is shown there.
class ReplayHead {
 public:
  ReplayHead(record::Reader& recording, std::uint64_t first, std::uint64_t last)
      : recording_(recording), first_(first), last_(last), tick_(first) {}

  std::uint64_t tick() const { return tick_; }
  std::uint64_t last() const { return last_; }
  bool AtEnd() const { return tick_ == last_; }

  /// Goes so many ticks on, or back.
  void Move(std::int64_t ticks) {
    const auto at = static_cast<std::int64_t>(tick_) + ticks;
    Go(static_cast<std::uint64_t>(std::clamp(at, static_cast<std::int64_t>(first_), static_cast<std::int64_t>(last_))));
  }
  void Go(std::uint64_t tick) { tick_ = std::clamp(tick, first_, last_); }

  /// The scene of the tick; a damaged part of the recording shows the last scene that could be read and says so once.
  const world::SceneSnapshot& Scene() {
    if (shown_ == tick_) return scene_;
    shown_ = tick_;
    if (const Result<const record::TickRecord*> record = recording_.At(tick_)) {
      scene_ = (*record)->scene;
    } else if (!told_) {
      told_ = true;
      std::cerr << Format(record.error());
    }
    return scene_;
  }

 private:
  record::Reader& recording_;
  std::uint64_t first_, last_, tick_;
  std::uint64_t shown_ = ~std::uint64_t{0};
  world::SceneSnapshot scene_;
  bool told_ = false;
};

/// Arrow keys move by a second, with the page keys by ten; comma steps back; with insert and end it goes to the ends.
void Obey(const viewer::InputEvent& event, ReplayHead& head, Pace& pace, std::int64_t ticks_per_second) {
  if (event.kind != viewer::InputKind::kKey || !event.pressed) return;
  if (event.name == "left_key") head.Move(-ticks_per_second);
  if (event.name == "right_key") head.Move(ticks_per_second);
  if (event.name == "page_up_key") head.Move(-10 * ticks_per_second);
  if (event.name == "page_down_key") head.Move(10 * ticks_per_second);
  if (event.name == "insert_key") head.Go(0);
  if (event.name == "end_key") head.Go(head.last());
  if (event.name == "comma_key") {
    pace.Pause();
    head.Move(-1);
  }
  if (event.name == "space_key") pace.Obey(viewer::ViewerCommand::kTogglePause);
}

}  // namespace

bool CanShowReplay() {
  const char* display = std::getenv("DISPLAY");
  return display != nullptr && *display != '\0';
}

int ShowReplay(record::Reader& recording, record::TickRange range, const sim::DataFolders& data) {
  viewer::ViewerOptions window;
  window.width = static_cast<int>(std::min<std::uint32_t>(recording.header().screen_width_px, 7680));
  window.height = static_cast<int>(std::min<std::uint32_t>(recording.header().screen_height_px, 4320));
  window.title = "Soarbox replay: " + recording.file().filename().string();
  window.media_dir = data.media;
  window.frame_agents = true;
  window.on_diagnostic = [](const Diagnostic& diagnostic) { std::cerr << Format(diagnostic); };
  Result<std::unique_ptr<viewer::Viewer>> opened = viewer::Viewer::Open(window);
  if (!opened) {
    std::cerr << Format(opened.error());
    return kCannotStart;
  }
  viewer::Viewer& viewer = **opened;
  const double step_s = recording.header().step_s;
  const auto ticks_per_second = std::max<std::int64_t>(1, std::llround(1 / step_s));
  const std::uint64_t first = std::max(range.first, recording.first_tick());
  ReplayHead head(recording, first, std::max(first, std::min(range.last, recording.last_tick())));
  Pace pace(1);
  while (!WasInterrupted() && !pace.quit()) {
    viewer.SetStatus(
        {.paused = pace.paused(),
         .speed = pace.speed(),
         .message = fmt::format("replay {:.1f} of {:.1f} s{}", static_cast<double>(head.tick()) * step_s,
                                static_cast<double>(head.last()) * step_s, head.AtEnd() ? ", the end" : "")});
    viewer.Show(head.Scene());
    if (!viewer.RenderFrame()) break;
    for (const viewer::ViewerCommand command : viewer.TakeCommands()) pace.Obey(command);
    for (const viewer::InputEvent& event : viewer.TakeEvents()) Obey(event, head, pace, ticks_per_second);
    head.Move(pace.TicksDue(step_s));
  }
  return kOk;
}

}  // namespace soarbox::app
