// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary bytes to the readers of data from learning platforms and from browsers that a platform sends:
// tokens, claims, key sets, forms and addresses. An accepted token must begin with its signed part. Written data must
// be read again with the same contents.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "bytes/base64.h"
#include "serve/lti/jwt.h"
#include "serve/lti/launch.h"
#include "serve/lti/web_address.h"

using namespace soarbox;

namespace {

void Require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  static const lti::Platform kPlatform = {"p", "https://p.example", "c", {}, {}, {}, {}, {"1"}};
  constexpr std::int64_t kNow_s = 1'800'000'000;

  if (const Result<lti::Jwt> token = lti::ReadJwt(text)) {
    Require(text.starts_with(token->signed_part + "."));
    (void)lti::ReadLaunch(token->claims, kPlatform, "n", kNow_s);
  } else {
    Require(!token.error().message.empty());
  }
  if (const Result<lti::Launch> launch = lti::ReadLaunch(std::string(text), kPlatform, "n", kNow_s)) {
    Require(!launch->subject.empty() && launch->deployment == "1");
    Require(launch->line_item.empty() || lti::IsPrivate(*lti::ReadWebAddress(launch->line_item)));
  }
  if (const auto keys = lti::ReadKeySet(text)) Require(keys->size() <= 100);
  if (const auto bytes = FromBase64Url(text)) Require(ToBase64Url(*bytes) == text);
  Require(FromBase64Url(ToBase64Url(text)) == text);
  Require(lti::ReadForm(lti::WriteForm(lti::ReadForm(text))) == lti::ReadForm(text));
  if (const auto address = lti::ReadWebAddress(text))
    Require(lti::ReadWebAddress(address->origin() + address->path).has_value());
  Require(lti::HtmlText(text).find_first_of("<>\"'") == std::string::npos);
  return 0;
}
