// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/agent.h"
#include "sml/server/connection.h"
#include "sml/server/tag_map.h"

namespace soarbox::server {

class ClientLog;
class HostedAgent;

/// The input of one agent as its clients see it. Maps the clients' (negative) time tags and names of identifiers to the
/// kernel's elements and objects. Changes reach working memory in the agent's next input phase. Unknown tags and
/// parents are ignored, as the protocol requires.
class AgentInput {
 public:
  explicit AgentInput(kernel::Agent& agent) : agent_(agent) {}

  /// Adds an element. Clients in this process store the handle; for others see AddByTag.
  kernel::InputElement Add(const InputWme& wme);
  /// Replaces the element by one with another value and tag. Adds it if the handle is none.
  kernel::InputElement Update(kernel::InputElement element, const InputWme& wme);
  void Remove(kernel::InputElement element);

  /// Adds an element that will be identified by its tag.
  void AddByTag(const InputWme& wme);
  /// Removes the element with this tag, whichever client created it.
  void RemoveByTag(long long tag);

  /// The kernel's name of an identifier that a client named; empty if there is none yet.
  std::string KernelName(std::string_view client_name) const;
  /// The time tags by which clients know the elements; the kernel's own tag if no client created the element.
  std::vector<std::pair<kernel::WmeId, long long>> ClientTags() const;
  /// Reports each change to the log from now on. Neither argument is owned.
  void SetLog(ClientLog* log, HostedAgent& hosted) {
    log_ = log;
    hosted_ = &hosted;
  }
  /// init-soar: forgets all tags and names.
  void Clear();
  /// Forgets tags of removed elements. Cheap, unless many tags were added since the last call.
  void Tidy();

 private:
  kernel::InputObject Resolve(const InputWme& wme);
  kernel::InputObject Resolve(std::string_view name);
  kernel::InputValue Value(const InputWme& wme);
  kernel::InputElement AddUnlogged(const InputWme& wme);

  kernel::Agent& agent_;
  ClientLog* log_ = nullptr;
  HostedAgent* hosted_ = nullptr;  ///< For the log.
  TagMap<kernel::InputElement> elements_;
  std::map<std::string, kernel::InputObject, std::less<>> objects_;  ///< By client name.
  std::size_t tidy_elements_at_ = 256;
  std::size_t tidy_objects_at_ = 64;
};

}  // namespace soarbox::server
