// SPDX-License-Identifier: BSD-2-Clause
#include "record/byte_difference.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace soarbox::record {
namespace {

/// Number of equal bytes of two texts from a position on.
std::size_t EqualRun(std::string_view a, std::string_view b, std::size_t from) {
  const std::size_t end = std::min(a.size(), b.size());
  std::size_t at = from;
  while (end >= 8 && at <= end - 8) {
    std::uint64_t x, y;
    std::memcpy(&x, a.data() + at, sizeof x);
    std::memcpy(&y, b.data() + at, sizeof y);
    if (x != y) {
      if constexpr (std::endian::native == std::endian::little)
        return at - from + static_cast<std::size_t>(std::countr_zero(x ^ y)) / 8;
      break;
    }
    at += 8;
  }
  while (at < end && a[at] == b[at]) ++at;
  return at > from ? at - from : 0;
}

}  // namespace

void WriteDifference(BufferedWriter& out, std::string_view before, std::string_view now) {
  constexpr std::size_t kWorth = 3;  // Shorter runs of equal bytes are stored as new bytes.
  out.Number(before.size() == now.size() ? 0 : now.size());
  for (std::size_t at = 0; at < now.size();) {
    const std::size_t same = EqualRun(before, now, at);
    out.Number(same);
    at += same;
    if (at == now.size()) return;
    std::size_t end = at + 1, equal = 0;
    for (; end < now.size() && equal < kWorth; ++end)
      equal = end < before.size() && before[end] == now[end] ? equal + 1 : 0;
    end -= equal;
    out.Text(now.substr(at, end - at));
    at = end;
  }
}

void ReadDifference(ByteReader& in, std::string_view before, std::string& now) {
  const std::uint64_t given = in.Number();
  const std::uint64_t size = given == 0 ? before.size() : given;
  in.Charge(size);
  for (std::uint64_t at = 0; at < size && !in.failed();) {
    const std::uint64_t same = in.Number();
    if (same > size - at || (same > 0 && (at >= before.size() || same > before.size() - at))) return in.Fail();
    if (same > 0) now.append(before.substr(static_cast<std::size_t>(at), static_cast<std::size_t>(same)));
    at += same;
    if (at == size) return;
    const std::string_view fresh = in.Text();
    if (fresh.empty() || fresh.size() > size - at) return in.Fail();
    now.append(fresh);
    at += fresh.size();
  }
}

}  // namespace soarbox::record
