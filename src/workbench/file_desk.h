// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "debugger/rule_edit.h"
#include "workbench/contents.h"
#include "workbench/desk_common.h"
#include "workbench/drafts.h"
#include "workbench/requests.h"

namespace soarbox::workbench {

/// The files that the user edits. Unsaved text stays in memory while the user looks at another file, and is stored as a
/// draft on the disk until the file is saved.
class FileDesk {
 public:
  explicit FileDesk(const DeskCommon& common) : common_(common) {}

  /// The state that is passed on to the next run.
  struct Belongings;
  Belongings Take();
  void Bring(Belongings belongings);

  /// Opens a file of the run. Opens another file only if the user may browse, or if the file belongs to the user.
  void Edit(const EditRequest& request, const std::string& agent);
  void Change(const EditTextRequest& request);
  void SaveAll();
  bool HasUnsaved() const;
  /// The present text of an open file.
  std::optional<std::string> TextOf(const std::string& file) const;
  /// Call it before requests. If the file was opened in the last call and there is a draft, replaces the text by the
  /// draft. So the editor gets the text of the file first, and Undo can return to it.
  void ShowDraft();
  /// Call it after requests. Applies texts that waited for a rebuilt world. Reads the shown file again if another
  /// program has written it.
  void GoOn();
  /// The rebuilt past is left, with the texts that were applied to it, or the run continues from it and uses them.
  void EndPast(bool continues);
  /// Stores unsaved text on the disk.
  void KeepDrafts();
  /// Returns true once after each change that no request made.
  bool TakeNews() { return std::exchange(has_news_, false); }
  /// Returns true once after the user has applied changed rules or scripts to the live world, without errors.
  bool TakeApplied() { return std::exchange(has_applied_, false); }
  void Fill(Contents& contents) const;
  /// An open file, if the run uses its present text; else null.
  const debugger::Edit* FindRunning(const std::string& file) const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Open {
    debugger::Edit edit;
    EditContents contents;
    bool has_draft = false;                      ///< The text has changed since the draft on the disk was written.
    std::string failure = {};                    ///< Why it could not be saved.
    std::optional<std::uint64_t> apply_at = {};  ///< Apply the text to the minds of this tick once they are rebuilt.
    std::optional<std::string> draft = {};       ///< A draft to show after the file itself has been shown.
  };
  using Files = std::map<std::string, Open>;

  Open* Looked() {
    const auto found = files_.find(looked_);
    return found == files_.end() ? nullptr : &found->second;
  }
  /// Applies the file's rules to the world that is shown, as soon as that is available.
  void Apply(Open& file);
  void Save(Open& file);
  void LookAtDisk();

  const DeskCommon& common_;
  Drafts drafts_{Drafts::Folder()};
  Files files_;
  std::string looked_;  ///< The file that the panel shows; empty: none.
  std::uint64_t version_ = 0;
  std::optional<std::uint64_t> changed_past_;  ///< The past tick to whose world a text was applied.
  Clock::time_point looked_at_disk_;
  bool has_news_ = false, has_applied_ = false;
};

struct FileDesk::Belongings {
  Files files;
  std::string looked;
  std::uint64_t version = 0;
};

}  // namespace soarbox::workbench
