// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <jni.h>

#include <string>
#include <string_view>

/// Texts between the library (UTF-8) and Java (UTF-16). Bytes that are not UTF-8 survive the way to Java and back:
/// there they are surrogates U+DC80 to U+DCFF that stand alone.
namespace soarbox::java {

/// A new text of Java; null with an exception in Java if there is no memory.
jstring NewText(JNIEnv* env, std::string_view text);
/// The same; null for null.
jstring NewText(JNIEnv* env, const char* text);

/// UTF-8; surrogates without a meaning become U+FFFD.
std::string TextOf(JNIEnv* env, jstring text);

/// A text that a wrapper was given.
class Text {
 public:
  enum class Null { kForbidden, kAllowed };

  /// False with an exception in Java if the text is null and must not be, or if the library could not see its end.
  bool Take(JNIEnv* env, jstring text, const char* method, Null null = Null::kForbidden);
  /// Null if Java gave null.
  char* c_str() { return is_null_ ? nullptr : text_.data(); }
  const std::string& str() const { return text_; }

 private:
  std::string text_;
  bool is_null_ = false;
};

}  // namespace soarbox::java
