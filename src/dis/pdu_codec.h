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

/// Why a datagram is not a PDU that we use.
enum class Refusal : std::uint8_t {
  kTooShort,     ///< Shorter than its header says.
  kVersion,      ///< Neither version 6 nor 7.
  kOtherKind,    ///< A kind of PDU that Soarbox does not use.
  kBadLength,    ///< Shorter than its kind requires.
  kBadContents,  ///< Numbers that are not finite, counts that do not fit.
};
/// "too short", "another version", ...
std::string_view Name(Refusal refusal);

/// The bytes of a PDU, in network order, as IEEE 1278.1 lays them out.
std::vector<std::byte> Encode(const Pdu& pdu);
/// Reads one PDU from the front of a datagram. Ignores what follows: `LengthOf` says where the next one begins.
std::variant<Pdu, Refusal> Decode(std::span<const std::byte> bytes);
/// The length in the header at the front; 0 if the header or the PDU is incomplete.
std::size_t LengthOf(std::span<const std::byte> bytes);

}  // namespace soarbox::dis
