// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/engine/engine_channel.h"
#include "app/engine/engine_language.h"
#include "app/shape_contents.h"
#include "debugger/json.h"
#include "diagnostics/result.h"
#include "sim/input.h"
#include "stream/scene_encoder.h"
#include "workbench/contents.h"
#include "workbench/flow.h"
#include "workbench/pace.h"
#include "workbench/requests.h"

namespace soarbox::app {

/// The browsers that show an engine's run: their requests, and the messages to them (docs/serve_protocol.md). Only the
/// server distinguishes them.
class EnginePage {
 public:
  using Json = debugger::Json;

  /// Editing rules is supported for files below the folder.
  EnginePage(EngineChannel& channel, const std::filesystem::path& folder)
      : channel_(channel), language_(EngineLanguage::Make(folder)) {}

  /// Requests of pages since the last call.
  struct Asked {
    std::vector<workbench::Request> requests;
    std::vector<workbench::Flow> flows;
    std::optional<std::uint64_t> seed;  ///< Restart the world with this seed.
    std::optional<bool> pause;          ///< Pause or continue, whatever the current state is.
    std::vector<sim::InputValue> inputs;
    bool empty() const { return requests.empty() && flows.empty() && !pause && inputs.empty(); }
  };
  /// Reports that all requests so far have been executed.
  void Done() { channel_.Send(serve::FrameKind::kDone, {}); }
  /// Sends a heartbeat to the server, at most every 400 ms. Call it in each iteration of the loop.
  void ShowLife();
  /// Waits at most `most_ms` for requests, and adds them. Malformed ones are refused here.
  void Receive(int most_ms, Asked& asked);
  bool is_open() const { return channel_.is_open(); }
  /// No page is open: the world may pause.
  bool is_alone() const { return presence_.pages == 0; }
  struct Presence {
    int pages = 1;
    int controlling = 1;          ///< Pages that may control the run. Users of other pages may only watch.
    workbench::PanelSet watched;  ///< The panels that users who may only watch have open.
  };
  const Presence& presence() const { return presence_; }

  /// Reports that a run begins. Contents, shapes and the scene are then sent completely.
  void Hello(Json about);
  void Tell(const std::string& text) { Say({{"message", "told"}, {"text", text}}); }
  void Refuse(const Diagnostic& problem, const Json& id = {});
  /// `is_stopped`: a script is stopped in the middle of the tick.
  void ShowFlow(const workbench::Pace& pace, std::uint64_t tick, double time_s, bool is_stopped = false);
  /// Sends the changes of the contents that these panels show.
  void ShowContents(const workbench::Contents& contents, const workbench::PanelSet& panels);
  /// Whether the next scene must be complete, because a page has no scene yet.
  bool WantsFull() const { return wants_full_; }
  /// Whether it is time to send a scene. The interval is 30 to 100 ms, depending on the number of agents.
  bool WantsScene(std::size_t agents) const;
  /// `overlays` may be null.
  void ShowScene(const world::SceneSnapshot& scene, const world::OverlaySnapshot* overlays);
  const world::OverlayWants& overlay_wants() const { return overlay_wants_; }

 private:
  using Clock = std::chrono::steady_clock;
  void SayOfLanguage(const std::vector<std::string>& messages);
  void Say(const Json& message, serve::FrameKind kind = serve::FrameKind::kText);
  Result<void> Take(const Json& json, Asked& asked);

  EngineChannel& channel_;
  std::unique_ptr<EngineLanguage> language_;  ///< Null: this build has none.
  Presence presence_;
  bool shows_documents_ = false;  ///< Panels are sent as documents, because pages are served.
  stream::SceneEncoder encoder_;
  ShapeContents shapes_;
  bool wants_full_ = true;
  bool draws_ = true;  ///< Scenes and shapes are sent.
  world::OverlayWants overlay_wants_;
  Clock::time_point scene_at_, flow_at_, life_at_;
  std::string flow_;
  std::map<std::string, std::size_t, std::less<>>
      told_;  ///< By the name of contents: a hash of the last contents sent.
};

}  // namespace soarbox::app
