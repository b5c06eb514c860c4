// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/module.h"
#include "kernel/longterm/activations.h"
#include "kernel/longterm/agent_parts.h"
#include "kernel/longterm/attribute_symbols.h"
#include "kernel/longterm/command_watch.h"
#include "kernel/longterm/installer.h"
#include "kernel/longterm/knowledge.h"
#include "kernel/longterm/link_weights.h"
#include "kernel/longterm/semantic_command.h"
#include "kernel/longterm/semantic_query.h"
#include "kernel/longterm/smem_settings.h"
#include "kernel/longterm/spreading.h"
#include "kernel/longterm/written_order.h"

namespace soarbox::kernel {

class Journal;
class LongTerm;

/// Counted since the agent was made (`smem --stats`).
struct SmemCounters {
  std::uint64_t retrieves = 0, queries = 0, stores = 0;
};

/// Semantic memory of one agent: what it knows (Knowledge), how active that is (Activations), and the commands that
/// rules put on ^smem.command of any state, with their answers on ^smem.result.
///
/// A command is read when one of its elements changed: `store` after every elaboration, everything else in the output
/// phase, the lowest state first. A changed command removes the old answer. Elements of ^query and ^store objects count
/// as the command's; those of other objects, and anything deeper, do not.
///
/// The knowledge lives in memory. To let it outlive the process, give a Journal (journal.h), which receives every
/// change.
class SemanticMemory final : public Module {
 public:
  /// The semantic memory of an agent; made if there is none.
  static SemanticMemory& Of(LongTerm& long_term);
  /// The same, or null if nobody has asked for it yet.
  static const SemanticMemory* Find(const LongTerm& long_term);

  explicit SemanticMemory(LongTerm& long_term);
  ~SemanticMemory() override;

  const SmemSettings& settings() const { return settings_; }
  /// For `smem --set`. Call SettingsChanged afterwards.
  SmemSettings& mutable_settings() { return settings_; }
  void SettingsChanged();

  const Knowledge& knowledge() const { return *knowledge_; }
  const Activations& activations() const { return activations_; }
  /// How active an object is, including what spread to it when activation last spread.
  double ActivationOf(std::uint32_t object) const {
    return search_.ActivationOf(object, settings_.spreading ? &spreading_ : nullptr);
  }
  const SmemCounters& counters() const { return counters_; }
  /// True once. Soar shows the floats of the first object that an agent prints with as few digits as they need, and
  /// those of all later objects with 16 decimals.
  bool TakeFirstLine() const { return std::exchange(first_line_, false); }
  /// What `smem --stats spread_size` counts.
  std::size_t spread_size() const { return spreading_.size(); }

  // Changes from outside. The journal receives them.
  std::uint32_t ObjectOf(Lti number);
  std::uint32_t NewObject();
  bool AddEdge(std::uint32_t object, StoreTerm attribute, StoreTerm value);
  bool RemoveEdge(std::uint32_t object, StoreTerm attribute, StoreTerm value);
  void SetAlias(std::string_view name, Lti number);
  StoreTerm StringTerm(std::string_view text) { return Writable().terms().String(text); }
  StoreTerm IntegerTerm(std::int64_t value) { return Writable().terms().Integer(value); }
  StoreTerm FloatTerm(double value) { return Writable().terms().Float(value); }
  WrittenOrder& written_order() { return written_order_; }
  const SymbolTable& symbols() const;
  /// Sets the weights of an object's new links, by linked object; all others keep theirs. `before`: the weights of its
  /// links before the new ones came.
  void SetWeights(std::uint32_t object, const LinkWeights::Weights& before, const LinkWeights::Weights& added);
  /// The current weights of an object's links.
  LinkWeights::Weights WeightsOf(std::uint32_t object) const { return link_weights_.Effective(*knowledge_, object); }
  /// Makes the weights of an object's links equal.
  void ResetWeights(std::uint32_t object);
  /// Where the search for the number of the next new object begins.
  void SetNextNumber(Lti number);
  /// Forgets everything.
  void Clear();
  /// The objects that fit, best first, as `smem --query` lists them. Touches nothing.
  std::vector<std::uint32_t> Search(const Cue& cue, std::size_t limit);

  /// Working memory used a link between instances of two objects: spreading activation learns from it.
  void LinkUsed(Lti object, Lti linked, std::uint64_t cycle);

  /// Prints additions and removals (`trace --smem`).
  /// `brief`: a sign for each object that is stored, in the place of a line for each element.
  void SetTrace(bool on, bool brief) {
    traced_ = on;
    traces_briefly_ = brief;
  }
  /// Makes all augmentations of an object again: they are then the youngest.
  void Rewrite(std::uint32_t object);

  // The journal -----------------------------------------------------------------------------------------------------

  /// From now on all changes go to the journal, which must hold what is known now. Null: none.
  void SetJournal(std::unique_ptr<Journal> journal);
  Journal* journal() const { return journal_.get(); }
  /// Commits what changed; reports once if that fails. Called after every output phase, and after commands.
  void Keep();
  /// Called at the next first use of the memory, to open its file. Null: nothing. If it fails, the reason is printed
  /// and the memory works without a file.
  using Opener = std::function<Result<void>(SemanticMemory&)>;
  void SetOpener(Opener opener) { opener_ = std::move(opener); }
  void EnsureOpen();
  bool waits_for_file() const { return opener_ != nullptr; }
  /// Whether it has been used since it was made or closed: some settings only take effect at the next opening.
  bool opened() const { return opened_; }
  void NoteClosed() { opened_ = false; }
  /// The whole memory and its activations, as records for a journal, and the inverse. False if the records make no
  /// sense: then nothing has changed.
  std::string Image() const;
  bool Load(std::string_view image, std::span<const std::string> records);

  // Sharing ---------------------------------------------------------------------------------------------------------

  /// Shares the knowledge with other agents that know exactly the same, if any. Happens automatically at the agent's
  /// first run. An agent that changes shared knowledge gets its own layer over it.
  void Share();
  /// Call before adding a large text of knowledge to an empty memory. True: the memory now shares what an agent made
  /// from the same text before. Otherwise call NoteText once the whole text has been added.
  bool TakeText(std::string_view text);
  void NoteText(std::string_view text, Lti next_number);
  bool shares() const { return shared_; }

  // Module
  void Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) override;
  void AfterElaboration() override;
  void Output(bool output_changed) override;
  void StateMade(GoalLevel level) override;
  void StateRemoved(GoalLevel level) override;
  void BeforeInit() override;
  void AfterInit() override;
  void Mark(const std::function<void(Symbol)>& mark) override;
  void IdentifierFreed(Symbol id) override { watch_.IdentifierFreed(id); }
  std::size_t MemoryBytes() const override;

 private:
  /// What is known about the command of one state.
  struct State {
    CommandStamp store, other;  ///< As of the last answer.
    std::vector<PreferenceId> results;
  };

  Knowledge& Writable();
  void Respond(bool store_only);
  bool RespondTo(GoalLevel level, bool store_only);
  /// Reads the current command of a state into command_. Parse then says what it asks for.
  const SemanticCommand& Read(GoalLevel level);
  void Parse();
  void AnswerStore(GoalLevel level, const SemanticCommand& command);
  void AnswerRetrieval(GoalLevel level, const SemanticCommand& command);
  bool MakeCue(const SemanticCommand& command, Cue& cue);
  /// Tells observers the result of a command, and why. `object` may be Knowledge::kNowhere.
  void Tell(GoalLevel level, const SemanticCommand& command, const Cue& cue, std::span<const std::uint32_t> prohibited,
            std::uint32_t object);
  bool AddMath(Symbol object, Cue& cue);
  /// The object that stores an identifier. With `made_new`, it and its children get new objects, whatever their links;
  /// the map holds those that one command made, by identifier. An identifier without a link is linked to its object.
  std::uint32_t Store(Symbol id, std::map<std::uint32_t, std::uint32_t>* made_new);
  /// Adds an object's augmentations, and those of its children to the command's depth, to what will be installed.
  Symbol Retrieve(GoalLevel level, std::uint32_t object);
  StoreTerm TermOf(Symbol constant);
  StoreTerm FindTerm(Symbol symbol) const;
  Symbol SymbolOf(StoreTerm constant);
  StoreTerm FindAttribute(Symbol attribute);
  Symbol AttributeOf(StoreTerm attribute);
  void Touch(std::uint32_t object, bool advance = true);
  /// Spreads activation to the candidates of a query.
  void Spread(const Cue& cue);
  void UpdateSources();
  void TraceGone(std::uint32_t object);
  void TraceAdded(std::uint32_t object, StoreTerm attribute, StoreTerm value);
  void NoteGraphChanged();
  void NoteEdgeChanged(std::uint32_t object, StoreTerm attribute, StoreTerm value);

  LongTerm& long_term_;
  AgentParts uses_;
  SmemSettings settings_;
  std::shared_ptr<Knowledge> knowledge_;
  Activations activations_;
  SemanticSearch search_;
  LinkWeights link_weights_;
  Spreading spreading_;
  AttributeSymbols attributes_;
  Installer installer_;
  CommandWatch watch_;
  SmemCounters counters_;
  WrittenOrder written_order_;
  std::vector<State> states_;  ///< By level - 1.
  // Of the current command.
  SemanticCommand command_;
  Cue cue_;
  Retrieval retrieval_;
  bool pending_ = false;  ///< Commands changed since the last output phase.
  std::unique_ptr<Journal> journal_;
  Opener opener_;
  bool opened_ = false;
  bool shared_ = false;
  bool asked_to_share_ = false;
  bool traced_ = false;
  bool traces_briefly_ = false;
  std::uint32_t last_traced_ = 0xFFFFFFFFu;  ///< The object whose sign was printed last; none after Keep.
  bool warned_ = false;                      ///< About a journal that cannot be written.
  mutable bool first_line_ = true;
};

}  // namespace soarbox::kernel
