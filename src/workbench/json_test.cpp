// SPDX-License-Identifier: BSD-2-Clause
// Requests and contents as JSON.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "workbench/contents_fields.h"
#include "workbench/contents_json.h"
#include "workbench/requests_json.h"

namespace soarbox::workbench {
namespace {

using testing::HasSubstr;

/// An example value for the type of a field.
Json ExampleOf(const RequestField& field) {
  if (field.type == "text") return "some text";
  if (field.type == "number") return 7;
  if (field.type == "true or false") return false;
  if (field.type == "list of text") return Json::array({"mind", "learning"});
  return field.type.substr(1, field.type.find('`', 1) - 1);  // The first of its words.
}

Diagnostic ErrorOf(const char* text) {
  const Result<Request> read = ReadRequest(Json::parse(text));
  EXPECT_FALSE(read) << text;
  return read ? Diagnostic() : read.error();
}

TEST(Requests, ComeBackAsTheyWereWritten) {
  EXPECT_EQ(RequestInfos().size(), std::variant_size_v<Request>);
  for (std::size_t i = 0; i < RequestInfos().size(); ++i) {
    const RequestInfo info = RequestInfos()[i];
    Json json{{"request", std::string(info.name)}};
    for (const RequestField& field : info.fields) json[std::string(field.name)] = ExampleOf(field);
    const Result<Request> read = ReadRequest(json);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->index(), i) << info.name;
    EXPECT_EQ(ToJson(*read), json);
    for (const RequestField& field : info.fields) {
      Json less = json;
      less.erase(std::string(field.name));
      EXPECT_EQ(ReadRequest(less).ok(), !field.is_needed) << info.name << " without " << field.name;
      Json other = json;
      other[std::string(field.name)] = Json::object();
      EXPECT_FALSE(ReadRequest(other)) << info.name << " with an odd " << field.name;
    }
  }
}

TEST(Requests, SayWhatIsWrongWithThem) {
  EXPECT_THAT(ErrorOf("[]").message, HasSubstr("object"));
  EXPECT_THAT(ErrorOf("{}").message, HasSubstr("'request'"));
  EXPECT_THAT(ErrorOf(R"({"request": 3})").message, HasSubstr("'request'"));
  EXPECT_THAT(ErrorOf(R"({"request": "seak"})").hint, HasSubstr("'seek'"));
  EXPECT_THAT(ErrorOf(R"({"request": "seek", "tik": 3, "tick": 1})").message,
              HasSubstr("tik is not one of its fields"));
  EXPECT_THAT(ErrorOf(R"({"request": "seek", "tick": -3})").message, HasSubstr("0 or more"));
  EXPECT_THAT(ErrorOf(R"({"request": "seek", "tick": 1e300})").message, HasSubstr("whole number"));
  EXPECT_THAT(ErrorOf(R"({"request": "edit", "file": "x", "line": 99999999999})").message, HasSubstr("line"));
  EXPECT_THAT(ErrorOf(R"({"request": "ask", "about": "comand"})").hint, HasSubstr("'command'"));
  EXPECT_THAT(ErrorOf(R"({"request": "look", "panels": ["mynd"]})").hint, HasSubstr("'mind'"));
  EXPECT_TRUE(ReadRequest(Json::parse(R"({"id": 5, "request": "live"})")));
}

TEST(Requests, MayHoldAnythingButWhatTheyAskFor) {
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  const Result<Request> read = ReadRequest(Json::parse(R"({"request": "ask", "about": )" + deep + "}"));
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("about cannot be"));
}

TEST(ContentsJson, HasEachPanelOnce) {
  const std::vector<std::string_view> names = ContentNames();
  EXPECT_EQ(names.size(), kPanelCount + 3) << "moment, offers, ghosts";
  for (const PanelInfo& info : kPanelInfos) EXPECT_THAT(names, testing::Contains(info.word));
  const Contents nothing;
  for (const std::string_view name : names) {
    const Json json = ToJson(nothing, name);
    EXPECT_TRUE(json.is_object()) << name;
    EXPECT_FALSE(json.empty()) << name;
  }
  EXPECT_TRUE(ToJson(nothing, "nothing").is_null());
  PanelSet panels;
  panels.Add(PanelId::kWhy);
  EXPECT_EQ(ContentNames(panels, nothing), (std::vector<std::string_view>{"moment", "why", "ghosts"}));
}

/// The names of the fields in an object.
std::vector<std::string> NamesIn(const Json& json) {
  std::vector<std::string> names;
  for (const auto& [name, value] : json.items()) names.push_back(name);
  return names;
}

TEST(JsonFields, AreWrittenAsTheyAreListed) {
  debugger::TypeLister lister;
  std::vector<std::string> listed;
  for (const debugger::TypeField& field : lister.FieldsOf<EditContents>()) {
    EXPECT_TRUE(field.is_needed) << field.name;
    listed.emplace_back(field.name);
  }
  EXPECT_EQ(NamesIn(debugger::JsonOf(EditContents())), listed);
  ASSERT_EQ(lister.types().size(), 1u) << "the problems of the text";
  EXPECT_EQ(lister.types().front().name, "Problem");

  Diagnostic problem;
  problem.message = "it is wrong";
  EXPECT_EQ(NamesIn(debugger::JsonOf(problem)), (std::vector<std::string>{"severity", "message"}));
  problem.hint = "mend it";
  EXPECT_EQ(NamesIn(debugger::JsonOf(problem)), (std::vector<std::string>{"severity", "message", "hint"}));
}

TEST(JsonFields, HaveTypesInTypeScriptAndInWords) {
  debugger::TypeLister lister;
  EXPECT_EQ(lister.TypeOf<std::vector<int>>().script, "readonly number[]");
  EXPECT_EQ((lister.TypeOf<std::vector<std::pair<std::string, bool>>>().script),
            "readonly (readonly [string, boolean])[]");
  EXPECT_EQ((lister.TypeOf<std::array<double, 3>>().script), "readonly [number, number, number]");
  EXPECT_EQ((lister.TypeOf<std::map<std::string, int>>().words), "object of number");
  EXPECT_EQ(lister.TypeOf<std::optional<LessonContents>>().script, "Lesson | null");
  std::set<std::string_view> names;
  for (const ContentField& field : ContentFields()) EXPECT_NE(field.type(lister).script, "") << field.name;
  for (const debugger::TypeInfo& type : lister.types()) EXPECT_TRUE(names.insert(type.name).second) << type.name;
}

}  // namespace
}  // namespace soarbox::workbench
