// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <memory>

namespace soarbox::kernel {

/// An image of the records of an array. Copies of the array share its pages copy-on-write.
class PageImage {
 public:
  /// Returns null if the array is small, if there are too many images already, or if the system does not support such
  /// pages. Copies of the array are then full copies.
  static std::shared_ptr<const PageImage> Of(const void* records, std::size_t bytes);
  ~PageImage();
  PageImage(const PageImage&) = delete;
  PageImage& operator=(const PageImage&) = delete;

 private:
  friend class ForkableRoom;
  PageImage(int file, std::size_t bytes) : file_(file), bytes_(bytes) {}

  int file_;
  std::size_t bytes_;  ///< A multiple of the page size.
};

/// The storage of a PlainVector with many copies that differ little. A copy shares the pages of the original if the
/// original has an image (Linux only). A copy owns the pages that it changes and the records beyond the image.
class ForkableRoom {
 public:
  ForkableRoom() = default;
  ForkableRoom(const ForkableRoom&) = delete;
  ForkableRoom& operator=(const ForkableRoom&) = delete;

  /// Copies made from now on share pages. Call ForgetImage() before the records change.
  void MakeImage(const void* records, std::size_t bytes) const { image_ = PageImage::Of(records, bytes); }
  void ForgetImage() const { image_.reset(); }

  // The interface that PlainVector uses. Functions return null if there is no memory. --------------------------------

  void* Resize(void* records, std::size_t bytes);
  /// Copies the records of `other` into this room, which must be empty. Sets `capacity` to the size of the allocated
  /// memory in bytes.
  void* Copy(const ForkableRoom& other, const void* records, std::size_t bytes, std::size_t& capacity);
  void Free(void* records) noexcept;
  void Swap(ForkableRoom& other) noexcept;

 private:
  mutable std::shared_ptr<const PageImage> image_;
  std::size_t shared_ = 0;  ///< Bytes at the beginning that are mapped from an image; 0: the memory is from malloc.
  std::size_t all_ = 0;     ///< Total number of bytes, including the shared ones.
};

}  // namespace soarbox::kernel
