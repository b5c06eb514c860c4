// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <ranges>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "debugger/facts_text.h"
#include "debugger/json.h"

namespace soarbox::debugger {

/// The JSON form of a struct follows from one list of its fields:
///
///   void Fields(auto& visit, const Check& check) {
///     visit.Type("Check", "A check of the run's mission.");
///     visit("name", check.name, "its name");
///     visit("state", check.state, kStates, "what is known of it");  // An enumeration, and its words in order.
///     visit.Known("was", check.was, "the value found instead");     // Left out if it is empty, false or 0.
///     visit.Is("check");                                            // The field `is`: this word.
///   }
///
/// FieldWriter writes the values. TypeLister lists the fields, for TypeScript and for docs/workbench.md, unless the
/// list has no `Type`: such a type is called JSON there. `Fields` is declared in the namespace of the type or in this
/// one, before its first use. Types with another form have a function `ToJson`, and `ScriptTypeOf(const T*)` if pages
/// read them.

using Words = std::span<const std::string_view>;
/// Whether a request must have a field.
enum Need : bool { kOptional = false, kNeeded = true };

/// The type of a field: in TypeScript, and in words.
struct FieldType {
  std::string script;  ///< "readonly string[]"
  std::string words;   ///< "list of text"; "JSON" for a type whose fields are not listed
};
struct TypeField {
  std::string_view name;
  FieldType type;
  std::string_view about;
  bool is_needed = true;  ///< Otherwise it may be absent.
};
struct TypeInfo {
  std::string_view name, about;
  std::vector<TypeField> fields;
};

/// "`agent`, `operator` or `not`".
inline std::string ChoiceOf(Words words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += "`" + std::string(words[i]) + "`";
  }
  return text;
}

class FieldVisitor {
 public:
  bool has_type = false;

  void Type(std::string_view, std::string_view) { has_type = true; }
  void Is(std::string_view) {}
  void operator()(std::string_view, const auto&...) {}
  void Known(std::string_view, const auto&...) {}
  void If(bool, std::string_view, const auto&...) {}
};
template <typename T>
concept HasFields = requires(FieldVisitor& visit, const T& value) {
  Fields(visit, value);
};
template <typename T>
concept HasScriptType = requires(const T* type) {
  ScriptTypeOf(type);
};
template <typename T>
concept IsText = std::is_convertible_v<T, std::string_view>;

template <typename T>
struct WithoutOptional {
  using Type = T;
  static constexpr bool kIsOptional = false;
};
template <typename T>
struct WithoutOptional<std::optional<T>> {
  using Type = T;
  static constexpr bool kIsOptional = true;
};
template <typename T>
inline constexpr bool kIsOptional = WithoutOptional<T>::kIsOptional;
template <typename T>
inline constexpr bool kIsPair = false;
template <typename A, typename B>
inline constexpr bool kIsPair<std::pair<A, B>> = true;
template <typename T>
inline constexpr std::size_t kArraySize = 0;
template <typename T, std::size_t size>
inline constexpr std::size_t kArraySize<std::array<T, size>> = size;

template <typename T>
inline constexpr bool kIsListOfFields = false;
template <std::ranges::range T>
inline constexpr bool kIsListOfFields<T> = HasFields<std::ranges::range_value_t<T>>;

template <typename T>
Json JsonOf(const T& value);

/// Writes the fields of a value into an object.
class FieldWriter {
 public:
  explicit FieldWriter(Json& json) : json_(json) {}

  void Type(std::string_view, std::string_view) {}
  void Is(std::string_view word) { json_["is"] = std::string(word); }
  template <typename T>
  void operator()(std::string_view name, const T& value, std::string_view = {}, Need = kNeeded) {
    json_[std::string(name)] = JsonOf(value);
  }
  template <typename Enum>
  void operator()(std::string_view name, const Enum& value, Words words, std::string_view, Need = kNeeded) {
    json_[std::string(name)] = std::string(words[static_cast<std::size_t>(value)]);
  }
  template <typename T>
  void If(bool is_known, std::string_view name, const T& value, std::string_view = {}) {
    if (is_known) (*this)(name, value);
  }
  template <typename T>
  void Known(std::string_view name, const T& value, std::string_view = {}) {
    if constexpr (std::is_arithmetic_v<T>) {
      If(value != T{}, name, value);
    } else if constexpr (kIsOptional<T>) {
      If(value.has_value(), name, value);
    } else {
      If(!value.empty(), name, value);
    }
  }

 private:
  Json& json_;
};

template <typename T>
Json JsonOf(const T& value) {
  if constexpr (HasFields<T>) {
    Json json = Json::object();
    FieldWriter writer(json);
    Fields(writer, value);
    return json;
  } else if constexpr (HasScriptType<T>) {
    return ToJson(value);
  } else if constexpr (std::is_same_v<T, Json>) {
    return value;
  } else if constexpr (kIsOptional<T>) {
    return value ? JsonOf(*value) : Json();
  } else if constexpr (std::is_arithmetic_v<T>) {
    return value;
  } else if constexpr (std::is_same_v<T, std::filesystem::path>) {
    return value.string();
  } else if constexpr (IsText<T>) {
    return std::string(value);
  } else if constexpr (std::is_pointer_v<T>) {
    return JsonOf(*value);
  } else if constexpr (kIsPair<T>) {
    return Json::array({JsonOf(value.first), JsonOf(value.second)});
  } else if constexpr (requires { typename T::mapped_type; }) {
    Json json = Json::object();
    for (const auto& [key, each] : value) {
      if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(key)>>) {
        json[std::to_string(key)] = JsonOf(each);
      } else {
        json[key] = JsonOf(each);
      }
    }
    return json;
  } else if constexpr (!kIsListOfFields<T> && requires { ToJson(value); }) {
    return ToJson(value);
  } else {
    Json json = Json::array();
    for (const auto& each : value) json.push_back(JsonOf(each));
    return json;
  }
}

/// Lists types with the types of their fields, each once.
class TypeLister {
 public:
  /// In the order of their first use.
  const std::deque<TypeInfo>& types() const { return types_; }

  /// The type of a value. Adds it to the list if it has fields.
  template <typename T>
  FieldType TypeOf() {
    if constexpr (std::is_pointer_v<T> && !IsText<T>) {
      return TypeOf<std::remove_cv_t<std::remove_pointer_t<T>>>();
    } else if constexpr (HasFields<T>) {
      FieldVisitor visit;
      Fields(visit, T{});
      if (!visit.has_type) return {"unknown", "JSON"};
      const auto [at, is_new] = known_.try_emplace(&kKey<T>, nullptr);
      if (is_new) {
        TypeInfo& info = *(at->second = &types_.emplace_back());
        Visitor visitor(*this, info);
        Fields(visitor, T{});
      }
      const std::string name(known_.at(&kKey<T>)->name);
      return {name, "`" + name + "`"};
    } else if constexpr (HasScriptType<T>) {
      return ScriptTypeOf(static_cast<const T*>(nullptr));
    } else if constexpr (std::is_same_v<T, Json>) {
      return {"unknown", "JSON"};
    } else if constexpr (kIsOptional<T>) {
      const FieldType type = TypeOf<typename WithoutOptional<T>::Type>();
      return {type.script + " | null", type.words + " or null"};
    } else if constexpr (std::is_same_v<T, bool>) {
      return {"boolean", "true or false"};
    } else if constexpr (std::is_arithmetic_v<T>) {
      return {"number", "number"};
    } else if constexpr (std::is_same_v<T, std::filesystem::path> || IsText<T>) {
      return {"string", "text"};
    } else if constexpr (kIsPair<T>) {
      const FieldType first = TypeOf<typename T::first_type>(), second = TypeOf<typename T::second_type>();
      return {"readonly [" + first.script + ", " + second.script + "]",
              "pair of " + first.words + " and " + second.words};
    } else if constexpr (requires { typename T::mapped_type; }) {
      const FieldType type = TypeOf<typename T::mapped_type>();
      return {"Readonly<Record<string, " + type.script + ">>", "object of " + type.words};
    } else if constexpr (!kIsListOfFields<T> && requires(const T& value) { ToJson(value); }) {
      return {"unknown", "JSON"};
    } else if constexpr (kArraySize<T> > 0) {
      const FieldType type = TypeOf<typename T::value_type>();
      std::string script = type.script;
      for (std::size_t i = 1; i < kArraySize<T>; ++i) script += ", " + type.script;
      return {"readonly [" + script + "]", "list of " + type.words};
    } else {
      const FieldType type = TypeOf<std::ranges::range_value_t<T>>();
      const bool is_long = type.script.find(' ') != std::string::npos;
      return {"readonly " + (is_long ? "(" + type.script + ")" : type.script) + "[]", "list of " + type.words};
    }
  }

  /// The fields of a type that is not in the list, such as a request.
  template <typename T>
  std::vector<TypeField> FieldsOf() {
    TypeInfo info;
    Visitor visitor(*this, info);
    T value{};
    Fields(visitor, value);
    return std::move(info.fields);
  }

 private:
  /// Adds the fields that a list of fields names.
  class Visitor {
   public:
    Visitor(TypeLister& lister, TypeInfo& info) : lister_(lister), info_(info) {}

    void Type(std::string_view name, std::string_view about) {
      info_.name = name;
      info_.about = about;
    }
    void Is(std::string_view word) { (*this)("is", 0, Words(&word, 1), "what it is"); }
    template <typename T>
    void operator()(std::string_view name, const T&, std::string_view about = {}, Need need = kNeeded) {
      info_.fields.push_back({name, lister_.TypeOf<T>(), about, need});
    }
    template <typename Enum>
    void operator()(std::string_view name, const Enum&, Words words, std::string_view about, Need need = kNeeded) {
      std::string script;
      for (const std::string_view word : words) script += (script.empty() ? "\"" : " | \"") + std::string(word) + "\"";
      info_.fields.push_back({name, {script, ChoiceOf(words)}, about, need});
    }
    template <typename T>
    void If(bool, std::string_view name, const T&, std::string_view about = {}) {
      info_.fields.push_back({name, lister_.TypeOf<typename WithoutOptional<T>::Type>(), about, false});
    }
    template <typename T>
    void Known(std::string_view name, const T& value, std::string_view about = {}) {
      If(false, name, value, about);
    }

   private:
    TypeLister& lister_;
    TypeInfo& info_;
  };

  template <typename T>
  static constexpr char kKey = 0;

  std::deque<TypeInfo> types_;
  std::map<const void*, TypeInfo*> known_;
};

}  // namespace soarbox::debugger
