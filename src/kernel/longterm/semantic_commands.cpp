// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <map>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/observers.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/recall_words.h"
#include "kernel/longterm/semantic_memory.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

namespace {

/// The element of a slot without a preference: a link of the architecture. kNone if there is none.
WmeId ElementOf(const WorkingMemory& memory, Symbol id, Symbol attribute) {
  const SlotId slot = memory.FindSlot(id, attribute);
  return slot == SlotId::kNone ? WmeId::kNone : memory.slot(slot).wmes;
}

}  // namespace

const SemanticCommand& SemanticMemory::Read(GoalLevel level) {
  const WorkingMemory& memory = uses_.memory;
  const Goal& goal = uses_.goals.at(level);
  SemanticCommand& command = command_;
  command.Clear();
  watch_.Watch(goal.smem.command);
  const auto add = [&](WmeId wme, bool is_store) {
    command.wmes.push_back(wme);
    CommandStamp& stamp = is_store ? command.store : command.other;
    ++stamp.count;
    stamp.time = std::max(stamp.time, memory.wme(wme).timetag);
  };
  memory.ForEachWmeOf(goal.smem.command, [&](WmeId wme) { add(wme, memory.wme(wme).attribute == words::kStore); });
  const std::size_t count = command.wmes.size();
  for (std::size_t n = 0; n < count; ++n) {
    const Wme& wme = memory.wme(command.wmes[n]);
    const bool is_store = wme.attribute == words::kStore;
    if (!wme.value.IsIdentifier() || (wme.attribute != words::kQuery && !is_store)) continue;
    watch_.Watch(wme.value);
    memory.ForEachWmeOf(wme.value, [&](WmeId inner) { add(inner, is_store); });
  }
  // A result depends on the ^result link, too.
  const WmeId place = ElementOf(memory, goal.smem.link, words::kResult);
  if (!command.wmes.empty() && place != WmeId::kNone) command.wmes.push_back(place);
  return command;
}

void SemanticMemory::Parse() {
  SemanticCommand& command = command_;
  const WorkingMemory& memory = uses_.memory;
  const Symbol link = command.wmes.empty() ? Symbol() : memory.wme(command.wmes.front()).id;
  int retrieves = 0, queries = 0, stores = 0, new_stores = 0, negatives = 0, maths = 0;
  bool bad = false, link_to_new = false;
  // Elements are read in the order of the slots, the newest first. If ^link-to-ltm or ^link-to-new-ltm is read after a
  // part of the command to which it does not belong, the command is invalid. If it is read before such a part, it has
  // no effect. ^depth with a store never has an effect.
  enum class Path { kNone, kRecall, kStoreNew, kOther } path = Path::kNone;
  for (const WmeId id : command.wmes) {
    const Wme& wme = memory.wme(id);
    if (wme.id != link) continue;
    const Symbol value = wme.value;
    const bool is_identifier = value.IsIdentifier();
    if (wme.attribute == words::kRetrieve) {
      ++retrieves;
      path = Path::kRecall;
      command.asked = value;
      bad = bad || !is_identifier;
    } else if (wme.attribute == words::kQuery) {
      ++queries;
      path = Path::kRecall;
      command.asked = value;
      bad = bad || !is_identifier;
    } else if (wme.attribute == words::kNegQuery) {
      ++negatives;
      path = Path::kRecall;
      command.negative = value;
      bad = bad || !is_identifier;
    } else if (wme.attribute == words::kMathQuery) {
      ++maths;
      path = Path::kRecall;
      command.math = value;
      bad = bad || !is_identifier;
    } else if (wme.attribute == words::kProhibit) {
      bad = bad || !is_identifier || memory.long_term_identifiers()[value.index()] == 0;
      command.prohibited.push_back(value);
      if (path == Path::kNone) path = Path::kOther;
    } else if (wme.attribute == words::kStore || wme.attribute == words::kStoreNew) {
      ++(wme.attribute == words::kStore ? stores : new_stores);
      path = wme.attribute == words::kStore ? Path::kOther : Path::kStoreNew;
      command.stored.push_back(value);
      bad = bad || !is_identifier;
    } else if (wme.attribute == words::kDepth) {
      bad = bad || !value.IsInteger();
      if (value.IsInteger()) command.depth = uses_.symbols.IntegerValue(value);
    } else if (wme.attribute == words::kLinkToLtm && (value == words::kYes || value == words::kNo)) {
      bad = bad || (path != Path::kNone && path != Path::kRecall);
      command.link = value == words::kYes;
    } else if (wme.attribute == words::kLinkToNewLtm && (value == words::kYes || value == words::kNo)) {
      bad = bad || (path != Path::kNone && path != Path::kStoreNew);
      link_to_new = value == words::kYes;
    } else {
      bad = true;
    }
  }
  const int kinds = (retrieves > 0) + (queries > 0) + (stores > 0) + (new_stores > 0);
  // A command that only prohibits requests nothing, and is not executed.
  const bool only_prohibits = kinds == 0 && !command.prohibited.empty() && negatives + maths == 0;
  bad = bad || (kinds != 1 && !only_prohibits) || retrieves > 1 || queries > 1 || negatives > 1 || maths > 1;
  bad = bad || (queries == 0 && (negatives > 0 || maths > 0 || (!command.prohibited.empty() && !only_prohibits)));
  if (new_stores > 0) command.link = link_to_new;
  command.kind = command.wmes.empty() ? SemanticCommand::Kind::kNone
                 : bad                ? SemanticCommand::Kind::kBad
                 : only_prohibits     ? SemanticCommand::Kind::kNone
                 : stores > 0         ? SemanticCommand::Kind::kStore
                 : new_stores > 0     ? SemanticCommand::Kind::kStoreNew
                 : retrieves > 0      ? SemanticCommand::Kind::kRetrieve
                                      : SemanticCommand::Kind::kQuery;
}

bool SemanticMemory::RespondTo(GoalLevel level, bool store_only) {
  if (states_.size() < level) states_.resize(level);
  const SemanticCommand& command = Read(level);
  State& state = states_[level - 1u];
  if (command.store == state.store && (store_only || command.other == state.other)) return false;
  Parse();
  const bool store_changed = command.store != state.store;
  if (store_only && command.store.count == 0) {
    // The executed store was removed, and its result with it. Other parts of the command wait for the output phase,
    // unless they were executed already: parts next to the store are not executed again.
    state.store = command.store;
    if (state.results.empty()) return false;
    installer_.Retract(state.results);
    return true;
  }
  state.store = command.store;
  // If anything else on the command link changed, the result is removed in the output phase.
  if (!store_only) state.other = command.other;
  const bool had = !state.results.empty();
  installer_.Retract(state.results);
  switch (command.kind) {
    case SemanticCommand::Kind::kNone:
      return had;
    case SemanticCommand::Kind::kBad: {
      const Goal& goal = uses_.goals.at(level);
      const Triple bad{goal.smem.result, words::kBadCmd, goal.smem.command};
      installer_.Install(level, command.wmes, {&bad, 1}, &state.results);
      return true;
    }
    case SemanticCommand::Kind::kStore:
      // A store is executed once if it is alone, and again with each change of other parts next to it. When these are
      // removed, so is the result.
      if (!store_changed && command.other.count == 0) return had;
      AnswerStore(level, command);
      return true;
    case SemanticCommand::Kind::kStoreNew:
      AnswerStore(level, command);
      return true;
    case SemanticCommand::Kind::kRetrieve:
    case SemanticCommand::Kind::kQuery:
      AnswerRetrieval(level, command);
      return true;
  }
  return true;
}

// Storing -------------------------------------------------------------------------------------------------------------

void SemanticMemory::AnswerStore(GoalLevel level, const SemanticCommand& command) {
  const Symbol result = uses_.goals.at(level).smem.result;
  std::vector<Triple> answer;
  std::map<std::uint32_t, std::uint32_t> made_new;
  for (const Symbol id : command.stored) {
    const bool as_new = command.kind == SemanticCommand::Kind::kStoreNew && !command.link;
    Store(id, as_new ? &made_new : nullptr);
    ++counters_.stores;
    answer.push_back({result, words::kSuccess, id});
  }
  std::ranges::reverse(answer);
  installer_.Install(level, command.wmes, answer, &states_[level - 1u].results);
}

std::uint32_t SemanticMemory::Store(Symbol id, std::map<std::uint32_t, std::uint32_t>* made_new) {
  const auto object_of = [&](Symbol identifier) {
    const Lti linked = uses_.memory.long_term_identifiers()[identifier.index()];
    if (linked != 0 && made_new == nullptr) return ObjectOf(linked);
    if (made_new != nullptr) {
      if (const auto known = made_new->find(identifier.index()); known != made_new->end()) return known->second;
    }
    const std::uint32_t made = NewObject();
    if (made_new != nullptr) made_new->emplace(identifier.index(), made);
    if (linked == 0) {
      uses_.memory.SetLongTerm(identifier, knowledge_->NumberAt(made));
      uses_.long_term.LinkChanged(identifier);
    }
    return made;
  };
  const std::uint32_t object = object_of(id);
  std::vector<std::pair<StoreTerm, StoreTerm>> edges;
  for (const WmeId element : uses_.memory.WmesOf(id)) {
    const Wme& wme = uses_.memory.wme(element);
    if (wme.acceptable || !wme.attribute.IsConstant()) continue;
    if (uses_.memory.record(element).kind == WmeKind::kArchitecture) continue;
    const StoreTerm attribute = TermOf(wme.attribute);
    edges.emplace_back(attribute,
                       wme.value.IsIdentifier() ? StoreTerm::Object(object_of(wme.value)) : TermOf(wme.value));
  }
  // Its augmentations are removed and added again, so that their rows are the newest.
  const std::vector<Edge> old(knowledge_->EdgesAt(object).begin(), knowledge_->EdgesAt(object).end());
  TraceGone(object);
  for (const Edge& edge : old) RemoveEdge(object, edge.attribute, edge.value);
  for (const auto& [attribute, value] : edges) AddEdge(object, attribute, value);
  Touch(object, false);
  return object;
}

// Retrieving ----------------------------------------------------------------------------------------------------------

bool SemanticMemory::AddMath(Symbol object, Cue& cue) {
  const WorkingMemory& memory = uses_.memory;
  for (const WmeId element : memory.WmesOf(object)) {
    const Wme& wme = memory.wme(element);
    const StoreTerm attribute = FindAttribute(wme.attribute);
    if (!wme.attribute.IsConstant()) return false;
    const std::vector<WmeId> tests = wme.value.IsIdentifier() ? memory.WmesOf(wme.value) : std::vector<WmeId>();
    cue.impossible = cue.impossible || tests.empty();  // A requirement without a test is never met.
    for (const WmeId test : tests) {
      const Wme& bound = memory.wme(test);
      constexpr std::pair<Symbol, MathTest> kTests[] = {
          {words::kLess, MathTest::kLess},
          {words::kGreater, MathTest::kGreater},
          {words::kLessOrEqual, MathTest::kLessOrEqual},
          {words::kGreaterOrEqual, MathTest::kGreaterOrEqual},
          {words::kMax, MathTest::kMax},
          {words::kMin, MathTest::kMin},
      };
      const auto* const found =
          std::ranges::find(kTests, bound.attribute, [](const auto& entry) { return entry.first; });
      if (found == std::end(kTests)) continue;
      CueElement made{attribute, StoreTerm()};
      made.math = found->second;
      if (made.math == MathTest::kMax || made.math == MathTest::kMin) {
        // At most one requirement may ask for the largest value, and at most one for the smallest. If no object has
        // the attribute, the last object counts as both.
        cue.impossible =
            cue.impossible || std::ranges::find(cue.elements, made.math, &CueElement::math) != cue.elements.end();
        cue.takes_last = cue.takes_last || !attribute;
      } else {
        if (bound.value.IsNumber()) {
          made.bound = uses_.symbols.NumberValue(bound.value);
        } else {
          cue.impossible = true;  // Nothing is less than a string.
        }
      }
      // If no object has the attribute, its bounds restrict nothing.
      if (attribute) cue.elements.push_back(made);
    }
  }
  return true;
}

bool SemanticMemory::MakeCue(const SemanticCommand& command, Cue& cue) {
  const WorkingMemory& memory = uses_.memory;
  for (const bool negative : {false, true}) {
    const Symbol object = negative ? command.negative : command.asked;
    if (!object) continue;
    bool is_bad = false;
    memory.ForEachWmeOf(object, [&](WmeId element) {
      const Wme& wme = memory.wme(element);
      is_bad = is_bad || !wme.attribute.IsConstant();
      if (is_bad) return;
      const StoreTerm attribute = FindAttribute(wme.attribute);
      const bool any = wme.value.IsIdentifier() && memory.long_term_identifiers()[wme.value.index()] == 0;
      const StoreTerm value = any ? StoreTerm() : FindTerm(wme.value);
      const bool unknown = !attribute || (!any && !value);
      if (unknown && negative) return;  // No object has it.
      cue.impossible = cue.impossible || unknown;
      cue.elements.push_back({attribute, value, negative});
    });
    if (is_bad) return false;
  }
  if (!command.math) return true;
  // Bounds alone find nothing.
  cue.impossible = cue.impossible || cue.elements.empty();
  return AddMath(command.math, cue);
}

Symbol SemanticMemory::Retrieve(GoalLevel level, std::uint32_t root) {
  Retrieval& retrieval = retrieval_;
  // (The reference is valid until the next call.)
  const auto made_of = [&](std::uint32_t object) -> Retrieval::Made& {
    const auto place = std::ranges::lower_bound(retrieval.made, object, {}, &Retrieval::Made::object);
    if (place != retrieval.made.end() && place->object == object) return *place;
    const Symbol id = installer_.NewIdentifier('L', level, command_.link ? knowledge_->NumberAt(object) : 0);
    return *retrieval.made.insert(place, {object, id});
  };
  const Symbol id = made_of(root).id;
  made_of(root).is_opened = true;
  // Breadth first; each object once.
  retrieval.wave.assign(1, root);
  for (std::int64_t left = std::max<std::int64_t>(command_.depth, 1); left > 0 && !retrieval.wave.empty(); --left) {
    retrieval.next.clear();
    for (const std::uint32_t object : retrieval.wave) {
      const Symbol parent = made_of(object).id;
      if (object != root) retrieval.deeper.push_back(parent);
      knowledge_->OrderEdgesAt(object, retrieval.edges);
      StoreTerm attribute;
      Symbol name;
      for (const auto& [rank, edge] : retrieval.edges) {
        if (edge.attribute != attribute) {
          attribute = edge.attribute;
          name = AttributeOf(attribute);
        }
        if (!edge.value.IsObject()) {
          retrieval.contents.push_back({parent, name, SymbolOf(knowledge_->terms(), uses_.symbols, edge.value)});
          continue;
        }
        Retrieval::Made& held = made_of(edge.value.index());
        retrieval.contents.push_back({parent, name, held.id});
        if (std::exchange(held.is_opened, true)) continue;
        retrieval.next.push_back(held.object);
      }
    }
    retrieval.wave.swap(retrieval.next);
  }
  // Contents that are listed last are created first.
  std::ranges::reverse(retrieval.contents);
  return id;
}

void SemanticMemory::Tell(GoalLevel level, const SemanticCommand& command, const Cue& cue,
                          std::span<const std::uint32_t> prohibited, std::uint32_t object) {
  // Maximum number of candidates that are compared, so that queries do not become slow while they are observed.
  constexpr std::size_t kMostCompared = 1000;
  const bool found = object != Knowledge::kNowhere;
  const bool by_number = command.kind == SemanticCommand::Kind::kRetrieve;
  std::string question, reason;
  if (by_number) {
    const Lti number = uses_.memory.long_term_identifiers()[command.asked.index()];
    question = number == 0 ? "an object that is not linked" : "@" + std::to_string(number);
    reason = found ? "asked for by its number" : number == 0 ? "it was never stored" : "there is no such object";
  } else {
    question = CueWords(uses_.memory, uses_.symbols, command.asked, 1);
    if (command.negative) question += " and not " + CueWords(uses_.memory, uses_.symbols, command.negative, 1);
    if (command.math) question += " with " + CueWords(uses_.memory, uses_.symbols, command.math, 2);
    std::size_t candidates = kMostCompared + 1;
    for (const CueElement& element : cue.elements) {
      if (element.negative || !element.attribute) continue;
      const std::uint32_t list = knowledge_->FindList(element.attribute, element.value);
      if (list != Knowledge::kNowhere) candidates = std::min(candidates, knowledge_->ListAt(list).size());
    }
    const bool is_naive = settings_.activation_mode == ActivationMode::kBaseLevel &&
                          settings_.base_update_policy == BaseUpdatePolicy::kNaive;
    const bool compares = candidates <= kMostCompared && !is_naive;  // (A naive search counts its activations.)
    const Spreading* const spreading = settings_.spreading ? &spreading_ : nullptr;
    if (found) {
      std::vector<std::uint32_t> others;
      if (compares) others = search_.Find(*knowledge_, cue, prohibited, 2, spreading);
      reason = WhyFound(*knowledge_, activations_, cue, others);
    } else {
      const bool prohibited_fits =
          !prohibited.empty() && compares && !search_.Find(*knowledge_, cue, {}, 1, spreading).empty();
      reason = WhyNotFound(*knowledge_, uses_.memory, uses_.symbols, command.asked, prohibited_fits);
    }
  }
  const std::string answer = found ? ObjectWords(*knowledge_, object) : std::string();
  RecallInfo info;
  info.level = level;
  info.number = found ? knowledge_->NumberAt(object) : 0;
  info.question = question;
  info.answer = answer;
  info.reason = reason;
  uses_.observers.Notify(Event::kRecall, [&](Observer& o) { o.OnRecall(uses_.agent, info); });
}

void SemanticMemory::AnswerRetrieval(GoalLevel level, const SemanticCommand& command) {
  const MemoryLink link = uses_.goals.at(level).smem;
  std::vector<PreferenceId>& results = states_[level - 1u].results;
  const auto answer = [&](Symbol word, Symbol value) { return Triple{link.result, word, value}; };
  std::uint32_t object = Knowledge::kNowhere;
  bool is_bad = false;
  const bool is_told = uses_.observers.Wants(Event::kRecall);
  if (command.kind == SemanticCommand::Kind::kRetrieve) {
    const Lti number = uses_.memory.long_term_identifiers()[command.asked.index()];
    if (number != 0) object = knowledge_->Find(number);
    if (object != Knowledge::kNowhere) {
      ++counters_.retrieves;
      Touch(object);
    }
    if (is_told) Tell(level, command, {}, {}, object);
  } else {
    Cue& cue = cue_;
    cue.Clear();
    is_bad = !MakeCue(command, cue);
    if (!is_bad) {
      std::vector<std::uint32_t> prohibited;
      for (const Symbol id : command.prohibited) {
        const std::uint32_t other = knowledge_->Find(uses_.memory.long_term_identifiers()[id.index()]);
        if (other == Knowledge::kNowhere) continue;
        prohibited.push_back(other);
        activations_.Prohibit(other);
      }
      Spread(cue);
      ++counters_.queries;
      const std::size_t limit = cue.takes_last ? std::max<std::size_t>(knowledge_->object_count(), 1) : 1;
      const std::vector<std::uint32_t> found =
          search_.Find(*knowledge_, cue, prohibited, limit, settings_.spreading ? &spreading_ : nullptr);
      if (!found.empty()) object = found.back();
      if (is_told) Tell(level, command, cue, prohibited, object);
      if (!found.empty()) {
        if (settings_.activate_on_query) Touch(object);
      }
    }
  }
  retrieval_.Clear();
  std::vector<Triple>& meta = retrieval_.meta;
  if (is_bad) {
    meta.push_back(answer(words::kBadCmd, link.command));
    installer_.Install(level, command.wmes, meta, &results);
    return;
  }
  const bool success = object != Knowledge::kNowhere;
  // The results that are listed first are created last.
  const Symbol verdict = success ? words::kSuccess : words::kFailure;
  if (success) {
    const Symbol retrieved = Retrieve(level, object);
    for (std::size_t n = retrieval_.deeper.size(); n-- > 0;) {
      meta.push_back(answer(words::kDepthRetrieved, retrieval_.deeper[n]));
    }
    meta.push_back(answer(words::kRetrieved, retrieved));
  }
  if (command.negative) meta.push_back(answer(verdict, command.negative));
  meta.push_back(answer(verdict, command.asked));
  installer_.Install(level, command.wmes, meta, &results);
  installer_.Install(level, command.wmes, retrieval_.contents);
}

}  // namespace soarbox::kernel
