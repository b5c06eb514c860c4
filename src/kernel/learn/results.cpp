// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/results.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "kernel/base/symbol_table.h"
#include "kernel/decide/firing.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

bool ResultCollector::Collect(InstantiationId id, Explanation& out) {
  const WorkingMemory& memory = uses_.memory;
  out.results.clear();
  out.children.clear();
  for (PreferenceId p = uses_.instantiations[id].preferences; p != PreferenceId::kNone;
       p = memory.preference(p).next_of_instantiation) {
    if (memory.level(memory.preference(p).id) >= out.level) continue;
    parts_.push_back({p, Symbol(), {}});
    // Depth-first search with an explicit stack, because structures may be arbitrarily deep.
    while (!parts_.empty()) {
      const Part part = parts_.back();
      parts_.pop_back();
      if (part.preference != PreferenceId::kNone) {
        Add(part.preference, part.from, out);
      } else {
        AddPartsOf(part.object, id, part.from, out);
      }
    }
  }
  return !out.results.empty();
}

void ResultCollector::Add(PreferenceId preference, const Explanation::Child& from, Explanation& out) {
  WorkingMemory& memory = uses_.memory;
  if (memory.preference(preference).level != out.level) {
    preference = uses_.firing.CloneAtLevel(preference, out.level);
    if (preference == PreferenceId::kNone) return;
  }
  if (from.parent != PreferenceId::kNone) out.children.push_back({preference, from.parent, from.by_referent});
  if (std::exchange(memory.mutable_preference(preference).seen, out.trace_number) == out.trace_number) return;
  const Preference& content = memory.preference(preference);
  // A result that equals another one adds nothing.
  if (std::ranges::any_of(out.results, [&](PreferenceId other) {
        const Preference& p = memory.preference(other);
        return p.id == content.id && p.attribute == content.attribute && p.value == content.value &&
               p.referent == content.referent && p.type == content.type;
      })) {
    return;
  }
  out.results.push_back(preference);
  parts_.push_back({PreferenceId::kNone, content.referent, {PreferenceId::kNone, preference, true}});
  parts_.push_back({PreferenceId::kNone, content.value, {PreferenceId::kNone, preference, false}});
}

/// If an object of the substate becomes part of a result, it is added with all its contents. The object may even be a
/// state. Then the elements that the architecture created for it do not become part of the result.
void ResultCollector::AddPartsOf(Symbol id, InstantiationId base, const Explanation::Child& from, Explanation& out) {
  const WorkingMemory& memory = uses_.memory;
  if (!id.IsIdentifier() || memory.level(id) < out.level) return;
  if (seen_identifiers_.size() <= id.index()) seen_identifiers_.resize(id.index() + 1u, 0);
  if (std::exchange(seen_identifiers_[id.index()], out.trace_number) == out.trace_number) return;
  const IdentifierRecord& record = memory.identifier(id);
  const std::size_t first_part = parts_.size();
  for (WmeId wme = record.input_wmes; wme != WmeId::kNone; wme = memory.record(wme).next) {
    parts_.push_back({PreferenceId::kNone, memory.wme(wme).value, {}});
  }
  for (SlotId slot = record.slots; slot != SlotId::kNone; slot = memory.slot(slot).next) {
    const std::size_t first_preference = parts_.size();
    for (const PreferenceId first : {memory.slot(slot).acceptable, memory.slot(slot).others}) {
      for (PreferenceId p = first; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
        parts_.push_back({p, Symbol(), from});
      }
    }
    // Newest first, regardless of level and type.
    std::sort(parts_.begin() + static_cast<std::ptrdiff_t>(first_preference), parts_.end(),
              [&](const Part& a, const Part& b) {
                return memory.preference(a.preference).stamp > memory.preference(b.preference).stamp;
              });
    for (WmeId wme = memory.slot(slot).wmes; wme != WmeId::kNone; wme = memory.record(wme).next) {
      if (memory.record(wme).preference != PreferenceId::kNone) continue;
      parts_.push_back({PreferenceId::kNone, memory.wme(wme).value, {}});
    }
  }
  // Preferences of the same firing are not in their slots yet.
  for (PreferenceId p = uses_.instantiations[base].preferences; p != PreferenceId::kNone;
       p = memory.preference(p).next_of_instantiation) {
    if (memory.preference(p).id == id) parts_.push_back({p, Symbol(), from});
  }
  std::reverse(parts_.begin() + static_cast<std::ptrdiff_t>(first_part), parts_.end());
}

#ifdef SOARBOX_CHECK_INVARIANTS
/// A missing preference would lose its support when the substate is removed.
void ResultCollector::Check(const Explanation& explanation) const {
  const WorkingMemory& memory = uses_.memory;
  std::vector<Symbol> reached;
  const auto reach = [&](Symbol id) {
    if (id.IsIdentifier() && memory.level(id) >= explanation.level && std::ranges::find(reached, id) == reached.end()) {
      reached.push_back(id);
    }
  };
  for (const PreferenceId result : explanation.results) {
    reach(memory.preference(result).value);
    reach(memory.preference(result).referent);
  }
  for (std::size_t n = 0; n < reached.size(); ++n) {
    for (SlotId slot = memory.identifier(reached[n]).slots; slot != SlotId::kNone; slot = memory.slot(slot).next) {
      for (const PreferenceId first : {memory.slot(slot).acceptable, memory.slot(slot).others}) {
        for (PreferenceId p = first; p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
          const PreferenceId local = uses_.firing.CloneAtLevel(p, explanation.level);
          if (local == PreferenceId::kNone) continue;
          reach(memory.preference(p).value);
          reach(memory.preference(p).referent);
          if (memory.preference(local).seen == explanation.trace_number) continue;
          std::fprintf(stderr, "soarbox: a result is incomplete, missing: (%s ^%s %s)\n",
                       ToString(uses_.symbols, memory.preference(p).id).c_str(),
                       ToString(uses_.symbols, memory.preference(p).attribute).c_str(),
                       ToString(uses_.symbols, memory.preference(p).value).c_str());
          std::abort();
        }
      }
    }
  }
}
#else
void ResultCollector::Check(const Explanation&) const {}
#endif

}  // namespace soarbox::kernel
