// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string_view>

#include "kernel/imagery/imagery_scene.h"

namespace soarbox::kernel::imagery {

/// Sends a line, which ends with a newline, to a viewer. Returns false after the viewer has disconnected.
using ViewerSink = std::function<bool(std::string_view line)>;

/// Shows a scene in a viewer, with the protocol of Soar's svs_viewer: first the entire scene, then each change.
class SceneFeed final : private SceneWatcher {
 public:
  SceneFeed(Scene& scene, const ViewerSink& sink);
  /// Removes the scene from the viewer.
  ~SceneFeed() override;
  SceneFeed(const SceneFeed&) = delete;
  SceneFeed& operator=(const SceneFeed&) = delete;

  /// Returns false after the viewer has disconnected.
  bool alive() const { return alive_; }

 private:
  void OnNode(Node& node, NodeChange change, std::string_view tag) override;
  void Send(const std::string& line);
  void SendNode(const Node& node, bool shape, bool pose);

  Scene& scene_;
  ViewerSink sink_;
  bool alive_ = true;
};

}  // namespace soarbox::kernel::imagery
