// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/launch.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bytes/base64.h"
#include "serve/lti/jwt.h"

namespace soarbox::lti {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kNow_s = 1'800'000'000;
const std::string kTool = "https://purl.imsglobal.org/spec/lti/claim/";

const Platform kMoodle = {"Moodle",
                          "https://moodle.example",
                          "client-1",
                          "https://moodle.example/auth",
                          "https://moodle.example/token",
                          "https://moodle.example/certs",
                          "https://moodle.example/token",
                          {"1", "7"}};

Json Claims() {
  return {{"iss", "https://moodle.example"},
          {"aud", "client-1"},
          {"sub", "42"},
          {"exp", kNow_s + 300},
          {"iat", kNow_s - 1},
          {"nonce", "once"},
          {"name", "Ada Lovelace"},
          {kTool + "version", "1.3.0"},
          {kTool + "message_type", "LtiResourceLinkRequest"},
          {kTool + "deployment_id", "7"},
          {kTool + "target_link_uri", "https://soar.example/lti/launch?lesson=03-impasses"},
          {kTool + "resource_link", {{"id", "link-1"}}},
          {kTool + "roles", {"http://purl.imsglobal.org/vocab/lis/v2/membership#Learner"}},
          {kTool + "context", {{"id", "course-9"}, {"title", "Soar for\nbeginners"}}},
          {kTool + "custom", {{"lesson", "02-operators"}}},
          {"https://purl.imsglobal.org/spec/lti-ags/claim/endpoint",
           {{"scope", {"https://purl.imsglobal.org/spec/lti-ags/scope/score"}},
            {"lineitem", "https://moodle.example/items/5?type=2"}}}};
}

Result<Launch> Read(const Json& claims) {
  return ReadLaunch(claims.dump(), kMoodle, "once", kNow_s);
}

TEST(Launch, AGoodTokenSaysWhoOpensWhat) {
  const Result<Launch> launch = Read(Claims());
  ASSERT_TRUE(launch) << launch.error().message;
  EXPECT_EQ(launch->subject + launch->name + launch->course, "42Ada Lovelacecourse-9");
  EXPECT_EQ(launch->course_title, "Soar for beginners");
  EXPECT_EQ(launch->lesson, "02-operators");
  EXPECT_EQ(launch->line_item, "https://moodle.example/items/5?type=2");
  EXPECT_FALSE(launch->is_teacher || launch->chooses);
}

TEST(Launch, EachWrongClaimIsRefusedByItsName) {
  const auto refused = [](const std::string& field, const Json& value) {
    Json claims = Claims();
    value.is_discarded() ? void(claims.erase(field)) : void(claims[field] = value);
    const Result<Launch> launch = Read(claims);
    return launch ? std::string("accepted") : launch.error().message;
  };
  const Json none = Json::parse("", nullptr, false);
  const auto expect = [&](const std::string& field, const Json& value, const char* words) {
    EXPECT_NE(refused(field, value).find(words), std::string::npos) << field << ": " << refused(field, value);
  };
  expect("iss", "https://moodle.example/", "another platform");
  expect("iss", none, "another platform");
  expect("aud", "client-2", "another tool");
  expect("aud", Json::array(), "another tool");
  expect("aud", {"client-1", "client-2"}, "several tools");
  expect("azp", "client-2", "several tools");
  expect("exp", kNow_s - 61, "expired");
  expect("exp", none, "begins and ends");
  expect("exp", "tomorrow", "begins and ends");
  expect("exp", 1e300, "begins and ends");
  expect("iat", kNow_s + 61, "future");
  expect("iat", kNow_s - 3601, "too old");
  expect("nonce", "twice", "question");
  expect("nonce", none, "question");
  expect(kTool + "version", "1.1", "LTI 1.3");
  expect(kTool + "deployment_id", "8", "deployment '8'");
  expect(kTool + "deployment_id", 7, "deployment");
  expect(kTool + "deployment_id", none, "deployment");
  expect("sub", "", "who you are");
  expect("sub", std::string(256, 'x'), "who you are");
  expect(kTool + "message_type", "LtiSubmissionReviewRequest", "kind of message");
  expect(kTool + "resource_link", Json::object(), "which link");
  expect(kTool + "context", {{"id", std::string(256, 'x')}}, "longer than 255");
}

TEST(Launch, SeveralAudiencesNeedAnAuthorizedParty) {
  Json claims = Claims();
  claims["aud"] = {"client-2", "client-1"};
  claims["azp"] = "client-1";
  EXPECT_TRUE(Read(claims));
}

TEST(Launch, OnlyRolesOfTheCourseTeach) {
  const auto teaches = [](const char* role) {
    Json claims = Claims();
    claims[kTool + "roles"] = {"http://purl.imsglobal.org/vocab/lis/v2/membership#Learner", role, 5};
    return Read(claims)->is_teacher;
  };
  EXPECT_TRUE(teaches("http://purl.imsglobal.org/vocab/lis/v2/membership#Instructor"));
  EXPECT_TRUE(teaches("http://purl.imsglobal.org/vocab/lis/v2/membership/Instructor#TeachingAssistant"));
  EXPECT_TRUE(teaches("Instructor"));
  EXPECT_FALSE(teaches("http://purl.imsglobal.org/vocab/lis/v2/institution/person#Instructor"));
  EXPECT_FALSE(teaches("http://purl.imsglobal.org/vocab/lis/v2/membership#Mentor"));
}

TEST(Launch, OptionalClaimsOfWrongTypesAreAsIfTheyWereNotThere) {
  Json claims = Claims();
  for (const char* const field : {"name", "given_name"}) claims[field] = Json::array({1});
  for (const char* const field : {"roles", "custom", "context", "target_link_uri"}) claims[kTool + field] = 7;
  claims["https://purl.imsglobal.org/spec/lti-ags/claim/endpoint"] = {{"scope", "all"}, {"lineitem", 5}};
  const Result<Launch> launch = Read(claims);
  ASSERT_TRUE(launch);
  EXPECT_EQ(launch->name + launch->course + launch->lesson + launch->line_item, "");
  EXPECT_FALSE(launch->is_teacher);
}

TEST(Launch, ScoresGoNowhereWithoutTheRightToSendThemOrOverAnOpenNetwork) {
  Json claims = Claims();
  Json& service = claims["https://purl.imsglobal.org/spec/lti-ags/claim/endpoint"];
  service["scope"] = {"https://purl.imsglobal.org/spec/lti-ags/scope/result.readonly"};
  EXPECT_EQ(Read(claims)->line_item, "");
  service["scope"] = {"https://purl.imsglobal.org/spec/lti-ags/scope/score"};
  service["lineitem"] = "http://moodle.example/items/5";
  EXPECT_EQ(Read(claims)->line_item, "");
}

TEST(Launch, ATeacherCanBeAskedToChooseALesson) {
  Json claims = Claims();
  claims[kTool + "message_type"] = "LtiDeepLinkingRequest";
  claims["https://purl.imsglobal.org/spec/lti-dl/claim/deep_linking_settings"] = {
      {"deep_link_return_url", "https://moodle.example/return"},
      {"accept_types", {"link", "ltiResourceLink"}},
      {"accept_multiple", true},
      {"data", "opaque"}};
  const Result<Launch> launch = Read(claims);
  ASSERT_TRUE(launch) << launch.error().message;
  EXPECT_TRUE(launch->chooses && launch->may_choose_many);
  EXPECT_EQ(launch->return_url + launch->data, "https://moodle.example/returnopaque");
  claims["https://purl.imsglobal.org/spec/lti-dl/claim/deep_linking_settings"]["deep_link_return_url"] =
      "javascript:alert(1)";
  EXPECT_FALSE(Read(claims));
}

TEST(Jwt, WhatIsNoTokenIsRefused) {
  const std::string object = ToBase64Url("{}"), list = ToBase64Url("[]");
  for (const std::string& odd :
       {std::string(), std::string("."), std::string(".."), object + "." + object, object + "." + object + ".AA.AA",
        list + "." + object + ".AA", object + "." + list + ".AA", "e30=." + object + ".AA",
        object + "." + object + ".A", ToBase64Url("{\"crit\":[\"x\"]}") + "." + object + ".AA",
        ToBase64Url("{\"a\":\"\xff\"}") + "." + object + ".AA", std::string(100'000, 'A')}) {
    const Result<Jwt> token = ReadJwt(odd);
    EXPECT_FALSE(token) << odd.substr(0, 50);
    if (!token) EXPECT_FALSE(token.error().message.empty());
  }
  const Result<Jwt> token = ReadJwt(UnsignedJwt("key-1", "{\"a\":1}") + ".AQI");
  ASSERT_TRUE(token);
  EXPECT_EQ(token->algorithm + token->key_id + token->claims + token->signature, "RS256key-1{\"a\":1}\x01\x02");
  EXPECT_TRUE(ReadJwt(ToBase64Url("{\"alg\":5}") + "." + object + ".")) << "its algorithm is empty, and fits none";
}

TEST(KeySet, KeysOfOtherKindsAreLeftOut) {
  const Result<std::vector<WebKey>> keys = ReadKeySet(
      R"({"keys":[{"kty":"EC","kid":"a"},{"kty":"RSA","kid":"b","n":"AQAB","e":"Aw","use":"enc"},{"kty":"RSA","kid":"c","n":"!","e":"Aw"},5,)"
      R"({"kty":"RSA","alg":"RS512","n":"AQAB","e":"Aw"},{"kty":"RSA","kid":"d","n":"AQAB","e":"Aw","use":"sig","alg":"RS256"}]})");
  ASSERT_TRUE(keys);
  ASSERT_EQ(keys->size(), 1u);
  EXPECT_EQ(keys->front().id + keys->front().exponent, "d\x03");
  for (const char* const odd : {"", "[]", "{}", "{\"keys\":5}"}) EXPECT_FALSE(ReadKeySet(odd)) << odd;
}

class PlatformFiles : public testing::Test {
 protected:
  void SetUp() override { file_ = testing::TempDir() + "platforms_" + std::to_string(getpid()) + ".json"; }
  void TearDown() override { std::filesystem::remove(file_); }
  Result<PlatformFile> Read(const std::string& text) {
    std::ofstream(file_) << text;
    return ReadPlatformFile(file_);
  }
  static Json Good() {
    return {{"url", "https://soar.example/"},
            {"platforms",
             {{{"name", "Moodle"},
               {"issuer", "https://moodle.example"},
               {"client_id", "c"},
               {"auth_url", "https://moodle.example/auth"},
               {"token_url", "https://moodle.example/token"},
               {"jwks_url", "https://moodle.example/certs"},
               {"deployments", {"1"}}}}}};
  }
  std::filesystem::path file_;
};

TEST_F(PlatformFiles, AGoodFileIsRead) {
  const Result<PlatformFile> file = Read(Good().dump(2));
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->url, "https://soar.example");
  EXPECT_EQ(file->platforms[0].audience, "https://moodle.example/token");
  EXPECT_NE(file->Find("https://moodle.example", ""), nullptr);
  EXPECT_EQ(file->Find("https://moodle.example", "d"), nullptr);
}

TEST_F(PlatformFiles, TwoRegistrationsOfOnePlatformDifferByTheirClientIds) {
  Json json = Good();
  json["platforms"].push_back(json["platforms"][0]);
  EXPECT_NE(Read(json.dump()).error().message.find("platform 2 has the issuer"), std::string::npos);
  json["platforms"][1]["client_id"] = "d";
  const Result<PlatformFile> file = Read(json.dump());
  ASSERT_TRUE(file);
  EXPECT_EQ(file->Find("https://moodle.example", ""), nullptr) << "which of both is not known";
  EXPECT_EQ(file->Find("https://moodle.example", "d")->client_id, "d");
}

TEST_F(PlatformFiles, MistakesAreNamedWithTheirPlace) {
  const auto told = [&](const Json& json) {
    const Result<PlatformFile> file = Read(json.dump());
    return file ? std::string("accepted") : file.error().message;
  };
  Json json = Good();
  json["platforms"][0].erase("jwks_url");
  EXPECT_EQ(told(json), "platform 1 needs the field 'jwks_url'");
  json = Good();
  json["platforms"][0]["token_url"] = "http://moodle.example/token";
  EXPECT_NE(told(json).find("platform 1 needs https:// for 'token_url'"), std::string::npos) << told(json);
  json = Good();
  json["platforms"][0]["deployments"] = {1};
  EXPECT_NE(told(json).find("write numbers as \"1\""), std::string::npos);
  json = Good();
  json["platforms"][0]["key"] = "x";
  EXPECT_EQ(told(json), "platform 1 has the unknown field 'key'");
  json = Good();
  json["url"] = "https://soar.example/soarbox";
  EXPECT_NE(told(json).find("without a path"), std::string::npos);
  EXPECT_NE(told({{"url", "https://a.example"}, {"platforms", Json::array()}}).find("1 to 100 platforms"),
            std::string::npos);
  const Result<PlatformFile> broken = Read("{\n\"url\":\n}");
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().line, 3);
}

}  // namespace
}  // namespace soarbox::lti
