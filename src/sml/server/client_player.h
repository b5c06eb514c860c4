// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kernel/io/input_link.h"
#include "sml/server/client_log.h"

namespace soarbox::server {

class HostedAgent;
class KernelHost;

/// Does to the agents of a kernel what the lines of a client's log say (client_log.h), in place of the client.
///
/// Rules get the recorded answers of the client's functions. If an agent runs another way than it was recorded, because
/// its rules were edited, it gets all later input as it was recorded. Owned by KernelHost.
class ClientPlayer {
 public:
  explicit ClientPlayer(KernelHost& host) : host_(host) {}

  /// Carries out one line about an agent, given as its parts. Returns what did not go as recorded, or an empty text.
  std::string Play(HostedAgent& hosted, const std::vector<std::string>& parts);

  /// Whether the client implemented this right-hand-side function.
  bool Knows(std::string_view function) const { return functions_.contains(function); }
  /// What the client answered. The next recorded answer of this function to this argument, if there is one; else
  /// the last one. None if the client never answered that.
  std::optional<std::string> Answer(const HostedAgent* hosted, std::string_view function, std::string_view argument);
  /// While true, command lines run no agent: `go` does.
  bool is_in_line() const { return is_in_line_; }

 private:
  struct Answers {
    std::deque<std::string> next;
    std::optional<std::string> last;
  };
  using Parts = std::vector<std::string>;

  std::string Go(HostedAgent& hosted, const Parts& parts);
  std::string Line(HostedAgent& hosted, const std::string& line);
  std::string Add(HostedAgent& hosted, const Parts& parts);
  std::string Set(HostedAgent& hosted, const Parts& parts);
  std::string Remove(HostedAgent& hosted, const std::string& handle);

  KernelHost& host_;
  bool is_in_line_ = false;
  std::set<std::string, std::less<>> functions_;
  /// By agent's number, function and argument.
  std::map<std::pair<std::uint64_t, std::string>, Answers> answers_;
  /// By agent's number and recorded handle.
  std::map<std::pair<std::uint64_t, std::string>, kernel::InputElement> elements_;
  std::set<std::uint64_t> astray_;  ///< Agents of which it was reported that they run another way.
};

}  // namespace soarbox::server
