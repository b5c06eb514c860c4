// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/alpha_memories.h"

#include <algorithm>

namespace soarbox::kernel {

void AlphaMemories::Begin(std::uint32_t alpha) {
  if (alpha >= states_.size()) {
    states_.resize(alpha + 1u);
  }
  states_[alpha] = AlphaState();
}

/// Replaces a table by one of at least 2^bits buckets, enough for the number of items.
void AlphaMemories::MakeTable(AlphaState& memory, std::uint32_t& table, std::uint8_t& table_bits, std::uint8_t bits) {
  while (memory.count > 1u << bits) {
    ++bits;
  }
  if (table_bits != 0) {
    tables_.Free(table, table_bits);
  }
  table = tables_.Allocate(bits);
  table_bits = bits;
  memory.has_tables = true;
}

std::uint32_t AlphaMemories::OldestItem(const AlphaState& memory) const {
  std::uint32_t index = memory.first;
  while (index != kNil && items_[index].next != kNil) {
    index = items_[index].next;
  }
  return index;
}

// Both functions start at the oldest item, so that each bucket is ordered newest first.
void AlphaMemories::BuildIdTable(std::uint32_t alpha, std::uint8_t bits) {
  AlphaState& memory = states_[alpha];
  MakeTable(memory, memory.id_table, memory.id_bits, bits);
  for (std::uint32_t index = OldestItem(memory); index != kNil; index = items_[index].previous) {
    std::uint32_t& head = tables_[memory.id_table + TablePool::Hash(items_[index].id, memory.id_bits)];
    items_[index].previous_in_bucket = kNil;
    items_[index].next_in_bucket = head;
    if (head != kNil) {
      items_[head].previous_in_bucket = index;
    }
    head = index;
  }
}

void AlphaMemories::BuildPairTable(std::uint32_t alpha, std::uint8_t bits) {
  AlphaState& memory = states_[alpha];
  MakeTable(memory, memory.pair_table, memory.pair_bits, bits);
  for (std::uint32_t index = OldestItem(memory); index != kNil; index = items_[index].previous) {
    const std::uint32_t key = PairKey(items_[index].id, items_[index].value);
    std::uint32_t& head = tables_[memory.pair_table + TablePool::Hash(key, memory.pair_bits)];
    items_[index].next_in_pair = head;
    head = index;
  }
}

void AlphaMemories::BuildValueTable(std::uint32_t alpha, std::uint8_t bits) {
  AlphaState& memory = states_[alpha];
  if (alpha >= value_tables_.size()) {
    value_tables_.resize(states_.size());
  }
  MakeTable(memory, value_tables_[alpha], memory.value_bits, bits);
  for (std::uint32_t index = memory.first; index != kNil; index = items_[index].next) {
    EnterByValue(alpha, index);
  }
}

void AlphaMemories::InsertByValue(std::uint32_t alpha, std::uint32_t index) {
  const AlphaState& memory = states_[alpha];
  if (memory.count > 1u << memory.value_bits) [[unlikely]] {
    BuildValueTable(alpha, static_cast<std::uint8_t>(memory.value_bits + 2));
    return;
  }
  EnterByValue(alpha, index);
}

void AlphaMemories::EnterByValue(std::uint32_t alpha, std::uint32_t index) {
  std::uint32_t& head = tables_[value_tables_[alpha] + TablePool::Hash(items_[index].value, states_[alpha].value_bits)];
  items_[index].next_in_value = head;
  head = index;
}

void AlphaMemories::TakeOutByValue(std::uint32_t alpha, std::uint32_t index) {
  const AlphaState& memory = states_[alpha];
  std::uint32_t* link = &tables_[value_tables_[alpha] + TablePool::Hash(items_[index].value, memory.value_bits)];
  while (*link != index) {
    link = &items_[*link].next_in_value;
  }
  *link = items_[index].next_in_value;
}

void AlphaMemories::Drop(std::uint32_t alpha, ElementLinks& elements) {
  AlphaState& memory = states_[alpha];
  for (std::uint32_t index = memory.first; index != kNil;) {
    const AlphaItem& item = items_[index];
    const std::uint32_t next = item.next;
    std::uint32_t* link = &elements[item.wme].first_item;
    while (*link != index) {
      link = &items_[*link].next_of_wme;
    }
    *link = item.next_of_wme;
    Free(index);
    index = next;
  }
  if (memory.id_bits != 0) {
    tables_.Free(memory.id_table, memory.id_bits);
  }
  if (memory.pair_bits != 0) {
    tables_.Free(memory.pair_table, memory.pair_bits);
  }
  if (memory.value_bits != 0) {
    tables_.Free(value_tables_[alpha], memory.value_bits);
  }
  memory = AlphaState();
}

std::uint32_t AlphaMemories::CountInTable(std::uint32_t table, std::uint32_t bits,
                                          std::uint32_t AlphaItem::*next) const {
  std::uint32_t count = 0;
  for (std::uint32_t n = 0; n < 1u << bits; ++n) {
    for (std::uint32_t item = tables_[table + n]; item != kNil; item = items_[item].*next) {
      ++count;
    }
  }
  return count;
}

std::uint32_t AlphaMemories::CountInIdTable(const AlphaState& memory) const {
  return CountInTable(memory.id_table, memory.id_bits, &AlphaItem::next_in_bucket);
}

std::uint32_t AlphaMemories::CountInPairTable(const AlphaState& memory) const {
  return CountInTable(memory.pair_table, memory.pair_bits, &AlphaItem::next_in_pair);
}

void AlphaMemories::Release() {
  items_.Release();
  free_ = kNil;
  tables_ = TablePool();
  std::fill(states_.begin(), states_.end(), AlphaState());
}

std::uint32_t AlphaMemories::Use(Network& network, ElementLinks& links, const WmeTable& wmes,
                                 const std::uint32_t (&constants)[3], std::uint32_t mask, bool acceptable) {
  std::uint32_t alpha = network.FindAlpha(constants, mask, acceptable);
  if (alpha != kNil) {
    network.UseAlpha(alpha);
    return alpha;
  }
  std::uint32_t general = kNil;
  for (const std::uint32_t drop : {1u, 4u, 5u}) {
    const std::uint32_t rest = mask & ~drop;
    if (rest != mask && general == kNil) {
      const std::uint32_t fewer[3] = {(rest & 1u) ? constants[0] : 0, constants[1], (rest & 4u) ? constants[2] : 0};
      general = network.FindAlpha(fewer, rest, acceptable);
    }
  }
  alpha = network.AddAlpha(constants, mask, acceptable);
  Begin(alpha);
  const auto add_if_fits = [&](std::uint32_t wme) {
    const Wme& element = wmes[wme];
    if (element.acceptable == acceptable && ((mask & 1u) == 0 || element.id.bits() == constants[0]) &&
        ((mask & 2u) == 0 || element.attribute.bits() == constants[1]) &&
        ((mask & 4u) == 0 || element.value.bits() == constants[2])) {
      Insert(alpha, wme, element, links[wme].first_item);
    }
  };
  if (general != kNil) {
    for (std::uint32_t at = (*this)[general].first; at != kNil; at = item(at).next) {
      add_if_fits(item(at).wme);
    }
  } else {
    for (std::uint32_t wme = links.newest(); wme != kNil; wme = links[wme].next) {
      add_if_fits(wme);
    }
  }
  (*this)[alpha].sparse |= (*this)[alpha].count > 1 ? AlphaState::kPrimed : 0;
  return alpha;
}

void AlphaMemories::GiveUp(Network& network, ElementLinks& links, std::uint32_t alpha) {
  if (network.DropAlpha(alpha)) {
    Drop(alpha, links);
  }
}

}  // namespace soarbox::kernel
