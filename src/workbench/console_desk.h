// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "debugger/console.h"
#include "workbench/contents.h"
#include "workbench/desk_common.h"
#include "workbench/drafts.h"
#include "workbench/requests.h"

namespace soarbox::workbench {

/// The consoles of the agents: lines that were typed and printed, and unsent lines.
class ConsoleDesk {
 public:
  /// `world` is the file that the run was made from. Drafts of lines are stored under its name.
  ConsoleDesk(const DeskCommon& common, std::filesystem::path world) : common_(common), world_(std::move(world)) {}

  /// The state that is passed on to the next run.
  struct Belongings {
    std::map<std::string, debugger::Console> consoles;
    std::map<std::string, std::uint64_t> counts;
  };
  Belongings Take() { return {std::move(consoles_), std::move(counts_)}; }
  void Bring(Belongings belongings);

  void Type(const ConsoleRequest& request);
  void Complete(const CompleteRequest& request);
  void Keep(const KeepLineRequest& request) { unsent_[request.agent] = {request.line, true}; }
  void Clear(const std::string& agent) { ConsoleOf(agent).Clear(); }
  /// Adds a tick's events to the consoles of their agents.
  void Add(const sim::EventList& events);
  /// Saves unsent lines to the disk.
  void KeepDrafts();
  void Fill(Contents& contents);

 private:
  /// A line that the user has typed but not sent.
  struct UnsentLine {
    std::string text;
    bool has_draft = false;  ///< It has changed since the draft on the disk was written.
  };

  debugger::Console& ConsoleOf(const std::string& agent) { return consoles_.try_emplace(agent, agent).first->second; }
  /// The unsent line of this agent, from this process or from a draft on the disk.
  const std::string& BegunLine(const std::string& agent);
  /// The name under which the agent's line is stored as a draft. No file of this name exists.
  std::filesystem::path PlaceOfLine(const std::string& agent) const {
    return std::filesystem::path(world_).concat(" console of " + agent);
  }

  const DeskCommon& common_;
  std::filesystem::path world_;
  Drafts drafts_{Drafts::Folder()};
  std::map<std::string, debugger::Console> consoles_;
  std::map<std::string, std::uint64_t> counts_;  ///< By agent: incremented for each new line.
  std::map<std::string, UnsentLine> unsent_;     ///< By agent: agents that were selected, or for which Keep was called.
  std::string completed_line_;
  debugger::Completion completion_;
};

}  // namespace soarbox::workbench
