// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::world {

/// Numbers for the names of teams, so that searches among agents compare numbers instead of names. A name has a number
/// as long as it has members. Then its number is used for other names.
class TeamNumbers {
 public:
  static constexpr std::uint32_t kNone = 0;  ///< No team has this number.

  /// Adds a member and returns the team's number.
  std::uint32_t Join(std::string_view team) {
    auto found = teams_.find(team);
    if (found == teams_.end()) found = teams_.emplace(team, Team{TakeNumber(), 0}).first;
    ++found->second.members;
    return found->second.number;
  }
  /// Removes a member that has joined before.
  void Leave(std::string_view team) {
    const auto found = teams_.find(team);
    if (found == teams_.end() || --found->second.members > 0) return;
    free_.push_back(found->second.number);
    teams_.erase(found);
  }
  /// kNone if the team has no members.
  std::uint32_t Find(std::string_view team) const {
    const auto found = teams_.find(team);
    return found == teams_.end() ? kNone : found->second.number;
  }

 private:
  struct Team {
    std::uint32_t number = kNone;
    std::size_t members = 0;
  };

  std::uint32_t TakeNumber() {
    if (free_.empty()) return ++last_;
    const std::uint32_t number = free_.back();
    free_.pop_back();
    return number;
  }

  std::map<std::string, Team, std::less<>> teams_;
  std::vector<std::uint32_t> free_;  ///< Numbers that were used before.
  std::uint32_t last_ = kNone;
};

}  // namespace soarbox::world
