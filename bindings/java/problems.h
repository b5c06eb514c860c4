// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <jni.h>

#include <string>

/// Exceptions in Java.
namespace soarbox::java {

enum class Problem {
  kNull,      ///< NullPointerException
  kArgument,  ///< IllegalArgumentException
  kGone,      ///< IllegalStateException: the library's object is destroyed, or the Java object was deleted
  kMemory,    ///< OutOfMemoryError
  kOther,     ///< RuntimeException
};

/// Sets the exception in Java, unless one is set already. The message is a sentence for people.
void Throw(JNIEnv* env, Problem problem, const std::string& message);
/// The same, for an argument of a function whose name is written as SWIG does ("Agent_RunSelf__SWIG_1").
void ThrowForArgument(JNIEnv* env, Problem problem, std::string function, const std::string& what);
/// Sets the exception in Java for the one that is being handled in C++.
void ThrowCaught(JNIEnv* env);

}  // namespace soarbox::java
