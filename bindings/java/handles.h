// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <jni.h>

#include <memory>
#include <optional>
#include <type_traits>
#include <variant>

#include "call.h"
#include "problems.h"

/// Maps Java objects to objects of the library. Java objects contain numbers, not pointers. A number that was released,
/// or never issued, is always detected, on any thread. Numbers are never reused.
namespace soarbox::java {

/// One object of the library.
struct Slot {
  std::variant<std::monostate, sml::Kernel*, sml::Agent*, sml::StringElement*, sml::IntElement*, sml::FloatElement*,
               sml::Identifier*, sml::WMElement*, sml::IdentifierSymbol*, sml::ClientTraceXML*, sml::ClientXML*,
               sml::ClientAnalyzedXML*, soarxml::ElementXML*, sml::Events*, sml::ConnectionInfo*, sml::sml_Names*>
      object;
  std::optional<bindings::Life> life;  ///< Of an object that a kernel owns.
  std::shared_ptr<void> own;           ///< An object that Java owns.
};

/// The class of an element; stored in the lowest bits of its number.
enum ElementKind : jlong { kOtherKind = 0, kStringKind = 1, kIntKind = 2, kFloatKind = 3, kIdentifierKind = 4 };

jlong Add(Slot slot, ElementKind kind = kOtherKind);
/// False if there is no such object.
bool Find(jlong number, Slot& slot);
/// Releases a number that Java no longer needs. The object remains valid for other threads that are using it.
void Release(jlong number);

/// Return the number of an object that the library returned, or that a handler received; 0 for null.
jlong Give(sml::Kernel* kernel, bindings::Life life);
jlong Give(sml::Agent* agent, bindings::Life life);
jlong Give(sml::WMElement* element, bindings::Life life);
jlong Give(sml::IdentifierSymbol* symbol, bindings::Life life);
/// The same for a kernel that Java owns.
jlong GiveOwned(sml::Kernel* kernel, bindings::Life life);

/// The number of the object that this thread's last call returned.
jlong& LastGiven();

/// Sets LastGiven, if the call returned an object. Call it while no other thread can change the object.
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

/// An object that a wrapper received as an argument. It is kept alive until the wrapper ends.
template <typename T>
class Reached {
 public:
  /// Returns the object. Returns null and sets an exception in Java for null, a deleted object, or another class.
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
