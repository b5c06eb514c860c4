// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/shared_knowledge.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace soarbox::kernel {
namespace {

/// Two words that equal knowledge has in common, and other knowledge does not: every object, augmentation and name, in
/// order.
std::pair<std::uint64_t, std::uint64_t> DigestOf(const Knowledge& knowledge) {
  std::uint64_t first = 0xCBF29CE484222325ull, second = 0x9E3779B97F4A7C15ull;
  const auto add = [&](std::uint64_t word) {
    first = (first ^ word) * 0x100000001B3ull;
    first ^= first >> 29;
    second = (second + word) * 0xD6E8FEB86659FD93ull;
    second ^= second >> 32;
  };
  const auto add_text = [&](std::string_view text) {
    add(text.size());
    for (const char c : text) add(static_cast<unsigned char>(c));
  };
  // Terms have the same indices where the same was read in the same order; texts are told once.
  std::vector<std::uint8_t> told;
  const auto add_term = [&](StoreTerm term) {
    add(term.bits());
    if (term.IsObject()) return;
    add(knowledge.terms().Order(term));
    const std::size_t place = 4 * std::size_t{term.index()} + static_cast<std::size_t>(term.kind());
    if (told.size() <= place) told.resize(place + 1);
    if (std::exchange(told[place], 1) != 0) return;
    std::string text;
    knowledge.terms().Append(text, term);
    add_text(text);
    if (term.kind() == TermKind::kFloat) {
      const double value = knowledge.terms().FloatValue(term);
      std::uint64_t bits;
      static_assert(sizeof(bits) == sizeof(value));
      std::memcpy(&bits, &value, sizeof(bits));
      add(bits);
    }
  };
  add(knowledge.next_number());
  for (std::uint32_t object = 0; object < knowledge.object_count(); ++object) {
    add(knowledge.NumberAt(object));
    for (const Edge& edge : knowledge.EdgesAt(object)) {
      add(edge.row);
      add_term(edge.attribute);
      add_term(edge.value);
    }
  }
  for (const auto& [name, number] : knowledge.Aliases()) {
    add_text(name);
    add(number);
  }
  return {first, second};
}

struct Registry {
  std::mutex mutex;
  std::map<TextKey, std::weak_ptr<Knowledge>> by_text;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::weak_ptr<Knowledge>> known;
};

Registry& TheRegistry() {
  static Registry registry;
  return registry;
}

}  // namespace

std::shared_ptr<Knowledge> ShareKnowledge(std::shared_ptr<Knowledge> own) {
  const auto digest = DigestOf(*own);
  Registry& registry = TheRegistry();
  const std::lock_guard<std::mutex> lock(registry.mutex);
  std::erase_if(registry.known, [](const auto& entry) { return entry.second.expired(); });
  std::weak_ptr<Knowledge>& known = registry.known[digest];
  if (std::shared_ptr<Knowledge> other = known.lock()) {
    if (other->object_count() == own->object_count() && other->edge_count() == own->edge_count()) return other;
  }
  known = own;
  return own;
}

TextKey KeyOfText(std::string_view text, Lti next_number) {
  TextKey key{0xCBF29CE484222325ull, 0x9E3779B97F4A7C15ull, text.size(), next_number};
  for (std::size_t at = 0; at < text.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, text.data() + at, std::min<std::size_t>(8, text.size() - at));
    key.first = (key.first ^ word) * 0x100000001B3ull;
    key.first ^= key.first >> 29;
    key.second = (key.second + word) * 0xD6E8FEB86659FD93ull;
    key.second ^= key.second >> 32;
  }
  return key;
}

std::shared_ptr<Knowledge> KnowledgeOfText(const TextKey& key) {
  Registry& registry = TheRegistry();
  const std::lock_guard<std::mutex> lock(registry.mutex);
  const auto found = registry.by_text.find(key);
  return found == registry.by_text.end() ? nullptr : found->second.lock();
}

void NoteKnowledgeOfText(const TextKey& key, const std::shared_ptr<Knowledge>& shared) {
  Registry& registry = TheRegistry();
  const std::lock_guard<std::mutex> lock(registry.mutex);
  std::erase_if(registry.by_text, [](const auto& entry) { return entry.second.expired(); });
  registry.by_text[key] = shared;
}

}  // namespace soarbox::kernel
