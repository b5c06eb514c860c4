// SPDX-License-Identifier: BSD-2-Clause
#include "problems.h"

#include <algorithm>
#include <new>
#include <stdexcept>

#include "call.h"
#include "text.h"

namespace soarbox::java {

namespace {

const char* ClassOf(Problem problem) {
  switch (problem) {
    case Problem::kNull:
      return "java/lang/NullPointerException";
    case Problem::kArgument:
      return "java/lang/IllegalArgumentException";
    case Problem::kGone:
      return "java/lang/IllegalStateException";
    case Problem::kMemory:
      return "java/lang/OutOfMemoryError";
    case Problem::kOther:
      break;
  }
  return "java/lang/RuntimeException";
}

}  // namespace

void Throw(JNIEnv* env, Problem problem, const std::string& message) {
  if (env->ExceptionCheck()) return;
  jclass type = env->FindClass(ClassOf(problem));
  if (!type) return;
  jmethodID constructor = env->GetMethodID(type, "<init>", "(Ljava/lang/String;)V");
  jstring text = constructor ? NewText(env, message) : nullptr;
  jobject exception = text ? env->NewObject(type, constructor, text) : nullptr;
  if (exception) env->Throw(static_cast<jthrowable>(exception));
}

void ThrowForArgument(JNIEnv* env, Problem problem, std::string function, const std::string& what) {
  function.resize(std::min(function.find("__SWIG_"), function.size()));
  const std::size_t border = function.find('_');
  if (border != std::string::npos) function[border] = '.';
  Throw(env, problem, function + ": " + what);
}

void ThrowCaught(JNIEnv* env) {
  try {
    throw;
  } catch (const bindings::Gone& gone) {
    Throw(env, Problem::kGone, gone.what());
  } catch (const std::invalid_argument& wrong) {
    Throw(env, Problem::kArgument, wrong.what());
  } catch (const std::bad_alloc&) {
    Throw(env, Problem::kMemory, "The library has no memory left.");
  } catch (const std::exception& failure) {
    Throw(env, Problem::kOther, failure.what());
  }
}

}  // namespace soarbox::java
