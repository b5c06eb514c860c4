// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <string_view>

#include "kernel/imagery/scene.h"

namespace soarbox::kernel::imagery {

/// Sends a line, which ends with a newline, to a viewer; false once the viewer has gone.
using ViewerSink = std::function<bool(std::string_view line)>;

/// Shows a scene to a viewer in the protocol of Soar's svs_viewer, from now on: first all of it, then what changes.
class SceneFeed final : private SceneWatcher {
 public:
  SceneFeed(Scene& scene, const ViewerSink& sink);
  /// Removes the scene from the viewer's picture.
  ~SceneFeed() override;
  SceneFeed(const SceneFeed&) = delete;
  SceneFeed& operator=(const SceneFeed&) = delete;

  /// False once the viewer has gone.
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
