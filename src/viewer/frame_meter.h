// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

namespace soarbox::viewer {

/// Measures the cost of frames while a script plays the user; long-running tests read it. It uses the processor time of
/// the window's thread, so that the load of the machine changes little. Call it on that thread only.
class FrameMeter {
 public:
  FrameMeter() { Begin(); }

  /// Call these before and after drawing the panels, once per frame.
  void BeginPanels();
  void EndPanels();
  /// Call it when the frame's draw data are complete: notes the vertices of the largest window.
  void NoteDrawn();

  /// Returns one line of JSON with the cost of the frames since the last call and the current memory of the process:
  /// {"event":"measure","name":NAME,"time":30.0,"frames":40,"frame_ms":2.1,"panels_ms":1.0,"corners":5120,
  /// "memory_mb":310}
  std::string Read(const std::string& name, double time_s);

 private:
  void Begin();

  std::uint64_t frames_ = 0;
  double began_s_ = 0, panels_began_s_ = 0, panels_s_ = 0;  ///< Of this thread's processor time.
  int most_corners_ = 0;
};

}  // namespace soarbox::viewer
