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

/// The input of one agent in the words of its clients: their (negative) time tags and the names that they give to
/// identifiers, and the kernel's elements and objects behind them. Changes reach working memory in the agent's next
/// input phase. Unknown tags and parents are ignored, as the protocol has it.
class AgentInput {
 public:
  explicit AgentInput(kernel::Agent& agent) : agent_(agent) {}

  /// Adds an element. A client in this process keeps the handle; for others see AddByTag.
  kernel::InputElement Add(const InputWme& wme);
  /// Removes the element and adds it again with another value and tag. Adds it if the handle is none.
  kernel::InputElement Update(kernel::InputElement element, const InputWme& wme);
  void Remove(kernel::InputElement element);

  /// Adds an element that will be named by its tag.
  void AddByTag(const InputWme& wme);
  /// Removes the element with this tag, whichever client made it.
  void RemoveByTag(long long tag);

  /// The kernel's name for an identifier that a client named; empty if there is none yet.
  std::string KernelName(std::string_view client_name) const;
  /// The tag that a client knows an element by; the kernel's own if no client made it.
  std::vector<std::pair<kernel::WmeId, long long>> ClientTags() const;
  /// Tells the log of clients' acts of each change from now on. Neither is owned.
  void SetLog(ClientLog* log, HostedAgent& hosted) {
    log_ = log;
    hosted_ = &hosted;
  }
  /// init-soar: forgets all tags and names.
  void Clear();
  /// Forgets tags whose elements are gone. Cheap unless many have come since the last time.
  void Tidy();

 private:
  std::size_t NamedObjects() const { return objects_.size() + odd_objects_.size(); }
  kernel::InputObject Resolve(const InputWme& wme);
  kernel::InputObject Resolve(std::string_view name);
  const kernel::InputObject* FindNamed(std::string_view name) const;
  kernel::InputValue Value(const InputWme& wme);
  kernel::InputElement AddUnlogged(const InputWme& wme);

  kernel::Agent& agent_;
  ClientLog* log_ = nullptr;
  HostedAgent* hosted_ = nullptr;  ///< For the log.
  TagMap<kernel::InputElement> elements_;
  TagMap<kernel::InputObject> objects_;                                  ///< By client name, as one number.
  std::map<std::string, kernel::InputObject, std::less<>> odd_objects_;  ///< Those whose names are no such number.
  std::string
      last_name_;  ///< One of these names, and what stands there: an object's elements come one after the other.
  kernel::InputObject last_object_ = kernel::InputObject::kNone;
  std::size_t tidy_elements_at_ = 256;
  std::size_t tidy_objects_at_ = 64;
};

}  // namespace soarbox::server
