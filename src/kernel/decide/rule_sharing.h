// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

namespace soarbox::kernel {

class ProductionRecord;
class Rete;
class RuleDirectory;
class SymbolTable;

/// Lets agents that loaded equal rules share them: the constants that the rules mention, the rules, their directory and
/// the network's topology. Called before a run when the rules have changed; a thousand equal agents then hold one copy.
///
/// The store is process-wide and guarded by a mutex; what is in it never changes, and leaves it when the last agent
/// that used it changes its rules or dies. An agent that adds or excises a rule forks the shared topology first
/// (Rete).
void ShareRules(SymbolTable& symbols, Rete& rete, RuleDirectory& rules, std::vector<ProductionRecord>& productions);

}  // namespace soarbox::kernel
