// SPDX-License-Identifier: BSD-2-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/interpreter.h"
#include "cli/session.h"
#include "kernel/agent.h"

namespace soarbox::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Results of substates in the output of commands.
class ResultsTest : public testing::Test {
 protected:
  ResultsTest() {
    session_.stream().SetSink([this](std::string_view text) { printed_ += text; });
    Do("sp {init (state <s> ^superstate nil) --> (<s> ^c 3 ^d 5)}");
  }
  std::string Do(const std::string& line) { return interpreter_.Execute(session_, line).text; }

  kernel::Agent agent_{"soar"};
  Session session_{agent_};
  Interpreter interpreter_;
  std::string printed_;
};

TEST_F(ResultsTest, AnItemRestsOnItsProposal) {
  Do("sp {propose (state <s> ^superstate nil) --> (<s> ^operator <o> + ^operator <o2> +) (<o> ^name foo) (<o2> ^name "
     "bar)}");
  Do("sp {choose (state <ss> ^superstate <s> ^impasse tie ^item <i> ^item {<j> <> <i>}) (<i> ^name foo) -->"
     " (<s> ^operator <i> > <j>, = 5) (<i> ^score 4)}");
  Do("run 2");
  EXPECT_EQ(Do("print justify1"),
            "sp {justify1\n"
            "    :justification ;# not reloadable\n"
            "    (state S1 ^operator O1 + ^operator O2 +)\n"
            "    (O1 ^name foo)\n"
            "    -->\n"
            "    (S1 ^operator O1 > O2 ^operator O1 = 5)\n"
            "    (O1 ^score 4)\n"
            "}\n\n");
  EXPECT_EQ(Do("print"), "choose \npropose \ninit \njustify1 \n");
  EXPECT_THAT(Do("preferences s1 operator --timetags"), HasSubstr("From justify1\n 18 19 14\n"));
  EXPECT_EQ(Do("excise justify1"), "1 production excised.\n");
  EXPECT_EQ(Do("print --justifications"), "");
  Do("run 1");
  EXPECT_THAT(Do("print --stack"), HasSubstr("==>S: S3 (operator tie)"));
}

TEST_F(ResultsTest, AnOSupportedRejectFromBelowIsSpent) {
  Do("sp {propose (state <s> ^superstate nil) --> (<s> ^operator.name foo)}");
  Do("sp {apply (state <ss> ^superstate <s> ^impasse no-change) (<s> ^operator.name foo) --> (<s> ^d 1 - ^d 1 2)}");
  Do("run 3");
  EXPECT_THAT(Do("print s1"), HasSubstr("^d 1 ^d 2 ^d 5 "));
  const std::string preferences = Do("preferences s1 d --names");
  EXPECT_THAT(preferences, HasSubstr("  (S1 ^d 1)  :O \n    From justify1\n"));
  EXPECT_THAT(preferences, HasSubstr("  (S1 ^d 1)  :I  [level 2] \n    From apply\n"));
  EXPECT_THAT(preferences, Not(HasSubstr("rejects")));
}

TEST_F(ResultsTest, AMatchWithoutAnOperatorHasTheSupportOfTheOneBefore) {
  Do("sp {propose (state <s> ^superstate nil) --> (<s> ^operator.name foo)}");
  Do("sp {any (state <s> ^type state ^{ <> item <a> } <v>) --> (<s> ^seen yes)}");
  Do("trace 5; run 3");
  EXPECT_THAT(printed_, HasSubstr("+ (S1 ^seen yes +) (any)"));
  EXPECT_THAT(printed_, HasSubstr("+ (S1 ^seen yes +  :O ) (any)"));
  EXPECT_THAT(printed_, HasSubstr("+ (S2 ^seen yes +  :O ) [level 2] (any)"));
}

TEST_F(ResultsTest, AStructureThatWasMadeEarlierOutlivesItsState) {
  Do("sp {propose (state <s> ^superstate nil -^result) --> (<s> ^operator.name foo)}");
  Do("sp {one (state <s> ^superstate.operator.name foo -^part) --> (<s> ^operator <o> +) (<o> ^name one)}");
  Do("sp {make (state <s> ^operator.name one) --> (<s> ^part <p>) (<p> ^size 4 ^inner <i>) (<i> ^size 2)}");
  Do("sp {two (state <s> ^part) --> (<s> ^operator <o> +) (<o> ^name two)}");
  Do("sp {return (state <s> ^operator.name two ^part <p> ^superstate <ss>) --> (<ss> ^result <p>)}");
  Do("run 6");
  EXPECT_THAT(Do("print --depth 3 s1"), HasSubstr("^inner I4 ^size 4"));
  EXPECT_THAT(Do("print --depth 3 s1"), HasSubstr("(I4 ^size 2)"));
  EXPECT_EQ(agent_.CheckInvariants(), "");
}

TEST_F(ResultsTest, EqualFiringsMakeOneJustification) {
  Do("sp {propose (state <s> ^superstate nil) --> (<s> ^operator.name foo)}");
  Do("sp {local (state <s> ^superstate.operator.name foo) --> (<s> ^local 1 2)}");
  Do("sp {give (state <s> ^local <l> ^superstate <ss>) (<ss> ^c <c>) --> (<ss> ^got <c>)}");
  Do("run 3");
  EXPECT_EQ(agent_.Justifications().size(), 1u);
  const std::string preferences = Do("preferences s1 got --names");
  EXPECT_EQ(preferences.find("From give"), preferences.rfind("From give"));
}

TEST_F(ResultsTest, ARuleThatMakesTooManyDuplicatesMakesNothingMoreInThisDecision) {
  Do("sp {propose (state <s> ^superstate nil) --> (<s> ^operator.name foo)}");
  Do("sp {local (state <s> ^superstate.operator.name foo) --> (<s> ^local 1 2 3 4 5 6)}");
  Do("sp {give (state <s> ^local <l> ^superstate <ss>) (<ss> ^c <c>) --> (<ss> ^got <c>)}");
  Do("trace 2; run 3");
  EXPECT_THAT(printed_, HasSubstr("Rule that has reached the max-dupes limit: give"));
}

TEST_F(ResultsTest, PreferencesAreListedInTheirOrder) {
  Do("sp {propose (state <s> ^superstate nil) --> (<s> ^operator <a> + > = ^operator <b> + < = 2)"
     " (<s> ^operator <a> > <b>, = <b>)}");
  Do("run 1");
  const std::string text = Do("preferences s1 operator");
  std::size_t last = 0;
  for (const char* title : {"acceptables:", "unary indifferents:", "bests:", "worsts:", "binary indifferents:",
                            "betters:", "numeric indifferents:"}) {
    const std::size_t at = text.find(std::string("\n") + title);
    EXPECT_NE(at, std::string::npos) << title << '\n' << text;
    EXPECT_GE(at, last) << title;
    last = at;
  }
}

TEST_F(ResultsTest, APreferenceForAConstantIsToldOf) {
  Do("sp {bad (state <s> ^c <v>) --> (<v> ^x <v> ^<v> (+ 1 <v>) ^z <q>)}");
  Do("run 1");
  EXPECT_THAT(printed_,
              HasSubstr("Error: RHS of action           ([RETE-loc] ^x [RETE-loc] +) makes a preference for 3 "
                        "(not an identifier)\n"));
  EXPECT_THAT(printed_, HasSubstr("([RETE-loc] ^[RETE-loc] (+ 1 [RETE-loc]) +)"));
  EXPECT_THAT(printed_, HasSubstr("([RETE-loc] ^z <unbound-variable> +)"));
}

TEST_F(ResultsTest, AResultGoesWithTheNextElaborationAfterItsState) {
  Do("sp {propose (state <s> ^superstate nil) --> (<s> ^operator <o> + ^operator <p> +) (<o> ^name foo)}");
  Do("sp {choose (state <ss> ^superstate <s> ^item <i>) (<i> ^name foo) --> (<s> ^operator <i> >)}");
  Do("sp {plain (state <ss> ^superstate <s> ^impasse tie) --> (<s> ^two yes)}");
  Do("trace 4; run 2");
  // No superstate element supports it: the state is removed first.
  const std::size_t gone = printed_.find("^impasse tie)", printed_.find("<=WM: "));
  const std::size_t result = printed_.find("<=WM: ", printed_.find("active level 0"));
  EXPECT_NE(gone, std::string::npos);
  EXPECT_LT(gone, result);
  EXPECT_THAT(printed_.substr(result == std::string::npos ? 0 : result, 40), HasSubstr("^two yes"));
}

TEST_F(ResultsTest, AFactThatTheTopStateHasAlreadyIsTracedAsIgnored) {
  Do("sp {propose (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name go)}");
  Do("sp {first (state <s> ^operator.name go) --> (<s> ^x 1)}");
  Do("sp {second (state <s> ^operator.name go ^x 1) --> (<s> ^x 1)}");
  Do("trace 5");
  Do("run 2");
  EXPECT_THAT(printed_, HasSubstr("\n+ (S1 ^x 1 +  :O ) (first)\n"));
  EXPECT_THAT(printed_, HasSubstr("\n+ (S1 ^x 1 +  :O ) (second) ALREADY SUPPORTED ON TOP LEVEL.  IGNORING.\n"));
}

}  // namespace
}  // namespace soarbox::cli
