// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include "script/check_names.h"

namespace soarbox::script {
namespace {

std::string Found(std::string_view text, const GlobalNames& known = {}) {
  std::string found;
  for (const Diagnostic& one : CheckCalls(text, "A.lua", known))
    found += std::to_string(one.line) + ":" + std::to_string(one.column) + " " + one.message + "; " + one.hint + "\n";
  return found;
}

TEST(CheckCalls, NamesFunctionsThatNothingDefines) {
  EXPECT_EQ(Found("local x = 1\n  Frobnicate(x)\n"),
            "2:3 nothing defines the function Frobnicate; is its name right, and is its script loaded with require?\n");
  EXPECT_EQ(Found("function Build() end\nBiuld()\nprnit('x')\n"),
            "2:1 nothing defines the function Biuld; did you mean Build?\n"
            "3:1 nothing defines the function prnit; did you mean print?\n");
  EXPECT_EQ(Found("Lib_Go()", {"Lib_Go"}), "");
}

TEST(CheckCalls, SaysNothingWhereANameMayHaveAValue) {
  for (const char* text :
       {"local function f() end f()", "local f = g or print f()", "function h(callback) callback() end",
        "if Optional then Optional() end", "for _, f in ipairs({}) do f() end", "x.Foo() x:Foo()",
        "-- Foo()\nprint('Foo()')", "print([[ Foo() ]])", "a = { Foo = 1 } print(Foo, Foo())", "return (1)",
        "if (1) then elseif (2) then end while (1) do end", "print(not (1))", "setfenv(1, {}) Foo()",
        "Foo = function() end Foo()", "Vector(1)", "print(('x'):Foo(), ({})[1]:Foo():Bar())"})
    EXPECT_EQ(Found(text), "") << text;
  EXPECT_NE(Found("print('a' .. Foo())"), "");
}

TEST(CheckCalls, FindsModulesAndGlobals) {
  EXPECT_EQ(ModulesOf("require 'A'\nrequire(\"B\") -- require 'C'\n"), (std::vector<std::string>{"A", "B"}));
  GlobalNames names;
  AddGlobalsOf("function F() end local function G() end x = 1 local y = 2 t.z = 3", names);
  EXPECT_EQ(names, (GlobalNames{"F", "x"}));
}

TEST(CheckCalls, AShortenedMethodGetsASuggestion) {
  const std::vector<Diagnostic> found = CheckNames("agent:GetPos()\nagent:Fly()\n", "A.lua");
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].hint, "did you mean GetPosition?");
  EXPECT_EQ(found[1].message, "an agent has no function Fly");
}

}  // namespace
}  // namespace soarbox::script
