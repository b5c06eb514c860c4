// SPDX-License-Identifier: BSD-2-Clause
#include "cli/graph_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "cli/interpreter.h"
#include "cli/session.h"

namespace soarbox::cli {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class GraphTest : public testing::Test {
 protected:
  GraphTest() {
    folder_ = std::filesystem::temp_directory_path() /
              ("soarbox_graph_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
    folder_ = std::filesystem::canonical(folder_);
    if (const char* path = std::getenv("PATH")) path_ = path;
    Do("cd " + folder_.string());
    Do("sp {make (state <s> ^superstate nil) --> (<s> ^thing <t> ^|odd { name| |a \"b\" <c> \\\\ d|)"
       "  (<t> ^x 1 ^y 2.5 ^next <n>) (<n> ^back <t> ^deep.deeper yes)}");
    Do("run 2; visualize viewer-launch off");
  }
  ~GraphTest() override {
    setenv("PATH", path_.c_str(), 1);
    std::filesystem::remove_all(folder_);
  }

  CommandResult Do(const std::string& line) { return interpreter_.Execute(session_, line); }
  std::string Read(const std::string& name) const {
    std::ostringstream content;
    content << std::ifstream(folder_ / name).rdbuf();
    return content.str();
  }

  std::filesystem::path folder_;
  std::string path_;
  kernel::Agent agent_{"soar"};
  Session session_{agent_};
  Interpreter interpreter_;
};

TEST_F(GraphTest, ObjectsAreRecordsWithTheirValuesAndLinks) {
  Do("visualize generate-image off");
  const CommandResult result = Do("visualize wm t1");
  EXPECT_TRUE(result.ok);
  EXPECT_EQ(result.text,
            "Generating visualization...\nDrawing written to " + (folder_ / "soar_viz1.gv").string() + ".\n");
  EXPECT_EQ(Read("soar_viz1.gv"),
            "digraph working_memory {\n"
            "  graph [rankdir=LR, splines=\"polyline\"];\n"
            "  node [shape=record];\n"
            "  \"T1\" [label=\"{T1|{x|1}|{y|2.500000}}\"];\n"
            "  \"T1\" -> \"N1\" [label=\"next\"];\n"
            "  \"N1\" [label=\"{N1}\"];\n"
            "  \"N1\" -> \"T1\" [label=\"back\"];\n"
            "  \"N1\" -> \"D1\" [label=\"deep\"];\n"
            "  \"D1\" [label=\"{D1|{deeper|yes}}\"];\n"
            "}\n");
}

TEST_F(GraphTest, WhatHasAMeaningInGraphvizIsEscaped) {
  EXPECT_EQ(GraphQuoted("a \"b\" \\ c\nd"), "\"a \\\"b\\\" \\\\ c\\nd\"");
  EXPECT_EQ(GraphRecordText("|a {b} <c> \"d\"|"), "\\|a\\ \\{b\\}\\ \\<c\\>\\ \\\"d\\\"\\|");
  Do("visualize generate-image off; visualize wm s1 1");
  EXPECT_THAT(Read("soar_viz1.gv"), HasSubstr("{\\|odd\\ \\{\\ name\\||\\|a\\ \\\"b\\\"\\ \\<c\\>"));
}

TEST_F(GraphTest, SettingsChangeTheDrawing) {
  Do("visualize generate-image off; visualize use-same-file on; visualize file-name picture");
  Do("visualize wm");
  const std::string usual = Read("picture.gv");
  EXPECT_THAT(usual, HasSubstr("\"S1\" ["));
  EXPECT_THAT(usual, HasSubstr("\"S2\" ["));
  EXPECT_THAT(usual, Not(HasSubstr("\"S2\" -> \"S1\"")));
  EXPECT_THAT(usual, Not(HasSubstr("type")));
  Do("visualize architectural-wmes on; visualize separate-states off; visualize wm");
  EXPECT_THAT(Read("picture.gv"), HasSubstr("\"S2\" -> \"S1\" [label=\"superstate\"]"));
  EXPECT_THAT(Read("picture.gv"), HasSubstr("{type|state}"));
  Do("visualize memory-format node; visualize line-style {\"x]}; visualize wm t1 1");
  EXPECT_THAT(Read("picture.gv"), HasSubstr("splines=\"\\\"x]\""));
  EXPECT_THAT(Read("picture.gv"), HasSubstr("shape=plaintext, label=\"1\""));
  EXPECT_THAT(Read("picture.gv"), Not(HasSubstr("D1"))) << "too deep";
  EXPECT_FALSE(std::filesystem::exists(folder_ / "soar_viz1.gv"));
  EXPECT_THAT(Do("visualize print-debug on; visualize wm t1 1").text, EndsWith("}\n"));
}

TEST_F(GraphTest, WithoutDotTheDrawingIsWrittenAndTheMissingImageIsAnError) {
  setenv("PATH", folder_.c_str(), 1);
  const CommandResult result = Do("visualize wm");
  EXPECT_FALSE(result.ok);
  EXPECT_THAT(result.text, HasSubstr("`dot` command failed. Do you have GraphViz installed?!\n\nError while sourcing"));
  EXPECT_THAT(result.diagnostics.back().hint, HasSubstr("generate-image off"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "soar_viz1.gv"));
}

TEST_F(GraphTest, DotIsCalledWithoutAShell) {
  const std::filesystem::path dot = folder_ / "dot";
  std::ofstream(dot) << "#!/bin/sh\necho \"$@\" > \"$3\"\n";
  std::filesystem::permissions(dot, std::filesystem::perms::owner_all);
  setenv("PATH", folder_.c_str(), 1);
  EXPECT_THAT(Do("visualize file-name {a;b $(c)}; visualize wm").text, HasSubstr("Image written to "));
  const std::string stem = (folder_ / "a;b $(c)1").string();
  EXPECT_EQ(Read("a;b $(c)1.svg"), "-Tsvg -o " + stem + ".svg " + stem + ".gv\n");
  EXPECT_THAT(Do("visualize image-type {x y}; visualize wm").text, HasSubstr("is not a type of images"));
  std::ofstream(dot) << "#!/bin/sh\nexit 3\n";
  EXPECT_THAT(Do("visualize image-type png; visualize wm").text, HasSubstr("made no image of type png"));
}

TEST_F(GraphTest, WrongWordsAndMissingMemoriesAreNamed) {
  EXPECT_THAT(Do("visualize wm x9").text, HasSubstr("There is no identifier x9"));
  EXPECT_THAT(Do("visualize wm s1 0").text, HasSubstr("depth"));
  EXPECT_THAT(Do("visualize wm s1 s1").text, HasSubstr("Syntax"));
  EXPECT_THAT(Do("visualize smem").text, HasSubstr("Semantic memory is empty"));
  Do("smem --add {(@1 ^name tank ^has @2) (@2 ^name hatch)}");
  EXPECT_THAT(Do("visualize smem @9").text, HasSubstr("@9 not found"));
  EXPECT_THAT(Do("visualize smem tank").text, HasSubstr("Syntax"));
  EXPECT_THAT(Do("visualize file-name {no/such/folder/x}; visualize wm").text,
              HasSubstr("Failed to open file for writing"));
}

}  // namespace
}  // namespace soarbox::cli
