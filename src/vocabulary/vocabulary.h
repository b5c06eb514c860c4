// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::vocabulary {

// What Soar agents perceive and which commands they can give, as data. These tables are the source of the input link,
// the checks of the output link, docs/percepts.md and docs/commands.md, `soarbox check` and the gap reports.

enum class ValueType : std::uint8_t {
  kNumber,   ///< A float; integers are accepted, too.
  kInteger,  ///< An integer.
  kWord,     ///< A constant; one of `words` if there are any.
  kObject,   ///< An identifier with attributes.
};

/// Number of steps per unit; 0 if that is not an integer.
constexpr double WholeStepsPerUnit(double step) {
  if (step <= 0) return 0;
  const double steps = 1 / step, whole = static_cast<double>(static_cast<long long>(steps + 0.5));
  const double error = steps - whole;
  return whole > 0 && error < 1e-9 && error > -1e-9 ? whole : 0;
}

/// A percept: an attribute below ^io.input-link.
struct PerceptRow {
  std::string_view path;   ///< Path with dots from the input link: "self.position.x".
  std::string_view sense;  ///< The sense that writes it; authors switch senses on and off by this name.
  ValueType type = ValueType::kNumber;
  std::string_view unit = {};   ///< "m", "m/s", "deg", "s"; empty if it has none.
  double min = 0, max = 0;      ///< For numbers only; both 0: no limits.
  double step = 0;              ///< Numbers are rounded to multiples of this, so that smaller noise causes no change.
  std::string_view words = {};  ///< For words only: the possible words, separated by blanks; empty: any.
  std::string_view meaning = {};
  double steps_per_unit = WholeStepsPerUnit(step);

  constexpr std::string_view Attribute() const {
    const std::size_t dot = path.rfind('.');
    return dot == std::string_view::npos ? path : path.substr(dot + 1);
  }
};

/// A parameter of a command: an attribute below the command's identifier.
struct ParameterRow {
  std::string_view name;
  ValueType type = ValueType::kNumber;
  std::string_view unit = {};
  double min = 0, max = 0;  ///< For numbers only; both 0: no limits.
  bool required = false;
  std::string_view words = {};  ///< For words only: the possible words.
  std::string_view meaning = {};
};

/// The part of a body that a command uses. A new command for legs, head or hands interrupts the one for the same part.
enum class BodyPart : std::uint8_t { kLegs, kHead, kHands, kVoice, kPosture, kNone };

enum class TakesPlace : std::uint8_t {
  kNo,
  kOptional,
  kRequired,  ///< One of the parameters in PlaceParameters().
};

/// A command: an attribute directly on the output link, with an identifier as its value.
struct CommandRow {
  std::string_view name;
  BodyPart part = BodyPart::kNone;
  bool lasting = false;  ///< Takes longer than one tick; reports ^progress.
  TakesPlace place = TakesPlace::kNo;
  std::string_view meaning;
  std::vector<ParameterRow> parameters;
  std::string_view ends;     ///< When it is complete, as text.
  std::string_view reasons;  ///< Values of ^reason, in addition to those of the checks, separated by blanks.
};

/// A possible value of ^reason.
struct ReasonRow {
  std::string_view name;
  std::string_view meaning;
};

/// A sense, which authors can turn on and off.
struct SenseRow {
  std::string_view name;
  std::string_view meaning;
};

std::span<const PerceptRow> Percepts();
std::span<const CommandRow> Commands();
std::span<const ReasonRow> Reasons();
std::span<const SenseRow> Senses();
/// The parameters that specify a place: ^x and ^z, ^waypoint, ^region, ^agent, ^object.
std::span<const ParameterRow> PlaceParameters();

/// Null if the name does not exist.
const CommandRow* FindCommand(std::string_view name);
const SenseRow* FindSense(std::string_view name);
const ReasonRow* FindReason(std::string_view name);
/// The most similar command or percept attribute for a misspelt word; empty if none is similar.
std::string_view NearestCommand(std::string_view word);
std::string_view NearestAttribute(std::string_view word, std::span<const std::string> more = {});
/// Whether any percept has this attribute.
bool IsPerceptAttribute(std::string_view attribute);

std::string_view NameOf(BodyPart part);
std::string_view NameOf(ValueType type);
/// "m, 0 to 100", "one of: a b c"; empty if there is no restriction.
std::string DescribeRange(std::string_view unit, double min, double max, std::string_view words);
/// Whether a list of words, separated by blanks, contains a word.
bool HoldsWord(std::string_view list, std::string_view word);

/// Generates docs/percepts.md and docs/commands.md.
std::string PerceptReference();
std::string CommandReference();

}  // namespace soarbox::vocabulary
