// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <concepts>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>

namespace soarbox::world {

/// An immutable text or list whose copies share memory, on any thread. Converts to the value implicitly.
template <typename T>
class Shared {
 public:
  Shared() = default;
  template <typename From>
  requires(std::constructible_from<T, From> && !std::same_as<std::remove_cvref_t<From>, Shared>) Shared(From&& value) {
    T made(std::forward<From>(value));
    if (!made.empty()) value_ = std::make_shared<const T>(std::move(made));
  }
  Shared(const Shared&) = default;
  Shared(Shared&&) noexcept = default;
  ~Shared() = default;
  Shared& operator=(Shared&&) noexcept = default;
  Shared& operator=(const Shared& other) {
    if (value_ != other.value_) value_ = other.value_;
    return *this;
  }

  const T& value() const {
    static const T kNothing{};
    return value_ ? *value_ : kNothing;
  }
  operator const T&() const { return value(); }
  bool empty() const { return value_ == nullptr; }
  std::size_t size() const { return value().size(); }
  auto begin() const { return value().begin(); }
  auto end() const { return value().end(); }
  const auto& operator[](std::size_t index) const { return value()[index]; }
  /// Whether both share the same memory and are therefore equal.
  bool IsSame(const Shared& other) const { return value_ == other.value_; }

  friend bool operator==(const Shared& a, const Shared& b) { return a.value_ == b.value_ || a.value() == b.value(); }
  template <typename Other>
  requires(!std::same_as<Other, Shared>) friend bool operator==(const Shared& a, const Other& b) {
    return a.value() == b;
  }

 private:
  std::shared_ptr<const T> value_;  ///< Null if empty.
};

}  // namespace soarbox::world
