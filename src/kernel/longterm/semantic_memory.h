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

/// Counters of `smem --stats`, since the agent was created.
struct SmemCounters {
  std::uint64_t retrieves = 0, queries = 0, stores = 0;
};

/// Semantic memory of one agent: the knowledge (Knowledge), its activation (Activations), and the commands that rules
/// put on ^smem.command of a state, with their results on ^smem.result.
///
/// A command is read when one of its elements has changed: `store` after every elaboration, everything else in the
/// output phase, the lowest state first. A changed command removes the old result. Elements of ^query and ^store
/// objects belong to the command; elements of other objects, and anything deeper, do not.
///
/// The knowledge is in memory. To keep it in a file, set a Journal (journal.h), which receives every change.
class SemanticMemory final : public Module {
 public:
  /// The semantic memory of an agent; created if there is none.
  static SemanticMemory& Of(LongTerm& long_term);
  /// The semantic memory of an agent; null if it was not created.
  static const SemanticMemory* Find(const LongTerm& long_term);

  explicit SemanticMemory(LongTerm& long_term);
  ~SemanticMemory() override;

  const SmemSettings& settings() const { return settings_; }
  /// For `smem --set`. Call SettingsChanged afterwards.
  SmemSettings& mutable_settings() { return settings_; }
  void SettingsChanged();

  const Knowledge& knowledge() const { return *knowledge_; }
  const Activations& activations() const { return activations_; }
  /// The activation of an object, including the part that spread to it when activation last spread.
  double ActivationOf(std::uint32_t object) const {
    return search_.ActivationOf(object, settings_.spreading ? &spreading_ : nullptr);
  }
  const SmemCounters& counters() const { return counters_; }
  /// Returns true once. For the first object that an agent prints, Soar writes floats with as few digits as possible;
  /// for all later objects with 16 decimals.
  bool TakeFirstLine() const { return std::exchange(first_line_, false); }
  /// The number for `smem --stats spread_size`.
  std::size_t spread_size() const { return spreading_.size(); }

  // Changes by users. The journal receives them.
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
  /// Sets the weights of an object's new links, by linked object. The other links keep their weights. `before`: the
  /// weights before the new links were added.
  void SetWeights(std::uint32_t object, const LinkWeights::Weights& before, const LinkWeights::Weights& added);
  /// The current weights of an object's links.
  LinkWeights::Weights WeightsOf(std::uint32_t object) const { return link_weights_.Effective(*knowledge_, object); }
  /// Resets the weights of an object's links to equal ones.
  void ResetWeights(std::uint32_t object);
  /// Sets the number at which the search for the next free number begins.
  void SetNextNumber(Lti number);
  /// Removes everything.
  void Clear();
  /// The objects that fit, best first, as `smem --query` lists them. Touches no object.
  std::vector<std::uint32_t> Search(const Cue& cue, std::size_t limit);

  /// Working memory used a link between instances of two objects: spreading activation adjusts its weight.
  void LinkUsed(Lti object, Lti linked, std::uint64_t cycle);

  /// Prints additions and removals (`trace --smem`). `brief`: one sign per stored object instead of a line for each
  /// element.
  void SetTrace(bool on, bool brief) {
    traced_ = on;
    traces_briefly_ = brief;
  }
  /// Removes and adds all augmentations of an object, so that they become the newest.
  void Rewrite(std::uint32_t object);

  // The journal -----------------------------------------------------------------------------------------------------

  /// From now on all changes are written to the journal, which must contain the current knowledge. Null: none.
  void SetJournal(std::unique_ptr<Journal> journal);
  Journal* journal() const { return journal_.get(); }
  /// Commits the changes; reports an error once. Called after every output phase, and after commands.
  void Keep();
  /// Opens the memory's file. Called once, at the next use of a memory that is not open. Null: none. If it fails, the
  /// error is printed, and the memory works without a file.
  using Opener = std::function<Result<void>(SemanticMemory&)>;
  void SetOpener(Opener opener) { opener_ = std::move(opener); }
  void EnsureOpen();
  bool waits_for_file() const { return opener_ != nullptr; }
  /// Whether it was used since it was created or closed. Some settings take effect only at the next opening.
  bool opened() const { return opened_; }
  void NoteClosed() { opened_ = false; }
  /// The entire memory with its activations, as records for a journal, and the inverse. Load returns false, and changes
  /// nothing, if the records are invalid.
  std::string Image() const;
  bool Load(std::string_view image, std::span<const std::string> records);

  // Sharing ---------------------------------------------------------------------------------------------------------

  /// Shares the knowledge with other agents whose knowledge is equal, if there are any. Called automatically at the
  /// agent's first run. An agent that changes shared knowledge gets its own layer over it.
  void Share();
  /// Call it before adding a large text of knowledge to an empty memory. If it returns true, the memory now shares the
  /// knowledge that an agent created from the same text before. Else call NoteText after the entire text has been
  /// added.
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
  /// The stored data on the command of one state.
  struct State {
    CommandStamp store, other;  ///< As of the last result.
    std::vector<PreferenceId> results;
  };

  Knowledge& Writable();
  void Respond(bool store_only);
  bool RespondTo(GoalLevel level, bool store_only);
  /// Reads the current command of a state into command_. Parse then determines its meaning.
  const SemanticCommand& Read(GoalLevel level);
  void Parse();
  void AnswerStore(GoalLevel level, const SemanticCommand& command);
  void AnswerRetrieval(GoalLevel level, const SemanticCommand& command);
  bool MakeCue(const SemanticCommand& command, Cue& cue);
  /// Reports the result of a command, with the reason, to observers. `object` may be Knowledge::kNowhere.
  void Tell(GoalLevel level, const SemanticCommand& command, const Cue& cue, std::span<const std::uint32_t> prohibited,
            std::uint32_t object);
  bool AddMath(Symbol object, Cue& cue);
  /// Stores the elements of an identifier and returns its object. With `made_new`, the identifier and its children get
  /// new objects, regardless of their links; the map contains those created by one command, by identifier. An
  /// identifier without a link is linked to its object.
  std::uint32_t Store(Symbol id, std::map<std::uint32_t, std::uint32_t>* made_new);
  /// Adds an object's augmentations, and those of its children to the command's depth, to what will be installed.
  Symbol Retrieve(GoalLevel level, std::uint32_t object);
  StoreTerm TermOf(Symbol constant);
  StoreTerm FindTerm(Symbol symbol) const;
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
  // Data of the current command.
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
  bool warned_ = false;                      ///< A warning about an unwritable journal was printed.
  mutable bool first_line_ = true;
};

}  // namespace soarbox::kernel
