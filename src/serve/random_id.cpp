// SPDX-License-Identifier: BSD-2-Clause
#include "serve/random_id.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

namespace soarbox::serve {
namespace {

constexpr std::string_view kDigits = "0123456789abcdefghjkmnpqrstvwxyz";
constexpr std::size_t kIdLength = 26;

}  // namespace

std::string NewId() {
  std::array<std::uint8_t, kIdLength> bytes{};
  // The system returns so few bytes completely or fails. After a failure no secure id is possible.
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) std::abort();
  std::string id;
  for (const std::uint8_t byte : bytes) id += kDigits[byte % kDigits.size()];
  return id;
}

bool IsId(std::string_view text) {
  return text.size() == kIdLength &&
         std::ranges::all_of(text, [](char c) { return kDigits.find(c) != std::string_view::npos; });
}

bool SameSecret(std::string_view given, std::string_view wanted) {
  unsigned differs = given.size() == wanted.size() ? 0 : 1;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    differs |= static_cast<unsigned char>(wanted[i]) ^
               static_cast<unsigned char>(given.empty() ? '\0' : given[i % given.size()]);
  return differs == 0;
}

}  // namespace soarbox::serve
