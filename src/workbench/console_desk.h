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

/// The command lines of agents: what was typed and printed, and lines that are begun.
class ConsoleDesk {
 public:
  /// `world` is the file that the run was made from, for the drafts of lines.
  ConsoleDesk(const DeskCommon& common, std::filesystem::path world) : common_(common), world_(std::move(world)) {}

  /// What outlives a run.
  struct Belongings {
    std::map<std::string, debugger::Console> consoles;
    std::uint64_t lines = 0;
  };
  Belongings Take() { return {std::move(consoles_), lines_}; }
  void Bring(Belongings belongings);

  void Type(const ConsoleRequest& request);
  void Complete(const CompleteRequest& request);
  void Keep(const KeepLineRequest& request) { unsent_[request.agent] = {request.line, true}; }
  void Clear(const std::string& agent) { ConsoleOf(agent).Clear(); }
  /// Adds what others made the agents do in a tick.
  void Add(const sim::EventList& events);
  /// Keeps lines that are begun on the disk.
  void KeepDrafts();
  void Fill(Contents& contents);

 private:
  /// A line that was typed and not sent.
  struct UnsentLine {
    std::string text;
    bool has_draft = false;  ///< The draft on the disk is another one.
  };

  debugger::Console& ConsoleOf(const std::string& agent) { return consoles_.try_emplace(agent, agent).first->second; }
  /// The line that was begun for this agent, here or in an earlier session.
  const std::string& BegunLine(const std::string& agent);
  /// The name under which drafts keep the agent's line: no such file exists.
  std::filesystem::path PlaceOfLine(const std::string& agent) const {
    return std::filesystem::path(world_).concat(" console of " + agent);
  }

  const DeskCommon& common_;
  std::filesystem::path world_;
  Drafts drafts_{Drafts::Folder()};
  std::map<std::string, debugger::Console> consoles_;
  std::uint64_t lines_ = 0;                   ///< Grows with each new line.
  std::map<std::string, UnsentLine> unsent_;  ///< By agent, of those that were looked at.
  std::string completed_line_;
  debugger::Completion completion_;
};

}  // namespace soarbox::workbench
