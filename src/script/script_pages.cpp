// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_pages.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <mutex>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace soarbox::script {
namespace {

constexpr std::size_t kBlock = std::size_t{2} << 20;
constexpr std::size_t kSmallest = 4096;
/// Larger requests get their own memory.
constexpr std::size_t kLargest = kBlock / 2;

/// Pieces of blocks. The size of a piece is a power of two, and a released piece goes to the free list of its size. The
/// blocks are released when no piece is in use.
class Pages {
 public:
  std::byte* Take(std::size_t size) {
    const std::lock_guard lock(mutex_);
    Piece*& free = free_[ClassOf(size)];
    std::byte* taken = nullptr;
    if (free) {
      taken = reinterpret_cast<std::byte*>(free);
      free = free->next;
    } else {
      if (rest_ < size && !TakeBlock()) return nullptr;
      taken = next_;
      next_ += size;
      rest_ -= size;
    }
    ++in_use_;
    return taken;
  }

  void GiveBack(std::byte* pages, std::size_t size) {
    const std::lock_guard lock(mutex_);
    Keep(pages, size);
    if (--in_use_ > 0) return;
    for (std::byte* block : blocks_) std::free(block);
    blocks_.clear();
    free_ = {};
    next_ = nullptr;
    rest_ = 0;
  }

 private:
  struct Piece {
    Piece* next;
  };

  static std::size_t ClassOf(std::size_t size) { return static_cast<std::size_t>(std::countr_zero(size)); }

  void Keep(std::byte* pages, std::size_t size) {
    Piece*& free = free_[ClassOf(size)];
    free = new (pages) Piece{free};
  }

  bool TakeBlock() {
    auto* block = static_cast<std::byte*>(std::aligned_alloc(kBlock, kBlock));
    if (!block) return false;
#ifdef __linux__
    madvise(block, kBlock, MADV_HUGEPAGE);  // Without large pages, normal pages are used.
#endif
    // The rest of the previous block becomes smaller pieces.
    while (rest_ >= kSmallest) {
      const std::size_t piece = std::bit_floor(rest_);
      Keep(next_, piece);
      next_ += piece;
      rest_ -= piece;
    }
    blocks_.push_back(block);
    next_ = block;
    rest_ = kBlock;
    return true;
  }

  std::mutex mutex_;
  std::array<Piece*, 64> free_{};  // By the logarithm of their sizes.
  std::vector<std::byte*> blocks_;
  std::byte* next_ = nullptr;  // The unused rest of the newest block.
  std::size_t rest_ = 0;
  std::size_t in_use_ = 0;
};

Pages& All() {
  static Pages pages;
  return pages;
}

}  // namespace

std::byte* TakePages(std::size_t bytes) {
  if (bytes > kLargest) return new (std::nothrow) std::byte[bytes];
  return All().Take(std::bit_ceil(std::max(bytes, kSmallest)));
}

void GivePagesBack(std::byte* pages, std::size_t bytes) {
  if (bytes > kLargest) {
    delete[] pages;
  } else {
    All().GiveBack(pages, std::bit_ceil(std::max(bytes, kSmallest)));
  }
}

}  // namespace soarbox::script
