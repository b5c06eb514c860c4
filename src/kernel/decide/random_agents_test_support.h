// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::kernel {

/// Generates the rules of random agents, for tests: operators and preferences of all kinds, impasses and results,
/// objects, negations, arithmetic, elaborations that come and go. Uses few symbols, so that many rules match. Equal
/// seeds give equal rules.
class RandomAgents {
 public:
  /// `rootless_percent` is the percentage of rules whose conditions do not begin at a state.
  explicit RandomAgents(std::uint32_t seed, std::uint32_t rootless_percent = 0)
      : random_(seed), rootless_percent_(rootless_percent) {}

  /// The body of a rule (the text between the braces of sp), with a unique name.
  std::string NextRule();
  std::uint32_t Below(std::uint32_t limit) { return random_() % limit; }
  std::string_view Attribute();
  std::string_view Constant();

 private:
  /// What the conditions of the current rule bind, so that its actions can use it.
  struct Scope {
    std::vector<std::string> objects;  ///< States and their parts.
    std::vector<std::string> values;
    std::vector<std::string> operators;  ///< Operators proposed in <s>.
    struct Element {
      std::string id, attribute, value;
    };
    std::vector<Element> elements;  ///< Elements that conditions match, so that actions can reject them.
    bool substate = false;
    bool may_make = true;  ///< No condition matches what rules create. (Else objects could create objects without end.)
  };

  std::string NewVariable(std::string_view kind);
  std::string ValueTest(Scope& scope, bool may_bind, std::string& bound);
  std::string Tests(Scope& scope, const std::string& object, std::uint32_t count);
  std::string RootlessConditions(Scope& scope);
  std::string Conditions(Scope& scope);
  std::string NextAction(Scope& scope);
  std::string Preference(Scope& scope);
  template <typename T>
  const T& Pick(const std::vector<T>& from) {
    return from[Below(static_cast<std::uint32_t>(from.size()))];
  }
  bool Chance(std::uint32_t percent) { return percent != 0 && Below(100) < percent; }

  std::mt19937 random_;
  std::uint32_t rootless_percent_;
  int rules_ = 0;
  int variables_ = 0;
};

}  // namespace soarbox::kernel
