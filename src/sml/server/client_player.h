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

/// Executes the lines of a client's log (client_log.h) on the agents of a kernel, in place of the client.
///
/// Rules receive the recorded answers of the client's functions. If an agent runs differently from the recording,
/// because its rules were edited, it still receives all later input as recorded. Owned by KernelHost.
class ClientPlayer {
 public:
  explicit ClientPlayer(KernelHost& host) : host_(host) {}

  /// Executes one line about an agent, given as its parts. Returns a description of the difference if the result was
  /// not as recorded, else an empty text.
  std::string Play(HostedAgent& hosted, const std::vector<std::string>& parts);

  /// Whether the client implemented this right-hand-side function.
  bool Knows(std::string_view function) const { return functions_.contains(function); }
  /// The client's answer to a call: the next recorded answer of this function for this argument; if there are no more,
  /// the last one. None if there never was one.
  std::optional<std::string> Answer(const HostedAgent* hosted, std::string_view function, std::string_view argument);
  /// While true, command lines do not run agents; `go` does.
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
  std::set<std::uint64_t> astray_;  ///< Agents for which a difference in their runs was already reported.
};

}  // namespace soarbox::server
