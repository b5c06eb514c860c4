// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "dis/pdu.h"

namespace soarbox::dis {

/// Why a datagram is no PDU that we use.
enum class Refusal : std::uint8_t {
  kTooShort,     ///< It ends before the PDU that its header promises.
  kVersion,      ///< Neither version 6 nor 7.
  kOtherKind,    ///< A kind of PDU that Soarbox has no use for.
  kBadLength,    ///< Shorter than its kind is.
  kBadContents,  ///< Numbers that are not finite, counts that do not fit.
};
/// "too short", "another version", ...
std::string_view Name(Refusal refusal);

/// The bytes of a PDU, in network order, as IEEE 1278.1 lays them out.
std::vector<std::byte> Encode(const Pdu& pdu);
/// Reads one PDU from the front of a datagram. What follows it is not looked at: `LengthOf` tells where the next
/// begins.
std::variant<Pdu, Refusal> Decode(std::span<const std::byte> bytes);
/// The length that the header at the front promises; 0 if there is no whole header or no whole PDU.
std::size_t LengthOf(std::span<const std::byte> bytes);

}  // namespace soarbox::dis
