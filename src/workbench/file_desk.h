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

/// Files that are edited. What was typed into one stays while another is looked at, and as a draft on the disk until it
/// is saved.
class FileDesk {
 public:
  explicit FileDesk(const DeskCommon& common) : common_(common) {}

  /// What outlives a run.
  struct Belongings;
  Belongings Take();
  void Bring(Belongings belongings);

  /// A file that the run was made from; others only where the user may browse.
  void Edit(const EditRequest& request, const std::string& agent);
  void Change(const EditTextRequest& request);
  void SaveAll();
  bool HasUnsaved() const;
  /// Before requests: shows a draft, once the file itself was shown, so that it can be undone.
  void ShowDraft();
  /// After requests: reloads what waits for its moment, and takes over what other programs have written.
  void GoOn();
  /// Keeps what was typed and not saved on the disk.
  void KeepDrafts();
  /// True once after each change that no request made.
  bool TakeNews() { return std::exchange(has_news_, false); }
  void Fill(Contents& contents) const;
  /// The text of an open file that runs as it was typed; null if there is none.
  const debugger::Edit* FindRunning(const std::string& file) const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Open {
    debugger::Edit edit;
    EditContents contents;
    bool has_draft = false;                      ///< The draft on the disk is not what was typed.
    std::string failure = {};                    ///< Why it could not be saved.
    std::optional<std::uint64_t> apply_at = {};  ///< To be applied to the minds of this tick, once they are rebuilt.
    std::optional<std::string> draft = {};       ///< To be shown once the file itself was.
  };
  using Files = std::map<std::string, Open>;

  Open* Looked() {
    const auto found = files_.find(looked_);
    return found == files_.end() ? nullptr : &found->second;
  }
  /// Reloads the file's rules into the world that is looked into, as soon as that is there.
  void Apply(Open& file);
  void Save(Open& file);
  void LookAtDisk();

  const DeskCommon& common_;
  Drafts drafts_{Drafts::Folder()};
  Files files_;
  std::string looked_;  ///< The one of them that is looked at; empty: none.
  std::uint64_t version_ = 0;
  Clock::time_point looked_at_disk_;
  bool has_news_ = false;
};

struct FileDesk::Belongings {
  Files files;
  std::string looked;
  std::uint64_t version = 0;
};

}  // namespace soarbox::workbench
