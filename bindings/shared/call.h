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

/// How a wrapper of the other language calls the library: all arguments are looked at first, while nobody else may
/// change them, and what the library returns is taken home before anybody else may change that.
namespace soarbox::bindings {

/// An argument, or the object itself, is gone. The text is a sentence for people.
class Gone : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An argument of the wrapper that runs just now, from its conversion to the wrapper's end.
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

/// What the last call of this thread returned, for the wrapper to make an object of.
struct Returned {
  std::shared_ptr<std::string> text;
  std::optional<Life> life;
};
Returned& LastReturned();

/// One call. `Now` throws Gone, or what the call threw.
class Call {
 public:
  enum class Hold {
    kKernel,   ///< Nobody else calls the kernel meanwhile.
    kNothing,  ///< Others may: a call that must not wait for them, or that they must not wait for.
  };

  Call();
  ~Call();
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  /// The kernel that the arguments belong to; null if they belong to none.
  const std::shared_ptr<KernelEntry>& entry() const { return entry_; }
  /// The first argument's life; null if it has none.
  const Life* first() const;

  void Now(Hold hold, const std::function<void()>& call);
  /// True if this thread is in no other call.
  bool outermost() const { return outer_ == nullptr; }
  static bool IsInside();
  /// The first argument's life of the call that this thread is in.
  static const Life* Near();

 private:
  void CheckArguments() const;

  std::shared_ptr<KernelEntry> entry_;
  Argument* arguments_;  ///< The first of this call's.
  Argument* border_;     ///< The first that belongs to an outer call.
  Call* outer_;
};

/// Takes home what a call returned: `result` of a wrapper that has one.
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

/// The shared pointer for what the last call returned, or a handler was given.
template <typename T>
std::shared_ptr<T> Share(T* object, Life life) {
  return std::shared_ptr<T>(object, Borrowed{std::move(life)});
}

}  // namespace soarbox::bindings

/// Replaces `result` in wrappers without a result: TakeHome(result) refers to it unless a local variable hides it.
[[maybe_unused]] static int result = 0;
