// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/base/symbol_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "kernel/base/known_symbols.h"

namespace soarbox::kernel {
namespace {

TEST(SymbolTable, EqualContentsGiveTheSameHandleAndKindsStayApart) {
  SymbolTable symbols;
  EXPECT_EQ(symbols.String("red"), symbols.String("red"));
  EXPECT_EQ(symbols.Float(2.5), symbols.Float(2.5));
  EXPECT_NE(symbols.Integer(5), symbols.Float(5.0));
  EXPECT_NE(symbols.Integer(5), symbols.String("5"));
  EXPECT_NE(symbols.Variable("<s>"), symbols.String("<s>"));
  EXPECT_EQ(symbols.FindString("blue"), Symbol());
}

TEST(SymbolTable, IntegersOfAllSizesKeepTheirValue) {
  SymbolTable symbols;
  for (const std::int64_t value :
       {std::int64_t{0}, std::int64_t{-1}, std::int64_t{268435455}, std::int64_t{268435456}, std::int64_t{-268435456},
        std::int64_t{-268435457}, std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()}) {
    EXPECT_EQ(symbols.IntegerValue(symbols.Integer(value)), value);
    EXPECT_EQ(symbols.Integer(value), symbols.Integer(value));
  }
}

TEST(SymbolTable, WordsOfTheArchitectureHaveFixedHandles) {
  SymbolTable symbols;
  EXPECT_EQ(symbols.String("operator"), words::kOperator);
  EXPECT_EQ(symbols.String("superstate"), words::kSuperstate);
  EXPECT_EQ(symbols.Text(words::kCmd), "cmd");
  for (std::size_t i = 0; i < kPredefinedWords.size(); ++i) {
    EXPECT_EQ(symbols.FindString(kPredefinedWords[i]).index(), i);
  }
}

TEST(SymbolTable, StampsGrowInOrderOfCreation) {
  SymbolTable symbols;
  EXPECT_LT(symbols.Stamp(words::kSmem), symbols.Stamp(symbols.Integer(5)));
  EXPECT_LT(symbols.Stamp(symbols.Integer(5)), symbols.Stamp(words::kCount));
  const SymbolTable::PinScope pin(symbols);
  const Symbol first = symbols.String("first");
  EXPECT_LT(symbols.Stamp(words::kCmd), symbols.Stamp(first));
  EXPECT_LT(symbols.Stamp(first), symbols.Stamp(symbols.Integer(12345)));
}

TEST(SymbolTable, IdentifiersCountPerLetterAndAreUsedAgain) {
  SymbolTable symbols;
  const Symbol s1 = symbols.NewIdentifier('S');
  const Symbol i1 = symbols.NewIdentifier('I');
  EXPECT_EQ(ToString(symbols, s1), "S1");
  EXPECT_EQ(ToString(symbols, i1), "I1");
  EXPECT_EQ(ToString(symbols, symbols.NewIdentifier('S', 7)), "S7");
  EXPECT_EQ(ToString(symbols, symbols.NewIdentifier('S')), "S8");
  EXPECT_EQ(symbols.FindIdentifier('I', 1), i1);
  symbols.FreeIdentifier(i1);
  EXPECT_EQ(symbols.FindIdentifier('I', 1), Symbol());
  EXPECT_EQ(symbols.FindIdentifier('S', 8).index(), 3u);
  EXPECT_EQ(symbols.FindIdentifier('S', 72), Symbol());
  EXPECT_EQ(symbols.NewIdentifier('I').index(), i1.index()) << "indices are used again, numbers are not";
  EXPECT_EQ(symbols.IdentifierLimit(), 4u);
}

TEST(SymbolTable, MixedKindsCompareAsLessInBothDirections) {
  SymbolTable symbols;
  const Symbol word = symbols.String("word"), three = symbols.Integer(3);
  EXPECT_TRUE(symbols.Compare(word, three) < 0);
  EXPECT_TRUE(symbols.Compare(three, word) < 0);
  EXPECT_TRUE(symbols.Compare(three, symbols.Float(2.5)) > 0);
  EXPECT_TRUE(symbols.Compare(three, symbols.Float(3.0)) == 0);
  EXPECT_TRUE(symbols.Compare(symbols.String("B"), symbols.String("a")) < 0) << "strings by bytes";
  EXPECT_TRUE(symbols.Compare(symbols.NewIdentifier('B'), symbols.NewIdentifier('A')) > 0);
}

TEST(SymbolTable, SweepingFreesWhatIsNeitherPinnedNorMarked) {
  SymbolTable symbols;
  Symbol pinned;
  {
    const SymbolTable::PinScope pin(symbols);
    pinned = symbols.String("in-a-rule");
  }
  const Symbol marked = symbols.String("in-memory");
  symbols.String("gone");
  symbols.Float(1.25);
  EXPECT_EQ(symbols.UnpinnedCount(), 3u);
  symbols.BeginMark();
  symbols.Mark(marked);
  symbols.Sweep();
  EXPECT_EQ(symbols.UnpinnedCount(), 1u);
  EXPECT_EQ(symbols.FindString("gone"), Symbol());
  EXPECT_EQ(symbols.FindString("in-memory"), marked);
  EXPECT_EQ(symbols.FindString("in-a-rule"), pinned);
  symbols.Sweep();
  EXPECT_EQ(symbols.FindString("in-memory"), Symbol()) << "marks last for one sweep";
}

TEST(SymbolTable, AFloatThatChangesEachTickNeedsNoNewMemory) {
  SymbolTable symbols;
  const auto tick = [&](int t) {
    const Symbol now = symbols.Float(t * 0.1);
    if (symbols.UnpinnedCount() > 64) {
      symbols.BeginMark();
      symbols.Mark(now);
      symbols.Sweep();
    }
  };
  for (int t = 0; t < 1000; ++t) tick(t);
  const std::size_t before = symbols.MemoryBytes();
  for (int t = 1000; t < 20000; ++t) tick(t);
  EXPECT_EQ(symbols.MemoryBytes(), before);
}

TEST(SymbolTable, TablesThatReadTheSameShareAFrozenBase) {
  SymbolTable first, second, other;
  const auto load = [](SymbolTable& symbols, double number) {
    const SymbolTable::PinScope pin(symbols);
    symbols.String("colour");
    symbols.Variable("<s>");
    symbols.Float(number);
    symbols.Integer(77777);
  };
  load(first, 2.5);
  load(second, 2.5);
  load(other, 3.5);
  EXPECT_EQ(first.Digest(), second.Digest());
  EXPECT_NE(first.Digest(), other.Digest());
  const Symbol colour = second.String("colour"), number = second.Float(2.5);
  const std::uint32_t stamp = second.Stamp(second.Integer(77777));

  const auto base = first.Freeze();
  EXPECT_TRUE(second.Adopt(base));
  EXPECT_FALSE(other.Adopt(base));
  EXPECT_EQ(second.String("colour"), colour);
  EXPECT_EQ(second.Float(2.5), number);
  EXPECT_EQ(second.Text(colour), "colour");
  EXPECT_EQ(second.Stamp(second.Integer(77777)), stamp);
  const Symbol fresh = second.String("only here");
  EXPECT_EQ(second.Text(fresh), "only here");
  EXPECT_EQ(first.FindString("only here"), Symbol());
  EXPECT_EQ(first.Text(first.String("colour")), "colour");
}

struct Printed {
  const char* text;
  const char* expected;
};
class StringPrinting : public testing::TestWithParam<Printed> {};

TEST_P(StringPrinting, PutsBarsWhereTheLexerWouldReadSomethingElse) {
  SymbolTable symbols;
  EXPECT_EQ(ToString(symbols, symbols.String(GetParam().text)), GetParam().expected);
  EXPECT_EQ(ToString(symbols, symbols.String(GetParam().text), false), GetParam().text);
}

INSTANTIATE_TEST_SUITE_P(AsInTheTranscripts, StringPrinting,
                         testing::Values(Printed{"abc", "abc"}, Printed{"a-b", "|a-b|"}, Printed{"why?", "why?"},
                                         Printed{"50%", "|50%|"}, Printed{"*", "*"}, Printed{"+", "|+|"},
                                         Printed{"", "||"}, Printed{"S1", "|S1|"}, Printed{"42", "|42|"},
                                         Printed{"4.2", "|4.2|"}, Printed{"<x>", "|<x>|"},
                                         Printed{"<variable>", "|<variable>|"}, Printed{"a\\b", "|a\\\\b|"},
                                         Printed{"one|two", "|one\\|two|"}, Printed{"with space", "|with space|"},
                                         Printed{"0x10", "0x10"}, Printed{"1e3", "1e3"}, Printed{"1_000", "1_000"},
                                         Printed{"1-2", "|1-2|"}, Printed{"-123", "|-123|"},
                                         Printed{"rule-a", "rule-a"}));

TEST(SymbolPrinting, FloatsHaveSixDecimals) {
  SymbolTable symbols;
  EXPECT_EQ(ToString(symbols, symbols.Float(3.1)), "3.100000");
  EXPECT_EQ(ToString(symbols, symbols.Float(1e-7)), "0.000000");
  EXPECT_EQ(ToString(symbols, symbols.Float(-0.0)), "-0.000000");
  EXPECT_EQ(ToString(symbols, symbols.Float(1e200 * 1e200)), "inf");
  EXPECT_EQ(ToString(symbols, symbols.Float(-std::nan(""))), "-nan");
  EXPECT_EQ(ToString(symbols, symbols.Float(1e300)).size(), 301u + 7u);
}

}  // namespace
}  // namespace soarbox::kernel
