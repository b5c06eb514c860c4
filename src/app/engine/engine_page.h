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

/// The browsers that show an engine's run: what they ask for, and what they are told (docs/serve.md).
/// Only the server tells them apart.
class EnginePage {
 public:
  using Json = debugger::Json;

  /// Whoever types rules is helped with files below the folder.
  EnginePage(EngineChannel& channel, const std::filesystem::path& folder)
      : channel_(channel), language_(EngineLanguage::Make(folder)) {}

  /// What pages have asked for since.
  struct Asked {
    std::vector<workbench::Request> requests;
    std::vector<workbench::Flow> flows;
    std::optional<std::uint64_t> seed;  ///< From which the world begins again.
    std::optional<bool> pause;          ///< Asked for outright, whatever it was.
    std::vector<sim::InputValue> inputs;
    bool empty() const { return requests.empty() && flows.empty() && !pause && inputs.empty(); }
  };
  /// All that was asked so far has been carried out.
  void Done() { channel_.Send(serve::FrameKind::kDone, {}); }
  /// Tells the server twice a second that this process does not hang. Call it in each round of the loop.
  void ShowLife();
  /// Waits at most so long for something. What cannot be understood is refused here.
  Asked Receive(int most_ms);
  bool is_open() const { return channel_.is_open(); }
  /// Nobody looks: the world may stand still.
  bool is_alone() const { return pages_ == 0; }
  /// The panels that those who may only watch look at.
  const workbench::PanelSet& watched() const { return watched_; }

  /// A run begins: forgets what was known of the one before.
  void Hello(Json about);
  void Tell(const std::string& text) { Say({{"message", "told"}, {"text", text}}); }
  void Refuse(const Diagnostic& problem, const Json& id = {});
  void ShowFlow(const workbench::Pace& pace, std::uint64_t tick, double time_s);
  /// Tells what has changed of the contents that these panels show.
  void ShowContents(const workbench::Contents& contents, const workbench::PanelSet& panels);
  /// Whether the next scene is to be whole, as somebody has nothing to add it to.
  bool WantsFull() const { return wants_full_; }
  /// As often as a page can use it, given how much there is to see. Overlays may be null.
  bool WantsScene(std::size_t agents) const;
  void ShowScene(const world::SceneSnapshot& scene, const world::OverlaySnapshot* overlays);
  const world::OverlayWants& overlay_wants() const { return overlay_wants_; }

 private:
  using Clock = std::chrono::steady_clock;
  void SayOfLanguage(const std::vector<std::string>& messages);
  void Say(const Json& message, serve::FrameKind kind = serve::FrameKind::kText);
  Result<void> Take(const Json& json, Asked& asked);

  EngineChannel& channel_;
  std::unique_ptr<EngineLanguage> language_;  ///< Null: there is none.
  int pages_ = 1;
  bool shows_documents_ = false;  ///< Pages are served: panels are told as documents.
  workbench::PanelSet watched_;
  stream::SceneEncoder encoder_;
  ShapeContents shapes_;
  bool wants_full_ = true;
  world::OverlayWants overlay_wants_;
  Clock::time_point scene_at_, flow_at_, life_at_;
  std::string flow_;
  std::map<std::string, std::size_t, std::less<>> told_;  ///< By the name of contents: a hash of what was told last.
};

}  // namespace soarbox::app
