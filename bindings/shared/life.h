// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sml_Client.h"

/// Prevents objects of a garbage-collected language from accessing objects that the library has destroyed. Each object
/// of the language holds a shared pointer. Its deleter identifies the library's object (Life), and each call checks it
/// first.
namespace soarbox::bindings {

/// A kernel that a program in another language created, and the handlers that the program registered with it.
///
/// The kernel is deleted when its owner releases it. If calls are still using it, the last of them deletes it.
class KernelEntry : public std::enable_shared_from_this<KernelEntry> {
 public:
  /// Returns the entry of a kernel. Creates it if it does not exist.
  static std::shared_ptr<KernelEntry> Of(sml::Kernel* kernel);
  static std::vector<std::shared_ptr<KernelEntry>> All();

  /// Valid between Enter and Leave.
  sml::Kernel* kernel() const { return kernel_; }

  /// Keeps the kernel alive for a call or a handler. Returns false if it is deleted. With `is_new_call`, also returns
  /// false if its owner has released it and other calls still use it, so that these calls can end.
  bool Enter(bool is_new_call = false);
  /// `own_thread`: if the kernel has to be deleted, this thread deletes it; otherwise a new thread does.
  void Leave(bool own_thread);
  /// Releases the kernel for its owner.
  void LetGo();

  /// Asks an agent to stop, without waiting for other calls. Returns false if the agent is being destroyed.
  bool StopAgent(sml::Agent* agent, unsigned long long agent_life);

  /// Stores the handler that was registered under an id with an agent (0: with the kernel), until it is dropped.
  void Keep(unsigned long long agent_life, int id, std::shared_ptr<void> callback);
  void Drop(unsigned long long agent_life, int id);
  void DropAll();
  /// Drops the handlers of agents that were destroyed.
  void DropLeavers();

 private:
  explicit KernelEntry(sml::Kernel* kernel) : kernel_(kernel) {}
  static void OnAgentLeaves(sml::smlAgentEventId id, void* data, sml::Agent* agent);
  void Delete();

  using Callbacks = std::map<std::pair<unsigned long long, int>, std::shared_ptr<void>>;

  std::mutex mutex_;
  std::condition_variable left_;
  sml::Kernel* const kernel_;
  int users_ = 0;
  bool let_go_ = false;
  bool deleting_ = false;
  bool closed_ = false;  ///< Enter returns false from now on.
  bool has_leavers_ = false;
  std::set<unsigned long long> leavers_;
  Callbacks callbacks_;
};

/// The object of the library that an object of the other language refers to.
struct Life {
  enum class Kind { kKernel, kAgent, kElement, kSymbol };

  Kind kind = Kind::kKernel;
  std::shared_ptr<KernelEntry> entry;
  sml::Agent* agent = nullptr;
  unsigned long long agent_life = 0;
  const void* object = nullptr;  ///< The element or symbol.
  unsigned long long life = 0;

  static Life Of(sml::Kernel* kernel);
  static Life Of(sml::Agent* agent);
  static Life Of(sml::WMElement* element);
  static Life Of(sml::IdentifierSymbol* symbol, const Life& near);

  /// A sentence that names the object that no longer exists; empty if all exist. Call it only between Enter and Leave.
  std::string WhatIsGone() const;
};

/// The deleter of a shared pointer to an object that the library owns, or to a kernel with another owner.
struct Borrowed {
  Life life;
  void operator()(const void*) const {}
};

/// The deleter of a shared pointer to a kernel that the program owns.
struct Owned {
  Life life;
  void operator()(const void*) const { life.entry->LetGo(); }
};

/// The Life that the deleter of a shared pointer contains; null for the null pointer.
template <typename T>
const Life* LifeOf(const std::shared_ptr<T>& pointer) {
  if (const auto* borrowed = std::get_deleter<Borrowed>(pointer)) return &borrowed->life;
  if (const auto* owned = std::get_deleter<Owned>(pointer)) return &owned->life;
  return nullptr;
}

// Registration of handlers, in the same way for all languages.

/// Converts a number to an event. Throws std::invalid_argument if there is no such event of this kind.
template <typename Event>
Event CheckedEvent(int event, bool (*is_one)(int), const char* kind) {
  if (!is_one(event)) throw std::invalid_argument(std::to_string(event) + " is not a number of " + kind);
  return static_cast<Event>(event);
}
inline auto RunEvent(int event) {
  return CheckedEvent<sml::smlRunEventId>(event, sml::IsRunEventID, "a run event (smlEVENT_BEFORE_INPUT_PHASE, ...)");
}
inline auto ProductionEvent(int event) {
  return CheckedEvent<sml::smlProductionEventId>(event, sml::IsProductionEventID,
                                                 "a production event (smlEVENT_AFTER_PRODUCTION_FIRED, ...)");
}
inline auto PrintEvent(int event) {
  return CheckedEvent<sml::smlPrintEventId>(event, sml::IsPrintEventID, "a print event (smlEVENT_PRINT, ...)");
}
inline auto XmlEvent(int event) {
  return CheckedEvent<sml::smlXMLEventId>(event, sml::IsXMLEventID, "an XML event (smlEVENT_XML_TRACE_OUTPUT, ...)");
}
inline auto SystemEvent(int event) {
  return CheckedEvent<sml::smlSystemEventId>(event, sml::IsSystemEventID,
                                             "a system event (smlEVENT_SYSTEM_START, ...)");
}
inline auto UpdateEvent(int event) {
  return CheckedEvent<sml::smlUpdateEventId>(event, sml::IsUpdateEventID,
                                             "an update event (smlEVENT_AFTER_ALL_OUTPUT_PHASES, ...)");
}
inline auto StringEvent(int event) {
  return CheckedEvent<sml::smlStringEventId>(event, sml::IsStringEventID,
                                             "a string event (smlEVENT_LOAD_LIBRARY, ...)");
}
inline auto AgentEvent(int event) {
  return CheckedEvent<sml::smlAgentEventId>(event, sml::IsAgentEventID,
                                            "an agent event (smlEVENT_AFTER_AGENT_CREATED, ...)");
}

/// Passes a callback to `registers`, and stores it if the result is an id (not 0). `agent_life` 0: a handler of the
/// kernel.
template <typename Callback, typename Registers>
int Register(const std::shared_ptr<KernelEntry>& entry, unsigned long long agent_life,
             std::shared_ptr<Callback> callback, Registers registers) {
  const int id = registers(static_cast<void*>(callback.get()));
  if (id != 0) entry->Keep(agent_life, id, std::move(callback));
  return id;
}

inline void Forget(sml::Agent& agent, int id) {
  KernelEntry::Of(agent.GetKernel())->Drop(agent.GetLife(), id);
}
inline void Forget(sml::Kernel& kernel, int id) {
  KernelEntry::Of(&kernel)->Drop(0, id);
}

/// Stops the agents of all existing kernels and shuts the kernels down.
inline void EndKernels() {
  for (const std::shared_ptr<KernelEntry>& entry : KernelEntry::All()) {
    if (!entry->Enter()) continue;
    entry->kernel()->StopAllAgents();
    entry->kernel()->Shutdown();
    entry->Leave(false);
  }
}

}  // namespace soarbox::bindings
