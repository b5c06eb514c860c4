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

/// Sets an exception in Java, unless one is already set. The message is a sentence for users.
void Throw(JNIEnv* env, Problem problem, const std::string& message);
/// The same, for an argument of a function. `function` is its name as SWIG writes it ("Agent_RunSelf__SWIG_1").
void ThrowForArgument(JNIEnv* env, Problem problem, std::string function, const std::string& what);
/// Sets an exception in Java for the C++ exception that is being handled.
void ThrowCaught(JNIEnv* env);

}  // namespace soarbox::java
