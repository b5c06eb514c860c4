// SPDX-License-Identifier: BSD-2-Clause
#include "vocabulary/command_check.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "diagnostics/diagnostic.h"

namespace soarbox::vocabulary {
namespace {

/// Attributes that the world adds below a command.
constexpr std::string_view kAnswers = "status reason parameter progress";

const ParameterRow* FindParameter(const CommandRow& row, std::string_view name) {
  const auto by_name = [&](const ParameterRow& parameter) { return parameter.name == name; };
  const auto at = std::find_if(row.parameters.begin(), row.parameters.end(), by_name);
  if (at != row.parameters.end()) return &*at;
  if (row.place == TakesPlace::kNo) return nullptr;
  const auto places = PlaceParameters();
  const auto place = std::find_if(places.begin(), places.end(), by_name);
  return place == places.end() ? nullptr : &*place;
}

bool IsGood(const ParameterRow& row, const Percept& value) {
  if (row.type == ValueType::kWord) {
    if (value.IsObject()) return false;
    return row.words.empty() || (value.Text() != nullptr && HoldsWord(row.words, *value.Text()));
  }
  const auto number = value.Number();
  if (!number || !std::isfinite(*number)) return false;
  if (row.type == ValueType::kInteger && !std::holds_alternative<std::int64_t>(value.value)) return false;
  return row.min == row.max || (*number >= row.min && *number <= row.max);
}

/// Another value of the same parameter.
const Percept* OtherValue(const std::vector<Percept>& parameters, const Percept& given) {
  for (const Percept& each : parameters)
    if (&each != &given && each.attribute == given.attribute) return &each;
  return nullptr;
}

std::string UnknownParameter(const CommandRow& row, const std::string& name) {
  std::vector<std::string_view> names;
  for (const ParameterRow& parameter : row.parameters) names.push_back(parameter.name);
  if (row.place != TakesPlace::kNo)
    for (const ParameterRow& parameter : PlaceParameters()) names.push_back(parameter.name);
  std::string text = std::string(row.name) + " has no parameter ^" + name;
  if (const std::string_view near = Suggest(name, names); !near.empty())
    return text + ": did you mean ^" + std::string(near) + "?";
  if (names.empty()) return text + ": it takes none";
  text += ": it takes";
  for (const std::string_view known : names) text += " ^" + std::string(known);
  return text;
}

/// A fault with a text about some values of the command.
template <typename TextOf>
CommandFault BadValue(const std::string& parameter, std::initializer_list<const Percept*> values, TextOf&& text_of) {
  const auto brief = [](const Percept& value) {
    return value.IsObject() ? std::string("an object, not its name") : DescribeValue(value);
  };
  CommandFault fault{"bad-value", parameter, text_of(DescribeValue)};
  if (std::ranges::any_of(values, [](const Percept* value) { return value->IsObject(); })) fault.brief = text_of(brief);
  return fault;
}

}  // namespace

bool IsFaultOfForm(std::string_view reason) {
  return reason == "bad-value" || reason == "unknown-parameter" || reason == "missing-parameter" ||
         reason == "unknown-command";
}

CommandFault CheckCommand(const SaidCommand& command) {
  const CommandRow* row = FindCommand(command.name);
  if (row == nullptr) {
    std::string text = "there is no command ^" + command.name;
    if (const std::string_view near = NearestCommand(command.name); !near.empty())
      text += ": did you mean ^" + std::string(near) + "?";
    return {"unknown-command", {}, text};
  }
  if (!command.is_object) {
    return {"bad-value",
            {},
            "^" + command.name + " has a constant as its value: make it an identifier, (<out> ^" + command.name +
                " <command>), with the parameters below it"};
  }
  if (command.is_too_large) {
    return {"too-large",
            {},
            "there is too much below ^" + command.name +
                ": up to 1000 elements of a command are read, and circular links count each time"};
  }
  // Additional parameters of say and broadcast are sent with the message.
  const bool is_message = row->part == BodyPart::kVoice;
  bool has_place = false;
  for (const Percept& given : command.parameters) {
    if (HoldsWord(kAnswers, given.attribute)) continue;
    const ParameterRow* parameter = FindParameter(*row, given.attribute);
    if (parameter == nullptr) {
      if (is_message) continue;
      return {"unknown-parameter", given.attribute, UnknownParameter(*row, given.attribute)};
    }
    if (const Percept* other = OtherValue(command.parameters, given); other != nullptr) {
      return BadValue(given.attribute, {&given, other}, [&](auto&& described) {
        return "^" + given.attribute + " of " + command.name + " has two values, " + described(given) + " and " +
               described(*other) + ": it takes one; a sum is (+ 1 2), and ^name <n> - removes the old value";
      });
    }
    if (!IsGood(*parameter, given)) {
      const std::string range = DescribeRange(parameter->unit, parameter->min, parameter->max, parameter->words);
      return BadValue(given.attribute, {&given}, [&](auto&& described) {
        return "^" + given.attribute + " of " + command.name + " is " + described(given) + ": it takes a " +
               std::string(NameOf(parameter->type)) + (range.empty() ? "" : " (" + range + ")");
      });
    }
    for (const ParameterRow& place : PlaceParameters()) has_place |= &place == parameter;
  }
  for (const ParameterRow& parameter : row->parameters) {
    if (parameter.required && FindPercept(command.parameters, parameter.name) == nullptr) {
      return {"missing-parameter", std::string(parameter.name),
              command.name + " needs ^" + std::string(parameter.name) + ": " + std::string(parameter.meaning)};
    }
  }
  const bool has_x = FindPercept(command.parameters, "x") != nullptr;
  const bool has_z = FindPercept(command.parameters, "z") != nullptr;
  if (row->place != TakesPlace::kNo && has_x != has_z) {
    const char* missing = has_x ? "z" : "x";
    return {"missing-parameter", missing, command.name + " requires ^x and ^z together; ^" + missing + " is not there"};
  }
  if (row->place == TakesPlace::kRequired && !has_place) {
    return {"no-place", {}, command.name + " requires a place: ^x and ^z, ^waypoint, ^region, ^agent or ^object"};
  }
  return {};
}

}  // namespace soarbox::vocabulary
