// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace soarbox::script {

class WorldBudget;

/// The memory of one Lua machine: size classes with free lists in a few large chunks, with a limit.
///
/// The place of a block depends only on the sequence of requests, not on the rest of the process. Therefore the order
/// of two blocks (`OrderOf`) is the same in every process, and `pairs` can visit keys that are tables or functions in a
/// stable order. Use it on one thread at a time.
class ScriptMemory {
 public:
  /// `world`, if given, limits all machines together; it must outlive this object.
  explicit ScriptMemory(std::size_t limit_bytes, WorldBudget* world = nullptr)
      : limit_bytes_(limit_bytes), world_(world) {}
  ~ScriptMemory();
  ScriptMemory(const ScriptMemory&) = delete;
  ScriptMemory& operator=(const ScriptMemory&) = delete;

  /// Follows the contract of lua_Alloc: grows, shrinks or frees a block; null if the limit forbids it.
  void* Reallocate(void* block, std::size_t old_size, std::size_t new_size);

  /// Position of a block in the order of this memory; 0 for other addresses.
  std::uint64_t OrderOf(const void* address) const;

  /// Between these two calls, freed blocks wait. Lua frees strings in the order of a hash that differs from process to
  /// process. EndCollection sorts the blocks, so that later allocations are at the same places.
  void BeginCollection() { collecting_ = true; }
  void EndCollection();

  /// Returns unused chunks to the world. For a machine that was refused memory: blocks of one size are not used for
  /// another, so freed blocks alone may not be enough. Call it after a collection.
  void ReleaseFreeChunks();

  /// True if the last chunk brought this memory near its share of the world's: then garbage should be collected before
  /// an allocation is refused. Resets the flag.
  bool TakeNearRefusal() { return std::exchange(near_refusal_, false); }

  /// The block that was allocated last, and its requested size.
  std::pair<void*, std::size_t> last_block() const { return {last_block_, last_size_}; }
  /// Notices when this block is freed, moved or resized; watched() is null from then on.
  void Watch(const void* block) { watched_ = block; }
  const void* watched() const { return watched_; }

  std::size_t used_bytes() const { return used_bytes_; }
  std::size_t limit_bytes() const { return limit_bytes_; }
  /// True if the last refusal was because of the world's limit, not its own.
  bool world_refused() const { return world_refused_; }

 private:
  static constexpr std::size_t kSmallStep = 16;
  static constexpr std::size_t kSmallLimit = 1024;
  static constexpr std::size_t kSmallClasses = kSmallLimit / kSmallStep;
  /// Above kSmallLimit, four classes for each doubling, up to a gigabyte: at most a fifth of a block is unused.
  static constexpr std::size_t kPerDoubling = 4, kDoublings = 20;
  static constexpr std::size_t kClasses = kSmallClasses + kPerDoubling * kDoublings;

  struct FreeBlock {
    FreeBlock* next;
  };
  struct Chunk {
    std::unique_ptr<std::byte[]> bytes;  ///< Null: released.
    std::size_t size = 0;
    std::size_t handed_out = 0;  ///< Bytes of the blocks that were created from it.
  };

  static std::size_t ClassOf(std::size_t size);
  static std::size_t SizeOfClass(std::size_t size_class);
  void* Take(std::size_t size_class);
  void GiveBack(void* block, std::size_t size_class);
  void PutInOrder(std::size_t size_class);

  std::size_t limit_bytes_;
  WorldBudget* world_;
  std::size_t reserved_bytes_ = 0;  ///< In chunks.
  bool world_refused_ = false;
  bool near_refusal_ = false;
  std::size_t used_bytes_ = 0;
  void* last_block_ = nullptr;
  std::size_t last_size_ = 0;
  const void* watched_ = nullptr;
  bool collecting_ = false;
  std::array<FreeBlock*, kClasses> free_{};
  std::array<FreeBlock*, kClasses> waiting_{};  ///< Freed in the current collection.
  std::vector<Chunk> chunks_;                   // In the order of their creation.
  std::byte* next_ = nullptr;                   // The unused rest of the newest shared chunk.
  std::size_t rest_ = 0;
  std::size_t shared_chunk_ = 0;  // Index of the newest shared chunk in chunks_, if rest_ is not 0.
  std::size_t next_chunk_size_ = std::size_t{32} * 1024;
};

}  // namespace soarbox::script
