// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/memory/element_listener.h"

namespace soarbox::kernel {

struct Engine;

/// Passes on to the parts of an agent what working memory tells of elements: to goal dependency sets, the input link,
/// learning, long-term memory, and those who observe the agent.
class ElementEvents final : public ElementListener {
 public:
  explicit ElementEvents(Engine& engine) : engine_(engine) {}

  void AttributeUsed(Symbol attribute) override;
  void DependencyLost(WmeId wme) override;
  void DependencyForgotten(WmeId wme) override;
  void InputElementRemoved(std::uint32_t element) override;
  bool FlushBegins(std::size_t added, std::size_t removed) override;
  void FirstWasLost(WmeId wme) override;
  void Entered(WmeId wme) override;
  void Left(WmeId wme) override;
  void RuleInterrupts() override;
  void Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) override;

 private:
  Engine& engine_;
};

}  // namespace soarbox::kernel
