// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/decide/instantiation.h"
#include "kernel/rules/functions/function_context.h"

namespace soarbox::kernel {

struct AgentCore;

/// The functions of the firing agent that right-hand-side functions may call.
class RuleContext final : public FunctionContext {
 public:
  explicit RuleContext(AgentCore& core) : core_(core) {}

  /// Sets the instantiation whose actions are being executed.
  void SetFiring(InstantiationId id) { firing_ = id; }
  InstantiationId firing() const { return firing_; }
  /// An element that the firing copied, and the copy.
  struct Copied {
    WmeId element = WmeId::kNone;
    Symbol original, copy, attribute, value;
  };
  bool HasCopied() const { return !copied_.empty(); }
  /// Creates the preferences for the elements that the action copied.
  void MakeCopies();
  /// All elements that the firing copied.
  std::span<const Copied> copied() const { return copied_; }
  void ForgetCopied() {
    copied_.clear();
    made_copies_ = 0;
  }

  SymbolTable& symbols() override;
  RandomStream& random() override;
  void PrintError(std::string_view text) override;
  void Write(std::string_view text) override;
  void Log(int channel, std::string_view text) override;
  void Trace(int level, std::string_view text) override;
  void RequestHalt() override;
  void RequestInterrupt() override;
  void WaitMilliseconds(std::int64_t milliseconds) override;
  std::string Timestamp() override;
  std::uint64_t DecisionCycle() const override;
  std::uint64_t NextConstantNumber() override;
  std::string RunCommand(std::string_view line) override;
  bool CallUserFunction(std::string_view name, std::string_view argument, std::string& result) override;
  void SlotChildren(Symbol identifier, std::vector<Child>& out) const override;
  void AllChildren(Symbol identifier, std::vector<Child>& out) const override;
  Symbol NewIdentifier(char letter) override;
  void MakePreference(Symbol identifier, Symbol attribute, Symbol value) override;
  void CopyElement(const Child& element, Symbol original, Symbol copy, Symbol attribute, Symbol value) override;
  bool IsGoal(Symbol identifier) const override;
  std::uint64_t LongTermIdentifier(Symbol identifier) const override;
  void LinkToLongTerm(Symbol identifier, std::uint64_t lti) override;
  void SetLearning(Symbol state, bool learn) override;

 private:
  AgentCore& core_;
  InstantiationId firing_ = InstantiationId::kNone;
  std::uint64_t next_constant_ = 1;
  std::vector<Copied> copied_;
  std::size_t made_copies_ = 0;  ///< The number of copies whose preferences exist.
};

}  // namespace soarbox::kernel
