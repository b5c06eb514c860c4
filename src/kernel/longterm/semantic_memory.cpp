// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/semantic_memory.h"

#include <cmath>
#include <map>
#include <utility>

#include "kernel/base/symbol_table.h"
#include "kernel/decide/elaboration.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/observers.h"
#include "kernel/decide/preference_changes.h"
#include "kernel/longterm/journal.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/semantic_records.h"
#include "kernel/longterm/shared_knowledge.h"
#include "kernel/longterm/wm_activation.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

namespace {
/// Minimum number of objects for sharing.
constexpr std::uint32_t kWorthSharing = 64;
}  // namespace

SemanticMemory& SemanticMemory::Of(LongTerm& long_term) {
  if (Module* const known = long_term.module(LongTerm::ModuleKind::kSemantic)) {
    return static_cast<SemanticMemory&>(*known);
  }
  auto made = std::make_unique<SemanticMemory>(long_term);
  SemanticMemory& module = *made;
  long_term.Attach(LongTerm::ModuleKind::kSemantic, std::move(made));
  return module;
}

const SemanticMemory* SemanticMemory::Find(const LongTerm& long_term) {
  return static_cast<const SemanticMemory*>(long_term.module(LongTerm::ModuleKind::kSemantic));
}

SemanticMemory::SemanticMemory(LongTerm& long_term)
    : long_term_(long_term),
      uses_(long_term.parts()),
      knowledge_(std::make_shared<Knowledge>()),
      activations_(settings_),
      search_(settings_, activations_),
      link_weights_(settings_),
      spreading_(settings_, link_weights_),
      installer_(uses_) {}

SemanticMemory::~SemanticMemory() = default;

void SemanticMemory::SettingsChanged() {
  ModuleHooks hooks = 0 | ModuleHook::kStates;
  if (settings_.enabled) {
    hooks = ModuleHook::kFlush | ModuleHook::kAfterElaboration | ModuleHook::kOutput | ModuleHook::kStates;
    watch_.Touch();
  }
  if (!settings_.spreading) {
    spreading_.Clear();
    link_weights_.ForgetUses();
  }
  spreading_.Renew();
  long_term_.SetHooks(LongTerm::ModuleKind::kSemantic, hooks);
}

// Changes -------------------------------------------------------------------------------------------------------------

Knowledge& SemanticMemory::Writable() {
  if (shared_) {
    knowledge_ = std::make_shared<Knowledge>(std::shared_ptr<const Knowledge>(std::move(knowledge_)));
    shared_ = false;
  }
  return *knowledge_;
}

void SemanticMemory::Share() {
  // Sharing is not worthwhile for small knowledge, or for knowledge with its own file.
  if (shared_ || knowledge_->is_layer() || journal_ != nullptr || knowledge_->object_count() < kWorthSharing) return;
  knowledge_->SkipTakenNumbers();
  knowledge_ = ShareKnowledge(std::move(knowledge_));
  shared_ = true;
}

bool SemanticMemory::TakeText(std::string_view text) {
  if (journal_ != nullptr || traced_) return false;
  std::shared_ptr<Knowledge> known = KnowledgeOfText(KeyOfText(text, knowledge_->next_number()));
  if (known == nullptr) return false;
  knowledge_ = std::move(known);
  shared_ = true;
  NoteGraphChanged();
  return true;
}

void SemanticMemory::NoteText(std::string_view text, Lti next_number) {
  Share();
  if (shared_ && link_weights_.empty()) NoteKnowledgeOfText(KeyOfText(text, next_number), knowledge_);
}

void SemanticMemory::NoteGraphChanged() {
  search_.Forget();
  spreading_.Forget();
  link_weights_.Clear();
  attributes_.Forget();
}

void SemanticMemory::NoteEdgeChanged(std::uint32_t object, StoreTerm attribute, StoreTerm value) {
  search_.Forget(attribute);
  if (!value.IsObject()) return;
  spreading_.Forget();
  link_weights_.Forget(object);
}

void SemanticMemory::LinkUsed(Lti object, Lti linked, std::uint64_t cycle) {
  if (!settings_.spreading || !settings_.spreading_edge_updating) return;
  const std::uint32_t place = knowledge_->Find(object);
  if (place == Knowledge::kNowhere) return;
  link_weights_.Use(*knowledge_, place, knowledge_->Find(linked), cycle);
  spreading_.Forget();
}

std::uint32_t SemanticMemory::ObjectOf(Lti number) {
  const std::uint32_t known = knowledge_->Find(number);
  if (known != Knowledge::kNowhere) return known;
  const std::uint32_t made = Writable().FindOrAdd(number);
  if (journal_ != nullptr) journal_->Append(records::Object(number));
  return made;
}

std::uint32_t SemanticMemory::NewObject() {
  const std::uint32_t made = Writable().AddNew();
  if (journal_ != nullptr) journal_->Append(records::NewObject(knowledge_->NumberAt(made)));
  return made;
}

bool SemanticMemory::AddEdge(std::uint32_t object, StoreTerm attribute, StoreTerm value) {
  if (traced_) TraceAdded(object, attribute, value);
  // (Adding an existing augmentation requires no layer.)
  if (shared_ && knowledge_->Has(object, attribute, value)) return false;
  if (!Writable().AddEdge(object, attribute, value)) return false;
  if (journal_ != nullptr) journal_->Append(records::Edge(*knowledge_, object, attribute, value, true));
  NoteEdgeChanged(object, attribute, value);
  return true;
}

bool SemanticMemory::RemoveEdge(std::uint32_t object, StoreTerm attribute, StoreTerm value) {
  if (!knowledge_->Has(object, attribute, value)) return false;
  Writable().RemoveEdge(object, attribute, value);
  if (journal_ != nullptr) journal_->Append(records::Edge(*knowledge_, object, attribute, value, false));
  NoteEdgeChanged(object, attribute, value);
  return true;
}

void SemanticMemory::SetWeights(std::uint32_t object, const LinkWeights::Weights& before,
                                const LinkWeights::Weights& added) {
  LinkWeights::Weights weights = link_weights_.Equal(*knowledge_, object);
  for (auto& [linked, weight] : weights) {
    if (const auto kept = before.find(linked); kept != before.end()) {
      weight = kept->second;
    } else if (const auto given = added.find(linked); given != added.end()) {
      weight = given->second;
    }
  }
  link_weights_.Set(*knowledge_, object, std::move(weights));
  spreading_.Forget();
}

void SemanticMemory::ResetWeights(std::uint32_t object) {
  if (link_weights_.Known(object) == nullptr) return;
  link_weights_.Set(*knowledge_, object, link_weights_.Equal(*knowledge_, object));
  spreading_.Forget();
}

const SymbolTable& SemanticMemory::symbols() const {
  return uses_.symbols;
}

void SemanticMemory::SetNextNumber(Lti number) {
  if (knowledge_->next_number() == number) return;
  Writable().set_next_number(number);
  if (journal_ != nullptr) journal_->Append(records::NextNumber(number));
}

void SemanticMemory::SetAlias(std::string_view name, Lti number) {
  Writable().SetAlias(name, number);
  if (journal_ != nullptr) journal_->Append(records::Alias(name, number));
}

void SemanticMemory::Clear() {
  knowledge_ = std::make_shared<Knowledge>();
  knowledge_->set_next_number(settings_.initial_number);
  shared_ = false;
  activations_.Clear();
  NoteGraphChanged();
  spreading_.Clear();
  if (journal_ == nullptr) return;
  journal_->Append(records::Clear());
  if (settings_.initial_number != 1) journal_->Append(records::NextNumber(settings_.initial_number));
}

std::vector<std::uint32_t> SemanticMemory::Search(const Cue& cue, std::size_t limit) {
  Spread(cue);
  return search_.Find(*knowledge_, cue, {}, limit, settings_.spreading ? &spreading_ : nullptr);
}

void SemanticMemory::Touch(std::uint32_t object, bool advance) {
  if (activations_.Touch(object, advance)) search_.FirstTouched(*knowledge_, object);
  if (journal_ != nullptr) journal_->Append(records::Touch(knowledge_->NumberAt(object), advance));
}

// The trace -----------------------------------------------------------------------------------------------------------

void SemanticMemory::TraceGone(std::uint32_t object) {
  if (traced_ && !traces_briefly_)
    uses_.observers.Print("<=SMEM: (@" + std::to_string(knowledge_->NumberAt(object)) + " ^* *)\n");
}

void SemanticMemory::TraceAdded(std::uint32_t object, StoreTerm attribute, StoreTerm value) {
  if (traces_briefly_) {
    if (std::exchange(last_traced_, object) != object) uses_.observers.Print("@");
    return;
  }
  const Terms& terms = knowledge_->terms();
  const std::string number = std::to_string(knowledge_->NumberAt(object));
  std::string line = value.IsObject() ? "=>SMEM: (" + number : "=>SMEM: (@" + number;
  line += " ^";
  terms.Append(line, attribute);
  line += ' ';
  if (value.IsObject()) {
    line += std::to_string(knowledge_->NumberAt(value.index()));
  } else if (value.kind() == TermKind::kFloat) {
    line += std::to_string(terms.FloatValue(value));
  } else {
    terms.Append(line, value);
  }
  uses_.observers.Print(line + ")\n");
}

void SemanticMemory::Rewrite(std::uint32_t object) {
  TraceGone(object);
  const std::vector<Edge> edges = knowledge_->OrderedEdgesAt(object);
  for (const Edge& edge : edges) RemoveEdge(object, edge.attribute, edge.value);
  for (const Edge& edge : edges) AddEdge(object, edge.attribute, edge.value);
}

// Persistence ---------------------------------------------------------------------------------------------------------

void SemanticMemory::SetJournal(std::unique_ptr<Journal> journal) {
  journal_ = std::move(journal);
  link_weights_.NoteChanges(journal_ != nullptr);
}

void SemanticMemory::Keep() {
  last_traced_ = 0xFFFFFFFFu;
  if (journal_ == nullptr) return;
  for (const std::uint32_t object : link_weights_.TakeChanged()) {
    const LinkWeights::Weights* const weights = link_weights_.Known(object);
    if (weights != nullptr) journal_->Append(records::Weights(*knowledge_, object, *weights));
  }
  Result<void> kept = journal_->Commit();
  if (kept.ok() && journal_->WantsImage()) kept = journal_->Replace(Image());
  // Unwritten data stay in the journal and are written later; one warning is printed.
  if (!kept && !warned_) uses_.observers.Print("Semantic memory: " + Format(kept.error()));
  warned_ = !kept;
}

void SemanticMemory::EnsureOpen() {
  opened_ = true;
  if (!opener_) return;
  const Opener opener = std::exchange(opener_, nullptr);
  const Result<void> result = opener(*this);
  if (!result) uses_.observers.Print("Semantic memory continues without a file: " + Format(result.error()));
}

std::string SemanticMemory::Image() const {
  return records::Image(*knowledge_, activations_, link_weights_);
}

bool SemanticMemory::Load(std::string_view image, std::span<const std::string> records) {
  auto loaded = std::make_shared<Knowledge>();
  loaded->set_next_number(settings_.initial_number);
  Activations active(settings_);
  LinkWeights weights(settings_);
  if (!image.empty() && !records::ReadImage(image, *loaded, active, weights)) return false;
  for (const std::string& record : records) {
    if (!records::Apply(record, *loaded, active, weights)) return false;
  }
  knowledge_ = std::move(loaded);
  shared_ = false;
  const std::vector<Activations::Touched> touched(active.records().begin(), active.records().end());
  activations_.Restore(active.tick(), touched);
  NoteGraphChanged();
  link_weights_.TakeOver(weights);
  spreading_.Clear();
  return true;
}

std::size_t SemanticMemory::MemoryBytes() const {
  // Shared knowledge is not counted for any agent.
  return sizeof(*this) + activations_.MemoryBytes() + (shared_ ? 0 : knowledge_->MemoryBytes());
}

// Terms and symbols ---------------------------------------------------------------------------------------------------

StoreTerm SemanticMemory::TermOf(Symbol constant) {
  const StoreTerm known = FindTerm(constant);
  return known ? known : AddTerm(Writable().terms(), uses_.symbols, constant);
}

StoreTerm SemanticMemory::FindTerm(Symbol symbol) const {
  if (symbol.IsConstant()) return kernel::FindTerm(knowledge_->terms(), uses_.symbols, symbol);
  const Lti number = uses_.memory.long_term_identifiers()[symbol.index()];
  const std::uint32_t object = number == 0 ? Knowledge::kNowhere : knowledge_->Find(number);
  return object == Knowledge::kNowhere ? StoreTerm() : StoreTerm::Object(object);
}

StoreTerm SemanticMemory::FindAttribute(Symbol attribute) {
  if (const StoreTerm known = attributes_.TermOf(attribute)) return known;
  const StoreTerm found = FindTerm(attribute);
  if (found && attribute.IsConstant()) attributes_.Note(found, attribute);
  return found;
}

Symbol SemanticMemory::AttributeOf(StoreTerm attribute) {
  if (const Symbol known = attributes_.SymbolOf(attribute)) return known;
  const Symbol made = SymbolOf(knowledge_->terms(), uses_.symbols, attribute);
  attributes_.Note(attribute, made);
  return made;
}

// The cycle -----------------------------------------------------------------------------------------------------------

void SemanticMemory::Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) {
  watch_.Flushed(uses_.memory.wmes(), added, removed);
}

void SemanticMemory::AfterElaboration() {
  if (!watch_.TakeChanged()) return;
  pending_ = true;
  Respond(true);
}

void SemanticMemory::Output(bool) {
  if (watch_.TakeChanged()) pending_ = true;
  if (std::exchange(pending_, false)) Respond(false);
  if (journal_ != nullptr) Keep();
}

void SemanticMemory::Mark(const std::function<void(Symbol)>&) {
  attributes_.Forget();
}

void SemanticMemory::StateMade(GoalLevel) {
  watch_.Touch();
}

void SemanticMemory::StateRemoved(GoalLevel level) {
  if (states_.size() < level) return;
  for (const PreferenceId result : states_[level - 1u].results) uses_.preferences.DropReference(result);
  states_.resize(level - 1u);
}

void SemanticMemory::BeforeInit() {
  if (journal_ != nullptr) Keep();
}

void SemanticMemory::AfterInit() {
  states_.clear();
  watch_.Clear();
  spreading_.Clear();
}

void SemanticMemory::Respond(bool store_only) {
  if (!opened_ || opener_) EnsureOpen();
  if (!asked_to_share_) {
    asked_to_share_ = true;
    Share();
  }
  bool changed = false;
  for (auto level = static_cast<GoalLevel>(uses_.goals.depth()); level >= 1; --level) {
    changed = RespondTo(level, store_only) || changed;
  }
  if (!changed) return;
  if (store_only) {
    // The trace shows it as one more change of working memory in the elaboration.
    const FiringType type = uses_.elaboration.firing_type();
    uses_.observers.Notify(Event::kElaboration, [&](Observer& o) { o.OnWorkingMemoryPhase(uses_.agent, type); });
  }
  installer_.Settle();
}

void SemanticMemory::Spread(const Cue& cue) {
  if (!settings_.spreading) return;
  const std::uint32_t list = search_.DrivingList(*knowledge_, cue);
  if (list == Knowledge::kNowhere) return;
  const MemberList members = knowledge_->ListAt(list);
  if (members.size() < 2) return;
  UpdateSources();
  const double unused = activations_.UnusedStrength();
  spreading_.Spread(std::log(unused / (1 + unused)),
                    [&](const auto& give) { members.ForEach([&](const Member& member) { give(member.object); }); });
}

/// Determines the sources of spreading: objects with an instance that has elements, and their activations.
void SemanticMemory::UpdateSources() {
  std::map<std::uint32_t, double> sources;
  const WmeTable& wmes = uses_.memory.wmes();
  const std::span<const std::uint64_t> linked = uses_.memory.long_term_identifiers();
  const WmActivation* const activation = settings_.spreading_wma_source ? WmActivation::Find(long_term_) : nullptr;
  for (const Wme& wme : wmes) {
    if (!wme.live || linked[wme.id.index()] == 0) continue;
    const std::uint32_t object = knowledge_->Find(linked[wme.id.index()]);
    if (object == Knowledge::kNowhere) continue;
    double& strength = sources[object];
    const auto id = static_cast<WmeId>(&wme - &wmes[0]);
    if (activation != nullptr && activation->HistoryOf(id) != nullptr) strength += std::exp(activation->Of(id));
  }
  // A source whose instance has no activation is as strong as an object that was never used.
  const double unused = activations_.UnusedStrength();
  for (auto& [object, strength] : sources) strength = strength > 0 ? strength : unused;
  spreading_.SetSources(*knowledge_, sources);
}

}  // namespace soarbox::kernel
