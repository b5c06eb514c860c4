// SPDX-License-Identifier: BSD-2-Clause
// The program soarbox-window: the commands of soarbox that open a window. It leaves the others to soarbox.
#include "app/command_line.h"
#include "app/window/replay_window.h"
#include "app/window/run_window.h"
#include "viewer/viewer.h"

namespace {

using namespace soarbox;

class ViewerWindow final : public app::Window {
 public:
  [[nodiscard]] std::optional<std::pair<int, int>> RoomOnDisplay() const override { return viewer::RoomOnDisplay(); }
  int Run(app::RunSession& session, const app::RunOptions& options, const sim::DataFolders& data,
          const app::WindowRun& run) const override {
    return app::RunWindow(session, options, data, run);
  }
  int Replay(record::Reader& recording, record::TickRange range, const sim::DataFolders& data,
             const app::RecordingOptions& options) const override {
    return app::ShowReplay(recording, range, data, options);
  }
};

}  // namespace

int main(int argc, char** argv) {
  const ViewerWindow window;
  return app::CommandLine(argc, argv, {&window, nullptr, nullptr});
}
