// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_expression.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <iterator>
#include <lua.hpp>
#include <optional>

#include "diagnostics/number_from_chars.h"
#include "script/lua_text.h"

namespace soarbox::script {
namespace {

constexpr int kDeepestExpression = 60;  ///< Maximum nesting of brackets and operators.

struct Operator {
  std::string_view text;
  int left, right;  ///< Binding strength to each side.
  const char* metamethod = nullptr;
};
constexpr Operator kOperators[] = {
    {"or", 1, 1},         {"and", 2, 2},        {"==", 3, 3},
    {"~=", 3, 3},         {"<=", 3, 3},         {">=", 3, 3},
    {"<", 3, 3},          {">", 3, 3},          {"..", 5, 4, "__concat"},
    {"+", 6, 6, "__add"}, {"-", 6, 6, "__sub"}, {"*", 7, 7, "__mul"},
    {"/", 7, 7, "__div"}, {"%", 7, 7, "__mod"}, {"^", 10, 9, "__pow"},
};
constexpr int kUnary = 8;

/// Parses the expression from left to right and evaluates it; the values are on the state's stack.
class Reader {
 public:
  Reader(lua_State* state, std::string_view text, const PushVariable& variable, MayCall may_call)
      : state_(state), text_(text), variable_(variable), may_call_(may_call) {}

  void ReadAll() {
    Read(0);
    SkipSpace();
    if (at_ < text_.size()) Fail("what is written after the expression: " + std::string(text_.substr(at_, 20)));
  }

 private:
  [[noreturn]] void Fail(const std::string& what) {
    lua_pushlstring(state_, what.data(), what.size());
    lua_error(state_);
    __builtin_unreachable();
  }

  void SkipSpace() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }

  bool Accept(std::string_view sign) {
    SkipSpace();
    if (!text_.substr(at_).starts_with(sign)) return false;
    at_ += sign.size();
    return true;
  }

  void Expect(std::string_view sign) {
    if (!Accept(sign)) Fail("the expression lacks " + std::string(sign));
  }

  static bool IsNameSign(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

  std::string_view PeekName() {
    SkipSpace();
    std::size_t end = at_;
    if (end < text_.size() && std::isdigit(static_cast<unsigned char>(text_[end])) != 0) return {};
    while (end < text_.size() && IsNameSign(text_[end])) ++end;
    return text_.substr(at_, end - at_);
  }

  std::string ReadName() {
    const std::string name(PeekName());
    if (name.empty()) Fail("a name is missing");
    at_ += name.size();
    return name;
  }

  const Operator* PeekOperator() {
    SkipSpace();
    const std::string_view word = PeekName();
    for (const Operator& one : kOperators) {
      const bool is_word = std::isalpha(static_cast<unsigned char>(one.text[0])) != 0;
      if (is_word ? word == one.text : text_.substr(at_).starts_with(one.text)) return &one;
    }
    return nullptr;
  }

  /// Pushes the value of an expression whose operators bind more strongly than `limit`.
  void Read(int limit) {
    if (++depth_ > kDeepestExpression) Fail("the expression is too deep");
    luaL_checkstack(state_, 10, "the expression is too long");
    ReadUnary();
    while (const Operator* found = PeekOperator()) {
      if (found->left <= limit) break;
      at_ += found->text.size();
      const bool skips = (found->text == "and" && lua_toboolean(state_, -1) == 0) ||
                         (found->text == "or" && lua_toboolean(state_, -1) != 0);
      const bool was_dry = dry_;
      dry_ = dry_ || skips;
      Read(found->right);
      dry_ = was_dry;
      if (found->text == "and" || found->text == "or") {
        if (skips) {
          lua_pop(state_, 1);
        } else {
          lua_remove(state_, -2);
        }
      } else {
        Compute(*found);
      }
    }
    --depth_;
  }

  void ReadUnary() {
    if (PeekName() == "not") {
      at_ += 3;
      Read(kUnary);
      const bool value = lua_toboolean(state_, -1) == 0;
      lua_pop(state_, 1);
      lua_pushboolean(state_, value);
    } else if (Accept("#")) {
      Read(kUnary);
      if (dry_) return;
      const int type = lua_type(state_, -1);
      if (type != LUA_TSTRING && type != LUA_TTABLE)
        Fail(std::string("a ") + luaL_typename(state_, -1) + " value has no length");
      const auto length = static_cast<lua_Number>(lua_objlen(state_, -1));
      lua_pop(state_, 1);
      lua_pushnumber(state_, length);
    } else if (Accept("-")) {
      Read(kUnary);
      if (dry_) return;
      lua_pushvalue(state_, -1);
      if (lua_isnumber(state_, -1)) {
        lua_pushnumber(state_, -lua_tonumber(state_, -1));
        lua_insert(state_, -3);
        lua_pop(state_, 2);
      } else {
        CallMetamethod("__unm", "-");
      }
    } else {
      ReadSuffixed();
    }
  }

  void ReadSuffixed() {
    ReadPrimary();
    while (true) {
      SkipSpace();
      if (at_ >= text_.size()) return;
      if (text_[at_] == '.' && !text_.substr(at_).starts_with("..")) {
        ++at_;
        const std::string name = ReadName();
        lua_pushlstring(state_, name.data(), name.size());
        Index(name);
      } else if (text_[at_] == '[') {
        ++at_;
        Read(0);
        Expect("]");
        Index("that place");
      } else if (text_[at_] == ':') {
        ++at_;
        const std::string name = ReadName();
        lua_pushvalue(state_, -1);
        lua_pushlstring(state_, name.data(), name.size());
        Index(name);
        lua_insert(state_, -2);
        Expect("(");
        CallWith(name, 1);
      } else if (text_[at_] == '(') {
        ++at_;
        CallWith(std::string(last_name_), 0);
      } else {
        return;
      }
    }
  }

  void ReadPrimary() {
    SkipSpace();
    if (at_ >= text_.size()) Fail("the expression ends too early");
    const char sign = text_[at_];
    if (sign == '(') {
      ++at_;
      Read(0);
      Expect(")");
      last_name_ = "what the brackets contain";
    } else if (sign == '"' || sign == '\'') {
      ReadText(sign);
    } else if (std::isdigit(static_cast<unsigned char>(sign)) != 0 || sign == '.') {
      ReadNumber();
    } else {
      ReadWord();
    }
  }

  void ReadWord() {
    const std::string_view word = PeekName();
    if (word.empty()) Fail("the sign " + std::string(1, text_[at_]) + " is not known in expressions");
    last_name_ = word;
    if (word == "function") Fail("functions cannot be written here");
    at_ += word.size();
    if (word == "nil") return lua_pushnil(state_);
    if (word == "true" || word == "false") return lua_pushboolean(state_, word == "true");
    if (!variable_(state_, last_name_)) lua_pushnil(state_);
  }

  void ReadText(char quote) {
    std::string text;
    for (++at_; at_ < text_.size() && text_[at_] != quote; ++at_) {
      if (text_[at_] == '\\' && at_ + 1 < text_.size()) ++at_;
      text += text_[at_];
    }
    if (at_ >= text_.size()) Fail("a text has no end");
    ++at_;
    lua_pushlstring(state_, text.data(), text.size());
  }

  void ReadNumber() {
    double value = 0;
    const char* begin = text_.data() + at_;
    const char* end = text_.data() + text_.size();
    std::from_chars_result read{};
    if (text_.substr(at_).starts_with("0x")) {
      unsigned long long whole = 0;
      read = std::from_chars(begin + 2, end, whole, 16);
      value = static_cast<double>(whole);
    } else {
      read = NumberFromChars(text_.substr(at_), value);
    }
    if (read.ec != std::errc{}) Fail("a number is wrong");
    at_ += static_cast<std::size_t>(read.ptr - begin);
    lua_pushnumber(state_, value);
  }

  /// (table, key) -> value, with __index of tables and built-in functions.
  void Index(const std::string& name) {
    if (dry_) return lua_pop(state_, 1);
    last_name_ = name;
    constexpr int kMostSteps = 100;
    for (int step = 0; step < kMostSteps; ++step) {
      const bool is_table = lua_istable(state_, -2);
      if (is_table) {
        lua_pushvalue(state_, -1);
        lua_rawget(state_, -3);
        if (!lua_isnil(state_, -1)) return Replace(2);
        lua_pop(state_, 1);
      }
      if (luaL_getmetafield(state_, -2, "__index") == 0) {
        if (!is_table)
          Fail("a " + std::string(luaL_typename(state_, -2)) + " value has no fields: " + name + " is asked for");
        lua_pushnil(state_);
        return Replace(2);
      }
      if (lua_isfunction(state_, -1)) {
        lua_insert(state_, -3);
        RefuseScripts(2, "__index");
        return lua_call(state_, 2, 1);
      }
      // (value, key, __index) -> (__index, key)
      lua_insert(state_, -3);
      lua_remove(state_, -2);
    }
    Fail("__index leads back to itself");
  }

  /// Pops `count` values below the top.
  void Replace(int count) {
    for (int i = 0; i < count; ++i) lua_remove(state_, -2);
  }

  /// Calls a function with `given` arguments and those up to the closing bracket.
  void CallWith(const std::string& name, int given) {
    int count = given;
    if (!Accept(")")) {
      do {
        Read(0);
        ++count;
      } while (Accept(","));
      Expect(")");
    }
    if (dry_) return lua_pop(state_, count);
    if (may_call_ == MayCall::kReading && !OnlyReads(name))
      Fail(name + " might change the world: here, only functions can be called that read (GetPosition, tostring)");
    RefuseScripts(count, name);
    lua_call(state_, count, 1);
  }

  static bool OnlyReads(std::string_view name) {
    constexpr std::string_view kReading[] = {"tostring", "tonumber", "type", "abs", "ceil",  "floor", "max",
                                             "min",      "sqrt",     "len",  "sub", "upper", "lower"};
    return name.starts_with("Get") || name.starts_with("Is") || name.starts_with("Has") ||
           std::find(std::begin(kReading), std::end(kReading), name) != std::end(kReading);
  }

  bool IsScriptFunction(int index) { return lua_isfunction(state_, index) && lua_iscfunction(state_, index) == 0; }

  /// Raises an error unless the function below `count` arguments is built in and cannot call scripts.
  void RefuseScripts(int count, const std::string& name) {
    const int function = lua_gettop(state_) - count;
    if (!lua_isfunction(state_, function))
      Fail(name + " is not a function but a " + luaL_typename(state_, function) + " value");
    if (IsScriptFunction(function)) {
      Fail(name + " is a function of a script: while a script is paused, only built-in functions can be called");
    }
    for (int i = function + 1; i <= lua_gettop(state_); ++i) {
      const int type = lua_type(state_, i);
      if (type == LUA_TFUNCTION || type == LUA_TTHREAD || HasScriptMetamethod(i))
        Fail(name +
             " might call a function of a script: while a script is paused, only built-in functions can be called");
    }
  }

  bool HasScriptMetamethod(int index) {
    if (lua_getmetatable(state_, index) == 0) return false;
    bool has = false;
    lua_pushnil(state_);
    while (!has && lua_next(state_, -2) != 0) {
      has = IsScriptFunction(-1);
      lua_pop(state_, has ? 2 : 1);
    }
    lua_pop(state_, 1);
    return has;
  }

  /// (left, right) -> the result of a metamethod of either.
  void CallMetamethod(const char* metamethod, std::string_view sign) {
    if (luaL_getmetafield(state_, -2, metamethod) == 0 && luaL_getmetafield(state_, -1, metamethod) == 0)
      Fail(std::string(sign) + " is not possible with a " + luaL_typename(state_, -2) + " and a " +
           luaL_typename(state_, -1) + " value");
    lua_insert(state_, -3);
    RefuseScripts(2, metamethod);
    lua_call(state_, 2, 1);
  }

  void Compute(const Operator& one) {
    if (dry_) return lua_pop(state_, 1);
    if (one.left == 3) return Compare(one.text);
    const bool is_text = one.text == "..";
    const bool is_plain = is_text ? lua_isstring(state_, -2) && lua_isstring(state_, -1)
                                  : lua_isnumber(state_, -2) && lua_isnumber(state_, -1);
    if (!is_plain) return CallMetamethod(one.metamethod, one.text);
    if (is_text) return lua_concat(state_, 2);
    const double left = lua_tonumber(state_, -2), right = lua_tonumber(state_, -1);
    lua_pop(state_, 2);
    lua_pushnumber(state_, ResultOf(one.text[0], left, right));
  }

  static double ResultOf(char sign, double left, double right) {
    switch (sign) {
      case '+':
        return left + right;
      case '-':
        return left - right;
      case '*':
        return left * right;
      case '/':
        return left / right;
      case '%':
        return left - std::floor(left / right) * right;
      default:
        return std::pow(left, right);
    }
  }

  void Compare(std::string_view sign) {
    bool result = false;
    if (sign == "==" || sign == "~=") {
      // Things of the API are equal if they refer to the same thing; the comparison calls no script.
      const bool are_things = lua_isuserdata(state_, -1) && lua_isuserdata(state_, -2);
      const bool equal = are_things ? lua_equal(state_, -2, -1) != 0 : lua_rawequal(state_, -2, -1) != 0;
      result = equal == (sign == "==");
    } else {
      const bool are_numbers = lua_type(state_, -1) == LUA_TNUMBER && lua_type(state_, -2) == LUA_TNUMBER;
      const bool are_texts = lua_type(state_, -1) == LUA_TSTRING && lua_type(state_, -2) == LUA_TSTRING;
      if (!are_numbers && !are_texts)
        Fail(std::string(sign) + " is not possible with a " + luaL_typename(state_, -2) + " and a " +
             luaL_typename(state_, -1) + " value");
      const bool swaps = sign[0] == '>';
      const int less = swaps ? -1 : -2, more = swaps ? -2 : -1;
      result = lua_lessthan(state_, less, more) != 0 || (sign.size() == 2 && lua_rawequal(state_, less, more) != 0);
    }
    lua_pop(state_, 2);
    lua_pushboolean(state_, result);
  }

  lua_State* state_;
  std::string_view text_;
  const PushVariable& variable_;
  const MayCall may_call_;
  std::size_t at_ = 0;
  int depth_ = 0;
  bool dry_ = false;  ///< Parses without evaluation: operands that `and` and `or` skip.
  std::string last_name_;
};

}  // namespace

void EvaluateExpression(lua_State* state, std::string_view expression, const PushVariable& variable, MayCall may_call) {
  Reader(state, expression, variable, may_call).ReadAll();
}

}  // namespace soarbox::script
