// SPDX-License-Identifier: BSD-2-Clause
#include "world/navigation_store.h"

#include <DetourAlloc.h>
#include <sys/mman.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <new>

#include "world/shared_navigation.h"
#include "world/state_hash.h"

namespace soarbox::world {
namespace {

constexpr std::size_t kMostMeshes = 64;
constexpr std::size_t kBytes = std::size_t{64} << 20;  ///< Only pages that are used need physical memory.
using Triangle = std::array<Vec3, 3>;

/// One mesh. Its state is written last and read first.
struct Slot {
  std::atomic<std::uint32_t> is_whole;
  std::uint64_t source, check;
  std::size_t at, tile_bytes, triangles;
};

/// The beginning of the memory that all processes share.
struct Head {
  std::atomic<std::size_t> used;   ///< Number of used bytes after the head.
  std::atomic<std::size_t> slots;  ///< Number of used slots.
  std::array<Slot, kMostMeshes> slot;
};
static_assert(std::atomic<std::size_t>::is_always_lock_free, "processes share it");

Head* shared = nullptr;

std::byte* DataOf(Head& head) {
  return reinterpret_cast<std::byte*>(&head) + sizeof(Head);
}

std::string_view BytesOf(const std::byte* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace

std::uint64_t CheckOfNavigation(std::string_view bytes) {
  StateHash hash;
  hash.Add(bytes);
  return hash.value();
}

std::optional<BuiltNavigation> CopyNavigation(std::string_view bytes, std::size_t tile_bytes) {
  BuiltNavigation built;
  built.tile = static_cast<unsigned char*>(dtAlloc(tile_bytes, DT_ALLOC_PERM));
  if (built.tile == nullptr) return std::nullopt;
  built.tile_size = static_cast<int>(tile_bytes);
  std::memcpy(built.tile, bytes.data(), tile_bytes);
  built.triangles.resize((bytes.size() - tile_bytes) / sizeof(Triangle));
  std::memcpy(built.triangles.data(), bytes.data() + tile_bytes, bytes.size() - tile_bytes);
  return built;
}

void ShareNavigation() {
  if (shared != nullptr) return;
  void* memory = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory != MAP_FAILED) shared = new (memory) Head{};
}

std::optional<BuiltNavigation> FindSharedNavigation(std::uint64_t source) {
  if (shared == nullptr) return std::nullopt;
  for (Slot& slot : shared->slot) {
    if (slot.is_whole.load(std::memory_order_acquire) == 0 || slot.source != source) continue;
    const std::string_view bytes =
        BytesOf(DataOf(*shared) + slot.at, slot.tile_bytes + slot.triangles * sizeof(Triangle));
    if (CheckOfNavigation(bytes) == slot.check) return CopyNavigation(bytes, slot.tile_bytes);
  }
  return std::nullopt;
}

void OfferNavigation(std::uint64_t source, const BuiltNavigation& built) {
  if (shared == nullptr || built.tile == nullptr) return;
  const auto tile_bytes = static_cast<std::size_t>(built.tile_size);
  const std::size_t triangle_bytes = built.triangles.size() * sizeof(Triangle);
  const std::size_t bytes = (tile_bytes + triangle_bytes + 15) / 16 * 16;
  const std::size_t room = kBytes - sizeof(Head);
  if (bytes > room || shared->used.load() > room - bytes || shared->slots.load() >= kMostMeshes) return;
  const std::size_t at = shared->used.fetch_add(bytes);
  const std::size_t number = shared->slots.fetch_add(1);
  if (at > room - bytes || number >= kMostMeshes) return;  // Another process has used the rest in the meantime.
  std::byte* data = DataOf(*shared) + at;
  std::memcpy(data, built.tile, tile_bytes);
  std::memcpy(data + tile_bytes, built.triangles.data(), triangle_bytes);
  Slot& slot = shared->slot[number];
  slot.source = source;
  slot.check = CheckOfNavigation(BytesOf(data, tile_bytes + triangle_bytes));
  slot.at = at;
  slot.tile_bytes = tile_bytes;
  slot.triangles = built.triangles.size();
  slot.is_whole.store(1, std::memory_order_release);
}

}  // namespace soarbox::world
