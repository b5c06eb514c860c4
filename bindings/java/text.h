// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <jni.h>

#include <string>
#include <string_view>

/// Converts texts between the library (UTF-8) and Java (UTF-16). A byte that is not valid UTF-8 becomes an unpaired
/// surrogate, U+DC80 to U+DCFF, in Java, and the same byte again in the library.
namespace soarbox::java {

/// Creates a Java string. Returns null and sets an exception in Java if there is not enough memory.
jstring NewText(JNIEnv* env, std::string_view text);
/// The same. Returns null for null.
jstring NewText(JNIEnv* env, const char* text);

/// Converts a Java string to UTF-8. Other unpaired surrogates become U+FFFD.
std::string TextOf(JNIEnv* env, jstring text);

/// A text that a wrapper received as an argument.
class Text {
 public:
  enum class Null { kForbidden, kAllowed };

  /// Returns false and sets an exception in Java if the text is null and must not be, or if it contains a zero byte.
  bool Take(JNIEnv* env, jstring text, const char* method, Null null = Null::kForbidden);
  /// Null if the Java string was null.
  char* c_str() { return is_null_ ? nullptr : text_.data(); }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
  bool is_null_ = false;
};

}  // namespace soarbox::java
