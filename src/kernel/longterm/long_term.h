// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "kernel/decide/module.h"
#include "kernel/longterm/agent_parts.h"

namespace soarbox::kernel {

/// The long-term memories of one agent: owns the modules, and registers them with the decision cycle
/// (decide/modules.h). A module is created at the first request (by its command). An agent without modules needs no
/// memory for them and only one test per hook.
class LongTerm {
 public:
  /// In the order in which the cycle calls them.
  enum class ModuleKind : std::uint8_t { kSemantic, kActivation, kEpisodic };

  explicit LongTerm(const AgentParts& parts) : parts_(parts) {}
  LongTerm(const LongTerm&) = delete;
  LongTerm& operator=(const LongTerm&) = delete;

  /// The module, or null if it was not created.
  Module* module(ModuleKind kind) const { return modules_[static_cast<std::size_t>(kind)].get(); }
  /// Adds a module. It lives as long as the agent.
  void Attach(ModuleKind kind, std::unique_ptr<Module> module);
  /// Sets the hooks of a module. A module always receives the call for freed identifiers.
  void SetHooks(ModuleKind kind, ModuleHooks hooks);
  /// Reports to the modules that an identifier of working memory is now linked to another long-term identifier, or to
  /// none.
  void LinkChanged(Symbol id);

  const AgentParts& parts() const { return parts_; }

 private:
  AgentParts parts_;
  std::array<std::unique_ptr<Module>, 3> modules_;
};

}  // namespace soarbox::kernel
