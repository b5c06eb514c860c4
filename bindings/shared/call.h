// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstring>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "life.h"

/// How a wrapper of another language calls the library. It first checks all arguments, then calls the library, then
/// copies the result or stores a reference to it. No other thread can change the objects in the meantime.
namespace soarbox::bindings {

/// Thrown if an argument, or the object of the method, no longer exists. The text is a sentence for users.
class Gone : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An argument of the wrapper that is running. Exists from the conversion of the argument to the end of the wrapper.
class Argument {
 public:
  Argument();
  ~Argument();
  Argument(const Argument&) = delete;
  Argument& operator=(const Argument&) = delete;
  void Set(const Life* life) {
    if (life) life_ = *life;
  }

 private:
  friend class Call;
  std::optional<Life> life_;
  Argument* next_;
};

/// The result of this thread's last call. The wrapper converts it to an object of its language.
struct Returned {
  std::shared_ptr<std::string> text;
  std::optional<Life> life;
};
Returned& LastReturned();

/// One call of the library. `Now` executes it. It throws Gone, or the exception of the call.
class Call {
 public:
  enum class Hold {
    kKernel,   ///< No other thread can call the kernel during the call.
    kNothing,  ///< Other threads can call the kernel. For calls that must not wait for others, or make others wait.
  };

  Call();
  ~Call();
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  /// The kernel that the arguments belong to; null if they belong to none.
  const std::shared_ptr<KernelEntry>& entry() const { return entry_; }
  /// The Life of the first argument; null if it has none.
  const Life* first() const;

  void Now(Hold hold, const std::function<void()>& call);
  /// Whether this call is not nested in another call of this thread.
  bool outermost() const { return outer_ == nullptr; }
  static bool IsInside();
  /// The Life of the first argument of this thread's current call.
  static const Life* Near();

 private:
  void CheckArguments() const;

  std::shared_ptr<KernelEntry> entry_;
  Argument* arguments_;  ///< The first argument of this call; a linked list.
  Argument* border_;     ///< The first argument of the outer call, where this call's list ends.
  Call* outer_;
};

/// Copies the result of a call, or stores its Life in LastReturned. Does nothing for other types.
template <typename T>
void TakeHome(T& result) {
  using Plain = std::remove_cv_t<std::remove_pointer_t<std::remove_cv_t<T>>>;
  if constexpr (std::is_pointer_v<T>) {
    if (!result) return;
    Returned& returned = LastReturned();
    if constexpr (std::is_same_v<Plain, char>) {
      returned.text = std::make_shared<std::string>(result);
      result = returned.text->data();
    } else if constexpr (std::is_base_of_v<sml::WMElement, Plain>) {
      returned.life = Life::Of(static_cast<sml::WMElement*>(result));
    } else if constexpr (std::is_same_v<Plain, sml::Kernel> || std::is_same_v<Plain, sml::Agent>) {
      returned.life = Life::Of(result);
    } else if constexpr (std::is_same_v<Plain, sml::IdentifierSymbol>) {
      returned.life = Life::Of(result, *Call::Near());
    } else if constexpr (std::is_same_v<Plain, sml::ConnectionInfo>) {
      result = new sml::ConnectionInfo(*result);
    }
  }
}

/// A shared pointer to an object that a call returned, or that a handler received.
template <typename T>
std::shared_ptr<T> Share(T* object, Life life) {
  return std::shared_ptr<T>(object, Borrowed{std::move(life)});
}

}  // namespace soarbox::bindings

/// For wrappers without a result: TakeHome(result) then refers to this variable, because no local variable hides it.
[[maybe_unused]] static int result = 0;
