// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "viewer/panels/panel.h"
#include "workbench/document/document.h"

namespace soarbox::viewer {

/// The lines that were sent by command fields, for the arrow keys.
struct CommandHistory {
  std::vector<std::string> lines;
  std::size_t at = 0;
};

/// A field for commands in a document: Tab completes the typed line, and the arrow keys bring earlier lines back.
class CommandField {
 public:
  /// Draws the field with its label. Leaves `right` px free at the right. Returns true if Enter was pressed.
  bool Draw(PanelFrame& frame, const workbench::document::Field& field, float right, CommandHistory& history);
  /// The next Draw gives the keyboard to the field.
  void Focus() { wants_focus_ = true; }
  /// Whether the field had the keyboard when it was last drawn.
  bool is_active() const { return is_active_; }
  const std::string& text() const { return line_; }
  /// The words that Tab offers, in one line; empty if there are fewer than two.
  const std::string& offered() const { return offered_; }
  /// The line was sent: stores it in the history and empties the field, which keeps the keyboard.
  void Sent(CommandHistory& history);

 private:
  /// Applies the answer to the last Tab.
  void Complete(const workbench::document::CommandLine& command);
  static int OnEdit(ImGuiInputTextCallbackData* data);
  void Recall(ImGuiInputTextCallbackData& data);

  std::string line_, offered_, waiting_for_, replacement_;
  std::string kept_;  ///< The application's copy of line_.
  bool is_set_ = false, asks_ = false, replaces_ = false, wants_focus_ = false, is_active_ = false;
  CommandHistory* history_ = nullptr;  ///< While the field is drawn.
};

}  // namespace soarbox::viewer
