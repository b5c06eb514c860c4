// SPDX-License-Identifier: BSD-2-Clause
#include "language/visual_soar.h"

#include <gtest/gtest.h>

#include <fstream>

#include "language/workspace.h"

namespace soarbox::language {
namespace {

namespace fs = std::filesystem;

class VisualSoar : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "soarbox-vsa-XXXXXX").string();
    ASSERT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
    Write("door/_firstload.soar", "# first\n");
    Write("door/open.soar",
          "sp {propose*open (state <s> ^kind door ^io.input-link.lok shut) --> (<s> ^operator <o> +) (<o> ^name "
          "open)}\n");
  }
  void TearDown() override { fs::remove_all(folder_); }
  fs::path Write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
    return folder_ / name;
  }
  fs::path WriteText() const {
    Write(
        "door/door.dm",
        "8\nSOAR_ID 0\nENUMERATION 1 1 nil\nSOAR_ID 2\nSOAR_ID 3\nENUMERATION 4 2 open closed\nENUMERATION 5 2 door "
        "gate\n"
        "SOAR_ID 6\nSTRING 7\n7\n0 superstate 1\n0 io 2\n2 input-link 3\n3 lock 4\n0 kind 5\n0 operator 6\n6 name 7\n");
    return Write("door.vsa",
                 "VERSION 4\n/door/door.dm\n0\tROOT door door 1\n1\t0\tFOPERATOR _firstload _firstload.soar 2\n"
                 "2\t0\tOPERATOR open open.soar 3\n3\t0\tOPERATOR gone gone.soar 4\nEND\n");
  }
  fs::path folder_;
};

TEST_F(VisualSoar, TheTextFormNamesFilesAndTheDatamap) {
  std::vector<Diagnostic> problems;
  const Result<VisualSoarProject> project = ReadVisualSoar(WriteText(), problems);
  ASSERT_TRUE(project.ok());
  EXPECT_EQ(project->rules, (std::vector<fs::path>{folder_ / "door/_firstload.soar", folder_ / "door/open.soar"}));
  EXPECT_EQ(project->datamap.vertices.size(), 8U);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems.front().line, 6);
  EXPECT_EQ(problems.front().message, "the layout names door/gone.soar, which is not there");
}

TEST_F(VisualSoar, TheSeparatorsOfWindowsAreRead) {
  WriteText();
  std::vector<Diagnostic> problems;
  const Result<VisualSoarProject> project =
      ReadVisualSoar(Write("bot.vsa",
                           "VERSION 4\r\n\\door\\door.dm\r\n0\tROOT door door 1\r\n"
                           "1\t0\tFOPERATOR _firstload _firstload.soar 2\r\n"
                           "2\t0\tOPERATOR open open.soar 3\r\nEND\r\n"),
                     problems);
  ASSERT_TRUE(project.ok());
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(project->rules.size(), 2U);
  EXPECT_EQ(project->datamap.vertices.size(), 8U);
}

TEST_F(VisualSoar, ChoicesOfAttributesAreKnownOneByOne) {
  const fs::path project = WriteText();
  const fs::path rules = Write("door/open.soar",
                               "sp {a (state <s> ^io <io>) (<io> ^{ << input-link io >> <way> }.lock <l>)\n"
                               "   (<s> ^<< kind knd >> door) --> (<s> ^kind gate)}\n");
  const std::vector<Diagnostic> found = CheckAgainstDatamap(rules);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].message, "the datamap has no attribute ^io of ^io");
  EXPECT_EQ(found[1].message, "the datamap has no attribute ^knd of states");
  EXPECT_EQ(found[1].line, 2);
}

TEST_F(VisualSoar, AnUnknownAttributeIsToldWithWhatWasMeant) {
  const std::vector<Diagnostic> found = CheckAgainstDatamap(WriteText());
  ASSERT_EQ(found.size(), 2U);  // Including the missing file.
  EXPECT_EQ(found.back().message, "the datamap has no attribute ^lok of ^io.input-link");
  EXPECT_EQ(found.back().hint, "did you mean lock?");
  EXPECT_EQ(found.back().line, 1);
}

TEST_F(VisualSoar, AnUnknownValueIsTold) {
  const fs::path project = WriteText();
  const fs::path rules = Write("door/open.soar", "sp {a (state <s> ^kind doer) --> (<s> ^io.input-link.lock ajar)}\n");
  const std::vector<Diagnostic> found = CheckAgainstDatamap(rules);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found.front().message, "the datamap has no value doer for ^kind");
  EXPECT_EQ(found.front().hint, "did you mean door?");
}

TEST_F(VisualSoar, WhatIsWrittenIsReadBackAndKnowsItsOwnRules) {
  const fs::path rules = folder_ / "door/open.soar";
  Workspace workspace;
  const Program program = workspace.ProgramOf(rules);
  std::vector<const Document*> documents;
  for (const auto& document : program.documents) documents.push_back(document.get());
  const fs::path written = Write("door/open.vsa.json", ToProjectJson(DatamapOf(documents), "open", {"open.soar"}));
  std::vector<Diagnostic> problems;
  const Result<VisualSoarProject> project = ReadVisualSoar(written, problems);
  ASSERT_TRUE(project.ok());
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(project->rules, std::vector<fs::path>{rules});
  EXPECT_TRUE(CheckAgainstDatamap(written).empty());
}

TEST_F(VisualSoar, DamagedProjectsAreErrorsWithTheirLine) {
  std::vector<Diagnostic> problems;
  const fs::path text = WriteText();
  Write("door/door.dm", "3\nSOAR_ID 0\nWORD 1\n");
  const Result<VisualSoarProject> wrong_type = ReadVisualSoar(text, problems);
  ASSERT_FALSE(wrong_type.ok());
  EXPECT_EQ(wrong_type.error().line, 3);
  for (const char* map : {"", "x", "99999999999", "1\nSOAR_ID 0\n1\n0 a 7\n", "2\nSOAR_ID 0\n"}) {
    Write("door/door.dm", map);
    EXPECT_FALSE(ReadVisualSoar(text, problems).ok()) << map;
  }
  for (const char* json : {"", "[]", "{\"datamap\":1}", "{\"datamap\":{\"vertices\":[3]}}",
                           "{\"layout\":{\"children\":4},\"datamap\":{}}"})
    EXPECT_FALSE(ReadVisualSoar(Write("x.vsa.json", json), problems).ok()) << json;
}

TEST_F(VisualSoar, FilesOutsideOfTheProjectAreNotRead) {
  Write("outside.soar", "");
  std::vector<Diagnostic> problems;
  const Result<VisualSoarProject> project =
      ReadVisualSoar(Write("door/x.vsa.json", "{\"layout\":{\"file\":\"../outside.soar\"}}"), problems);
  ASSERT_TRUE(project.ok());
  EXPECT_TRUE(project->rules.empty());
  EXPECT_EQ(problems.size(), 1U);
}

}  // namespace
}  // namespace soarbox::language
