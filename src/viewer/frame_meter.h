// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

namespace soarbox::viewer {

/// What the window costs while a script plays its user: read by tests that let it run for long. Processor time of the
/// window's thread, so that a busy machine changes little. For that thread.
class FrameMeter {
 public:
  FrameMeter() { Begin(); }

  /// Around the drawing of the panels, once a frame.
  void BeginPanels();
  void EndPanels();
  /// When the frame is laid out: what its fullest window holds.
  void NoteDrawn();

  /// One line of JSON on what frames cost since the last call, and on the memory of the process now:
  /// {"event":"measure","name":"at 30
  /// s","time":30.0,"frames":40,"frame_ms":2.1,"panels_ms":1.0,"corners":5120,"memory_mb":310}
  std::string Read(const std::string& name, double time_s);

 private:
  void Begin();

  std::uint64_t frames_ = 0;
  double began_s_ = 0, panels_began_s_ = 0, panels_s_ = 0;  ///< Of this thread's processor time.
  int most_corners_ = 0;
};

}  // namespace soarbox::viewer
