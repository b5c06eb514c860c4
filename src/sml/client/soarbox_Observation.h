// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "mind/mind_record.h"

namespace sml {
class Agent;
}

namespace soarbox {

/// An observation ends with the destruction of this object, which must precede that of the agent and the record.
class Observation {
 public:
  virtual ~Observation() = default;
};

/// Records what an agent does from now on, with the data that only Soarbox's kernel has. Only adds to the record, on
/// the thread that runs the agent, and costs nothing while nothing happens. While decisions are observed, the kernel
/// records how rules are learned (MindInspection::LearnedRules). Returns null if the agent's kernel is in another
/// process: only the client API is available then.
std::unique_ptr<Observation> ObserveMind(sml::Agent& agent, mind::MindRecord& record, mind::MindDetail detail);
/// Records what its rules write, without the traces that clients receive through the same channel, and their actions
/// that fail. Returns null as ObserveMind does.
std::unique_ptr<Observation> ObserveOutput(sml::Agent& agent, mind::RuleOutput& output);

/// Locks the kernel of an agent during its lifetime, so that calls of the client API in between need not lock it one by
/// one: for clients that write much input at once. Must not be held during a run. Has no effect if the kernel no longer
/// exists.
class CallBatch {
 public:
  explicit CallBatch(sml::Agent& agent);

 private:
  std::unique_lock<std::recursive_mutex> held_;
};

/// Memory of an agent in bytes, without the rules of its files, which other agents may share; 0 if its kernel is in
/// another process.
std::size_t MindMemoryBytes(sml::Agent& agent);

/// Number of learned rules that the agent still has; 0 if its kernel is in another process.
std::size_t MindLearnedRules(sml::Agent& agent);
/// The rule that most of them were learned from, and their number.
struct LearnedSource {
  std::string rule;
  std::size_t count = 0;
};
LearnedSource MindLearnedFrom(sml::Agent& agent);

/// Number of rule firings since the agent was created or initialized; 0 if its kernel is in another process.
std::uint64_t MindFirings(sml::Agent& agent);
/// The rule that has fired most often, and its number of firings.
struct BusyRule {
  std::string rule;
  std::uint64_t firings = 0;
};
BusyRule MindBusiestRule(sml::Agent& agent);

/// Maximum number of partial matches ('soar max-partial-matches'); 0 if its kernel is in another process.
std::uint32_t MindMatchLimit(sml::Agent& agent);
void SetMindMatchLimit(sml::Agent& agent, std::uint32_t most);

/// Sets the maximum memory of an agent, in bytes as counted by MindMemoryBytes. If it grows beyond that while it runs,
/// it breaks down as if memory had run out. Has no effect if its kernel is in another process.
void SetMindMemoryLimit(sml::Agent& agent, std::size_t bytes);
/// When MindFirings reaches `most`, each phase of the agent ends as if it had reached max-elaborations. Has no effect
/// if the agent's kernel is in another process.
void SetMindFiringLimit(sml::Agent& agent, std::uint64_t most);

}  // namespace soarbox
