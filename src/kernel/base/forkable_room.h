// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <memory>

namespace soarbox::kernel {

/// Records that copies of an array share page by page, until one of them writes to a page.
class PageImage {
 public:
  /// Null if the records are few, or if this system has no such pages (left): copies are then made in full.
  static std::shared_ptr<const PageImage> Of(const void* records, std::size_t bytes);
  ~PageImage();
  PageImage(const PageImage&) = delete;
  PageImage& operator=(const PageImage&) = delete;

 private:
  friend class ForkableRoom;
  PageImage(int file, std::size_t bytes) : file_(file), bytes_(bytes) {}

  int file_;
  std::size_t bytes_;  ///< Whole pages.
};

/// The room of a PlainVector that many copies are made of, each of which changes little of it. A copy shares the
/// original's pages if the original has an image (Linux); what it changes, or has beyond them, is its own.
class ForkableRoom {
 public:
  ForkableRoom() = default;
  ForkableRoom(const ForkableRoom&) = delete;
  ForkableRoom& operator=(const ForkableRoom&) = delete;

  /// From now on copies share pages, until the image is forgotten; it must be before anything changes.
  void MakeImage(const void* records, std::size_t bytes) const { image_ = PageImage::Of(records, bytes); }
  void ForgetImage() const { image_.reset(); }

  // What PlainVector asks for. Null: there is no memory. -------------------------------------------------------------

  void* Resize(void* records, std::size_t bytes);
  /// A copy of the records of another room, in this one, which has none. `capacity`: how many bytes there is room for.
  void* Copy(const ForkableRoom& other, const void* records, std::size_t bytes, std::size_t& capacity);
  void Free(void* records) noexcept;
  void Swap(ForkableRoom& other) noexcept;

 private:
  mutable std::shared_ptr<const PageImage> image_;
  std::size_t shared_ = 0;  ///< Bytes at the beginning that are pages of an image; 0: the room is the C library's.
  std::size_t all_ = 0;     ///< With those behind them.
};

}  // namespace soarbox::kernel
