// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/base/forkable_room.h"

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <utility>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace soarbox::kernel {

#ifdef __linux__

namespace {

constexpr std::size_t kFewest = std::size_t{32} << 10;  ///< In bytes; smaller arrays are copied.
/// A process may have 65,530 mappings and often 1,024 open files. These limits leave most of both to other code.
constexpr int kMostRooms = 8192;  ///< Each needs two mappings.
constexpr int kMostImages = 64;
std::atomic<int> rooms = 0;
std::atomic<int> images = 0;

std::size_t PageBytes() {
  static const auto bytes = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  return bytes;
}
std::size_t WholePages(std::size_t bytes) {
  return (bytes + PageBytes() - 1) / PageBytes() * PageBytes();
}

/// Increments `count` and returns true, unless that would exceed `most`.
bool TakeOne(std::atomic<int>& count, int most) {
  if (count.fetch_add(1, std::memory_order_relaxed) < most) return true;
  count.fetch_sub(1, std::memory_order_relaxed);
  return false;
}

bool WriteAll(int file, const void* records, std::size_t bytes) {
  const char* from = static_cast<const char*>(records);
  while (bytes != 0) {
    const ssize_t written = write(file, from, bytes);
    if (written <= 0) return false;
    from += written;
    bytes -= static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace

std::shared_ptr<const PageImage> PageImage::Of(const void* records, std::size_t bytes) {
  if (bytes < kFewest || !TakeOne(images, kMostImages)) return nullptr;
  const int file = memfd_create("rules", MFD_CLOEXEC);
  if (file >= 0 && WriteAll(file, records, bytes) && ftruncate(file, static_cast<off_t>(WholePages(bytes))) == 0) {
    return std::shared_ptr<const PageImage>(new PageImage(file, WholePages(bytes)));
  }
  if (file >= 0) close(file);
  images.fetch_sub(1, std::memory_order_relaxed);
  return nullptr;
}

// Mapped pages stay valid after the file is closed.
PageImage::~PageImage() {
  close(file_);
  images.fetch_sub(1, std::memory_order_relaxed);
}

void* ForkableRoom::Copy(const ForkableRoom& other, const void* records, std::size_t bytes, std::size_t& capacity) {
  if (other.image_ != nullptr && TakeOne(rooms, kMostRooms)) {
    const PageImage& image = *other.image_;
    void* const mapped = mmap(nullptr, image.bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE, image.file_, 0);
    if (mapped != MAP_FAILED) {
      capacity = shared_ = all_ = image.bytes_;
      return mapped;
    }
    rooms.fetch_sub(1, std::memory_order_relaxed);
  }
  void* const made = std::malloc(bytes);
  if (made != nullptr) std::memcpy(made, records, bytes);
  capacity = bytes;
  return made;
}

void* ForkableRoom::Resize(void* records, std::size_t bytes) {
  if (shared_ == 0) return std::realloc(records, bytes);
  bytes = WholePages(bytes);
  if (bytes <= all_) return records;
  // Moves the pages without copying them: first those of the image, then the rest.
  void* const moved = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (moved == MAP_FAILED) return nullptr;
  if (mremap(records, shared_, shared_, MREMAP_MAYMOVE | MREMAP_FIXED, moved) == MAP_FAILED) {
    munmap(moved, bytes);
    return nullptr;
  }
  const std::size_t rest = all_ - shared_;
  char* const from = static_cast<char*>(records) + shared_;
  char* const to = static_cast<char*>(moved) + shared_;
  if (rest != 0 && mremap(from, rest, bytes - shared_, MREMAP_MAYMOVE | MREMAP_FIXED, to) == MAP_FAILED) {
    std::memcpy(to, from, rest);
    munmap(from, rest);
  }
  all_ = bytes;
  return moved;
}

void ForkableRoom::Free(void* records) noexcept {
  if (shared_ == 0) {
    std::free(records);
    return;
  }
  munmap(records, all_);
  rooms.fetch_sub(1, std::memory_order_relaxed);
  shared_ = all_ = 0;
}

#else

std::shared_ptr<const PageImage> PageImage::Of(const void*, std::size_t) {
  return nullptr;
}
PageImage::~PageImage() = default;

void* ForkableRoom::Copy(const ForkableRoom&, const void* records, std::size_t bytes, std::size_t& capacity) {
  void* const made = std::malloc(bytes);
  if (made != nullptr) std::memcpy(made, records, bytes);
  capacity = bytes;
  return made;
}
void* ForkableRoom::Resize(void* records, std::size_t bytes) {
  return std::realloc(records, bytes);
}
void ForkableRoom::Free(void* records) noexcept {
  std::free(records);
}

#endif

void ForkableRoom::Swap(ForkableRoom& other) noexcept {
  image_.swap(other.image_);
  std::swap(shared_, other.shared_);
  std::swap(all_, other.all_);
}

}  // namespace soarbox::kernel
