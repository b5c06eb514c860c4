// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/web_address.h"

#include <gtest/gtest.h>

namespace soarbox::lti {
namespace {

#include "bytes/base64.h"
TEST(WebAddress, AnAddressHasHostPortAndPath) {
  const auto plain = ReadWebAddress("https://school.example"), full = ReadWebAddress("http://[::1]:8080/lti?a=1#x");
  ASSERT_TRUE(plain && full);
  EXPECT_EQ(plain->port + plain->path + plain->origin(), "443/https://school.example");
  EXPECT_EQ(full->host + " " + full->port + " " + full->path, "::1 8080 /lti?a=1");
  EXPECT_EQ(full->origin(), "http://[::1]:8080");
  EXPECT_EQ(ReadWebAddress("https://a.example?x=1")->path, "/?x=1");
}

TEST(WebAddress, WhatIsNoAddressIsNone) {
  for (const char* const odd : {"", "school.example", "ftp://a", "https://", "https://a b", "https://a\r\nHost: b",
                                "https://u:p@a", "https://a:", "https://a:123456", "https://[::1", "https://[::1]x",
                                "https://a\"b", "https://a:8x", "javascript:alert(1)", "https://\xc3\xa4"})
    EXPECT_FALSE(ReadWebAddress(odd)) << odd;
}

TEST(WebAddress, OnlyHttpsAndThisMachineArePrivate) {
  EXPECT_TRUE(IsPrivate(*ReadWebAddress("https://a.example")));
  EXPECT_TRUE(IsPrivate(*ReadWebAddress("http://127.0.0.1:80/x")));
  EXPECT_FALSE(IsPrivate(*ReadWebAddress("http://a.example")));
  EXPECT_FALSE(IsPrivate(*ReadWebAddress("http://localhost.a.example")));
}

TEST(WebAddress, FormsAreReadAndWritten) {
  const FormFields fields = ReadForm("a=1+2&b=%C3%A4%zz&&c&=d&a=3");
  EXPECT_EQ(FieldOf(fields, "a"), "1 2");
  EXPECT_EQ(FieldOf(fields, "b"), "\xc3\xa4%zz");
  EXPECT_EQ(FieldOf(fields, "c") + FieldOf(fields, "none"), "");
  const FormFields odd = {{"a b", "&=+%\n\xff"}, {"c", ""}};
  EXPECT_EQ(ReadForm(WriteForm(odd)), odd);
  EXPECT_EQ(HtmlText("<a href=\"x\">'&"), "&lt;a href=&quot;x&quot;&gt;&#39;&amp;");
}

TEST(Base64Url, BytesComeBackAndOddTextsAreRefused) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) {
    EXPECT_EQ(FromBase64Url(ToBase64Url(bytes)), bytes);
    bytes += static_cast<char>(i * 7);
  }
  EXPECT_EQ(ToBase64Url("\xfb\xff\xfe"), "-__-");
  for (const char* const odd : {"A", "AB=", "AB==", "A B", "+/+/", "AB", "AAB", "AAAAA"})
    EXPECT_FALSE(FromBase64Url(odd)) << odd;
  EXPECT_EQ(ToBase64("\xfb\xff\xfe!"), "+//+IQ==");
  for (const char* const text : {"+//+IQ==", "+//+IQ"}) EXPECT_EQ(FromBase64(text), "\xfb\xff\xfe!");
  for (const char* const odd : {"-__-", "+//+IQ===", "=", "A==="}) EXPECT_FALSE(FromBase64(odd)) << odd;
}

}  // namespace
}  // namespace soarbox::lti
