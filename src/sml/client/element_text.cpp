// SPDX-License-Identifier: BSD-2-Clause
#include <atomic>
#include <cstdint>
#include <cstring>
#include <mutex>
#include <new>

#include "sml/client/shared_text.h"
#include "sml/client/soarbox_ElementText.h"

namespace sml {

// A text of one object ------------------------------------------------------------------------------------------------

void ElementText::Assign(char const* text, std::size_t size) {
  if (size == 0) text = "";  // Empty texts may have a null pointer.
  if (!IsLong() && size <= kMark) {
    std::memmove(bytes_, text, size);
    if (size < kMark) bytes_[size] = 0;
    return;
  }
  std::uint32_t room = 0;
  if (IsLong()) std::memcpy(&room, bytes_ + sizeof(char*), sizeof room);
  if (size < room) {
    std::memmove(LongText(), text, size);
    LongText()[size] = 0;
    return;
  }
  char* const longer = new char[size + 1];
  std::memcpy(longer, text, size);
  longer[size] = 0;
  Release();
  room = static_cast<std::uint32_t>(size + 1 < UINT32_MAX ? size + 1 : UINT32_MAX);
  std::memcpy(bytes_, &longer, sizeof longer);
  std::memcpy(bytes_ + sizeof(char*), &room, sizeof room);
  bytes_[kMark] = 1;
}

// Texts shared by all agents ------------------------------------------------------------------------------------------

namespace {

struct SharedEntry {
  std::uint32_t hash;
  std::uint32_t size;
  char* text() { return reinterpret_cast<char*>(this + 1); }
};

constexpr std::size_t kLongestShared = 64;
constexpr std::size_t kSharedSlots = 8192;  // A power of two.
constexpr std::size_t kMostShared = kSharedSlots / 2;

// Entries are never removed, so readers need no lock.
std::atomic<SharedEntry*> shared_slots[kSharedSlots];
std::atomic<std::size_t> shared_count{0};
std::mutex sharing;

std::uint32_t HashOf(std::string_view text) {
  std::uint64_t hash = text.size() * 0x9E3779B97F4A7C15ull;
  const char* at = text.data();
  for (std::size_t left = text.size(); left > 0;) {
    std::uint64_t word = 0;
    const std::size_t part = left < sizeof word ? left : sizeof word;
    std::memcpy(&word, at, part);
    hash = (hash ^ word) * 0x9E3779B97F4A7C15ull;
    hash ^= hash >> 32;
    at += part;
    left -= part;
  }
  return static_cast<std::uint32_t>(hash);
}

/// The slot of the text, or the free slot where it can be inserted.
std::size_t Locate(std::string_view text, std::uint32_t hash) {
  for (std::size_t slot = hash & (kSharedSlots - 1);; slot = (slot + 1) & (kSharedSlots - 1)) {
    SharedEntry* const entry = shared_slots[slot].load(std::memory_order_acquire);
    if (!entry) return slot;
    if (entry->hash == hash && std::string_view(entry->text(), entry->size) == text) return slot;
  }
}

char const* AddShared(std::string_view text, std::uint32_t hash) {
  if (shared_count.load(std::memory_order_relaxed) >= kMostShared) return nullptr;
  const std::lock_guard lock(sharing);
  const std::size_t slot = Locate(text, hash);
  if (SharedEntry* const entry = shared_slots[slot].load(std::memory_order_relaxed)) return entry->text();
  if (shared_count.load(std::memory_order_relaxed) >= kMostShared) return nullptr;
  auto* const entry = static_cast<SharedEntry*>(::operator new(sizeof(SharedEntry) + text.size() + 1));
  entry->hash = hash;
  entry->size = static_cast<std::uint32_t>(text.size());
  text.copy(entry->text(), text.size());
  entry->text()[text.size()] = 0;
  shared_slots[slot].store(entry, std::memory_order_release);
  shared_count.fetch_add(1, std::memory_order_relaxed);
  return entry->text();
}

}  // namespace

char const* SharedText(std::string_view text) {
  if (text.size() > kLongestShared) return nullptr;
  const std::uint32_t hash = HashOf(text);
  SharedEntry* const entry = shared_slots[Locate(text, hash)].load(std::memory_order_acquire);
  return entry ? entry->text() : AddShared(text, hash);
}

}  // namespace sml
