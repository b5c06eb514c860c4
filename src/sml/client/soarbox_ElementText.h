// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstring>

namespace sml {

/// A text of one object, in sixteen bytes: up to fifteen characters are stored inside, longer texts on the heap.
/// Internal; not part of the interface of Soar 9.6.3.
class ElementText {
 public:
  ElementText() { bytes_[0] = bytes_[kMark] = 0; }
  ~ElementText() { Release(); }
  ElementText(ElementText const&) = delete;
  ElementText& operator=(ElementText const&) = delete;

  /// Zero-terminated. Valid until the next change.
  char const* c_str() const { return IsLong() ? LongText() : bytes_; }
  bool empty() const { return *c_str() == 0; }
  /// Copies the text. Does not allocate if it is not longer than the current one.
  void Assign(char const* text, std::size_t size);

 private:
  static const std::size_t kMark = 15;  ///< The end of a short text of maximum length; also marks long texts.

  bool IsLong() const { return bytes_[kMark] != 0; }
  char* LongText() const {
    char* text;
    std::memcpy(&text, bytes_, sizeof text);
    return text;
  }
  void Release() {
    if (IsLong()) delete[] LongText();
  }

  alignas(char*) char bytes_[kMark + 1];  ///< For long texts: the address of the text, then its capacity (4 bytes).
};

}  // namespace sml
