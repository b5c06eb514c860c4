// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/shared_knowledge.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>
#include <mutex>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace soarbox::kernel {
namespace {

/// A digest of two words: equal if the same was added in the same order, else (almost certainly) different.
class Digest {
 public:
  using Words = std::pair<std::uint64_t, std::uint64_t>;

  explicit Digest(const Knowledge& knowledge) : knowledge_(knowledge) {}
  void Add(std::uint64_t word) {
    words_.first = (words_.first ^ word) * 0x100000001B3ull;
    words_.first ^= words_.first >> 29;
    words_.second = (words_.second + word) * 0xD6E8FEB86659FD93ull;
    words_.second ^= words_.second >> 32;
  }
  void AddText(std::string_view text) {
    Add(text.size());
    for (const char c : text) Add(static_cast<unsigned char>(c));
  }
  void AddObject(std::uint32_t place) {
    Add(knowledge_.NumberAt(place));
    for (const Edge& edge : knowledge_.EdgesAt(place)) {
      Add(edge.row);
      AddTerm(edge.attribute);
      AddTerm(edge.value);
    }
  }
  Words words() const { return words_; }

 private:
  /// Adds a term. Terms have equal indices if the same was read in the same order; their contents are added once.
  void AddTerm(StoreTerm term) {
    Add(term.bits());
    if (term.IsObject()) return;
    Add(knowledge_.terms().Order(term));
    const std::size_t place = 4 * std::size_t{term.index()} + static_cast<std::size_t>(term.kind());
    if (told_.size() <= place) told_.resize(place + 1);
    if (std::exchange(told_[place], 1) != 0) return;
    if (term.kind() == TermKind::kString) {
      AddText(knowledge_.terms().Text(term));
    } else if (term.kind() == TermKind::kInteger) {
      Add(static_cast<std::uint64_t>(knowledge_.terms().IntegerValue(term)));
    } else {
      Add(std::bit_cast<std::uint64_t>(knowledge_.terms().FloatValue(term)));
    }
  }

  const Knowledge& knowledge_;
  Words words_{0xCBF29CE484222325ull, 0x9E3779B97F4A7C15ull};
  std::vector<std::uint8_t> told_;
};

/// A digest of all objects, augmentations and aliases.
Digest::Words DigestOf(const Knowledge& knowledge) {
  Digest digest(knowledge);
  digest.Add(knowledge.next_number());
  for (std::uint32_t object = 0; object < knowledge.object_count(); ++object) digest.AddObject(object);
  for (const auto& [name, number] : knowledge.Aliases()) {
    digest.AddText(name);
    digest.Add(number);
  }
  return digest.words();
}

/// A digest of the counts and a few objects: most knowledge that differs, differs here.
Digest::Words SketchOf(const Knowledge& knowledge) {
  constexpr std::uint32_t kSamples = 16;
  Digest digest(knowledge);
  digest.Add(knowledge.next_number());
  digest.Add(knowledge.terms().count());
  digest.Add(knowledge.object_count());
  digest.Add(knowledge.edge_count());
  const std::uint32_t step = knowledge.object_count() / kSamples + 1;
  for (std::uint32_t object = 0; object < knowledge.object_count(); object += step) digest.AddObject(object);
  return digest.words();
}

/// Knowledge in use by agents. Its digest is computed when other knowledge has the same sketch.
struct Known {
  std::weak_ptr<Knowledge> knowledge;
  std::optional<Digest::Words> digest;
};

struct Registry {
  std::mutex mutex;
  std::map<TextKey, std::weak_ptr<Knowledge>> by_text;
  std::multimap<Digest::Words, Known> by_sketch;
};

Registry& TheRegistry() {
  static Registry registry;
  return registry;
}

}  // namespace

std::shared_ptr<Knowledge> ShareKnowledge(std::shared_ptr<Knowledge> own) {
  const Digest::Words sketch = SketchOf(*own);
  Registry& registry = TheRegistry();
  {
    const std::lock_guard<std::mutex> lock(registry.mutex);
    std::erase_if(registry.by_sketch, [](const auto& entry) { return entry.second.knowledge.expired(); });
    if (!registry.by_sketch.contains(sketch)) {
      registry.by_sketch.emplace(sketch, Known{own, {}});
      return own;
    }
  }
  const Digest::Words digest = DigestOf(*own);
  const std::lock_guard<std::mutex> lock(registry.mutex);
  const auto [first, last] = registry.by_sketch.equal_range(sketch);
  for (auto entry = first; entry != last; ++entry) {
    Known& known = entry->second;
    const std::shared_ptr<Knowledge> other = known.knowledge.lock();
    if (other == nullptr) continue;
    if (!known.digest) known.digest = DigestOf(*other);
    if (*known.digest == digest) return other;
  }
  registry.by_sketch.emplace(sketch, Known{own, digest});
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
