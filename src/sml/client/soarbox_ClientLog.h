// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "Export.h"

namespace sml {
class Agent;
class Kernel;
}  // namespace sml

namespace soarbox {

/// Records what clients do to the agents of a kernel in this process from now on. Call it before the first agent is
/// created. The file is a recording for `soarbox replay`, `why` and so on. Without a file, the log can be read only by
/// ReadClientLog. Returns a description of the error, or an empty text. The environment variable SOARBOX_RECORD=FILE
/// has the same effect for each kernel.
std::string EXPORT RecordClients(sml::Kernel& kernel, const std::string& file);

/// A part of a kernel's log.
struct ClientLogPart {
  std::string text;        ///< Empty if there is nothing new.
  bool has_ended = false;  ///< The kernel has given up its log: nothing more will come.
};
/// Returns what clients did to the agents of a kernel in another process, from this byte of its log on
/// (sml/server/client_log.h). Returns none if the kernel keeps no log or does not answer. `soarbox kernel` keeps a log,
/// and so does every kernel that is being recorded.
std::optional<ClientLogPart> ReadClientLog(sml::Kernel& kernel, std::uint64_t from);

/// The parts of a line of a client's log (sml/server/client_log.h).
std::vector<std::string> PartsOfClientAct(std::string_view line);

/// A part in the escaped form that such a line contains.
std::string EscapedForClientAct(std::string_view part);

/// Executes a line of a client's log on an agent of a kernel in this process. Returns a description of the difference
/// if the result was not as recorded, else an empty text.
std::string PlayClientAct(sml::Agent& agent, const std::vector<std::string>& parts);

}  // namespace soarbox
