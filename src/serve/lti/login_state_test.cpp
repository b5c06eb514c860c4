// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/login_state.h"

#include <gtest/gtest.h>

namespace soarbox::lti {
namespace {

const LoginState kLogin = {"abcdefghijkl", "nonce", "https://moodle.example", "client", 1000};

TEST(LoginState, ItComesBackOnlyWithTheSecretAndInTime) {
  const std::string text = WriteLoginState(kLogin, "secret");
  const auto read = ReadLoginState(text, "secret", 1000);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->id + read->nonce + read->issuer + read->client_id, "abcdefghijklnoncehttps://moodle.exampleclient");
  EXPECT_FALSE(ReadLoginState(text, "secret", 1001));
  EXPECT_FALSE(ReadLoginState(text, "Secret", 1000));
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string changed = text;
    changed[i] = changed[i] == 'A' ? 'B' : 'A';
    EXPECT_FALSE(ReadLoginState(changed, "secret", 1000)) << i;
    EXPECT_FALSE(ReadLoginState(text.substr(0, i), "secret", 1000)) << i;
  }
}

TEST(LoginState, TheCookieBelongsToOneLogin) {
  const std::string cookie = CookieOf(kLogin).substr(0, CookieOf(kLogin).find(';'));
  EXPECT_TRUE(HasCookieOf(kLogin, cookie));
  EXPECT_TRUE(HasCookieOf(kLogin, "a=b; " + cookie + ";c=d"));
  LoginState other = kLogin;
  other.id = "abcdefghXXXX";
  EXPECT_FALSE(HasCookieOf(other, cookie));
  EXPECT_FALSE(HasCookieOf(kLogin, ""));
  EXPECT_FALSE(HasCookieOf(kLogin, ";;= ;soarbox-lti-abcdefgh="));
}

}  // namespace
}  // namespace soarbox::lti
