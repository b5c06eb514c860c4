// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstring>

namespace sml {

/// A text that belongs to one object, in sixteen bytes: up to fifteen characters stand in them, longer ones elsewhere.
/// Part of the library's own data; not part of the interface of Soar 9.6.3.
class ElementText {
 public:
  ElementText() { bytes_[0] = bytes_[kMark] = 0; }
  ~ElementText() { Release(); }
  ElementText(ElementText const&) = delete;
  ElementText& operator=(ElementText const&) = delete;

  /// Ends with a zero. Valid until the next change.
  char const* c_str() const { return IsLong() ? LongText() : bytes_; }
  bool empty() const { return *c_str() == 0; }
  /// Takes over what is not longer than before without allocating.
  void Assign(char const* text, std::size_t size);

 private:
  static const std::size_t kMark = 15;  ///< Where a short text of full length ends, and what tells long ones.

  bool IsLong() const { return bytes_[kMark] != 0; }
  char* LongText() const {
    char* text;
    std::memcpy(&text, bytes_, sizeof text);
    return text;
  }
  void Release() {
    if (IsLong()) delete[] LongText();
  }

  alignas(char*) char bytes_[kMark + 1];  ///< Long: the place of the text, then the room there (4 bytes).
};

}  // namespace sml
