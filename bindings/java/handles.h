// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <jni.h>

#include <memory>
#include <optional>
#include <type_traits>
#include <variant>

#include "call.h"
#include "problems.h"

/// The library's objects behind Java objects. Java objects hold numbers, not pointers. A number that was released, or
/// never issued, is always detected, on any thread. Numbers are not used again.
namespace soarbox::java {

/// One object of the library.
struct Slot {
  std::variant<std::monostate, sml::Kernel*, sml::Agent*, sml::StringElement*, sml::IntElement*, sml::FloatElement*,
               sml::Identifier*, sml::WMElement*, sml::IdentifierSymbol*, sml::ClientTraceXML*, sml::ClientXML*,
               sml::ClientAnalyzedXML*, soarxml::ElementXML*, sml::Events*, sml::ConnectionInfo*, sml::sml_Names*>
      object;
  std::optional<bindings::Life> life;  ///< Of what a kernel owns.
  std::shared_ptr<void> own;           ///< Of what Java owns.
};

/// The lowest bits of a number say of which class an element is.
enum ElementKind : jlong { kOtherKind = 0, kStringKind = 1, kIntKind = 2, kFloatKind = 3, kIdentifierKind = 4 };

jlong Add(Slot slot, ElementKind kind = kOtherKind);
/// False if there is no such object.
bool Find(jlong number, Slot& slot);
/// Java needs the object no more. Other threads that are using it do not notice.
void Release(jlong number);

/// Numbers for what the library returned, or a handler was given; 0 for null.
jlong Give(sml::Kernel* kernel, bindings::Life life);
jlong Give(sml::Agent* agent, bindings::Life life);
jlong Give(sml::WMElement* element, bindings::Life life);
jlong Give(sml::IdentifierSymbol* symbol, bindings::Life life);
/// A kernel that Java owns.
jlong GiveOwned(sml::Kernel* kernel, bindings::Life life);

/// The number for what the last call of this thread returned.
jlong& LastGiven();

/// Makes that number, if the call returned an object; called where nobody else may change the object.
template <typename T>
void GiveReturned(T& result) {
  if constexpr (std::is_pointer_v<T>) {
    using Plain = std::remove_cv_t<std::remove_pointer_t<T>>;
    auto* object = const_cast<Plain*>(result);
    if constexpr (std::is_base_of_v<sml::WMElement, Plain> || std::is_same_v<Plain, sml::Kernel> ||
                  std::is_same_v<Plain, sml::Agent> || std::is_same_v<Plain, sml::IdentifierSymbol>) {
      LastGiven() = object ? Give(object, *bindings::LastReturned().life) : 0;
    } else if constexpr (std::is_class_v<Plain>) {
      LastGiven() = object ? Add({object, {}, std::shared_ptr<Plain>(object)}) : 0;
    }
  }
}

/// An object that a wrapper was given, kept until the wrapper ends.
template <typename T>
class Reached {
 public:
  /// Null with an exception in Java if Java gave null, an object that was deleted, or one of another class.
  T* At(JNIEnv* env, jlong number, const char* method) {
    if (number == 0) {
      ThrowForArgument(env, Problem::kNull, method, "an argument is null");
      return nullptr;
    }
    if (!Find(number, slot_)) {
      ThrowForArgument(env, Problem::kGone, method, "an object was deleted with delete()");
      return nullptr;
    }
    T* object = std::visit(
        [](auto held) -> T* {
          if constexpr (std::is_convertible_v<decltype(held), T*>) return held;
          return nullptr;
        },
        slot_.object);
    if (!object) ThrowForArgument(env, Problem::kArgument, method, "an argument is of another class");
    if (slot_.life) argument_.Set(&*slot_.life);
    return object;
  }

 private:
  Slot slot_;
  bindings::Argument argument_;
};

}  // namespace soarbox::java
