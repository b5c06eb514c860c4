// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <string_view>
#include <vector>

namespace soarbox::kernel {

/// Storage for short texts in size classes (powers of two from 8 bytes) with free lists. Once the free lists have
/// filled, storing and releasing texts does not allocate. Texts do not move.
class TextArena {
 public:
  /// Copies the text and returns the copy.
  const char* Store(std::string_view text) {
    const int size_class = ClassOf(text.size());
    char* place = Take(size_class);
    text.copy(place, text.size());
    return place;
  }

  /// Frees a text of this length.
  void Release(const char* text, std::size_t length) {
    FreeText* free = reinterpret_cast<FreeText*>(const_cast<char*>(text));
    const int size_class = ClassOf(length);
    free->next = free_[static_cast<std::size_t>(size_class)];
    free_[static_cast<std::size_t>(size_class)] = free;
  }

  std::size_t MemoryBytes() const { return bytes_; }
  /// Sets the maximum size of this arena in bytes. Store() of a long text that exceeds it throws std::bad_alloc, as if
  /// memory had run out. Without it, one rule that keeps doubling a text could exhaust the machine's memory.
  void Limit(std::size_t bytes) { limit_ = bytes; }

 private:
  struct FreeText {
    FreeText* next;
  };
  static constexpr std::size_t kBlockBytes = 4096;

  static int ClassOf(std::size_t length) { return length <= 8 ? 0 : static_cast<int>(std::bit_width(length - 1)) - 3; }

  char* Take(int size_class) {
    FreeText*& head = free_[static_cast<std::size_t>(size_class)];
    if (head != nullptr) {
      char* place = reinterpret_cast<char*>(head);
      head = head->next;
      return place;
    }
    const std::size_t size = std::size_t{8} << size_class;
    if (size > kBlockBytes / 2) {
      if (size > limit_ || bytes_ > limit_ - size) throw std::bad_alloc();
      blocks_.push_back(std::make_unique<char[]>(size));
      bytes_ += size;
      return blocks_.back().get();
    }
    if (block_left_ < size) {
      blocks_.push_back(std::make_unique<char[]>(kBlockBytes));
      bytes_ += kBlockBytes;
      block_next_ = blocks_.back().get();
      block_left_ = kBlockBytes;
    }
    char* place = block_next_;
    block_next_ += size;
    block_left_ -= size;
    return place;
  }

  std::array<FreeText*, 48> free_{};
  std::vector<std::unique_ptr<char[]>> blocks_;
  char* block_next_ = nullptr;
  std::size_t block_left_ = 0;
  std::size_t bytes_ = 0;
  std::size_t limit_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace soarbox::kernel
