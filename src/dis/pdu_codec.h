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

/// Why a datagram is not a PDU that Soarbox uses.
enum class Refusal : std::uint8_t {
  kTooShort,     ///< Shorter than its header specifies.
  kVersion,      ///< Neither version 6 nor 7.
  kOtherKind,    ///< A kind of PDU that Soarbox does not use.
  kBadLength,    ///< Shorter than its kind requires.
  kBadContents,  ///< Numbers that are too large or not finite, or counts that do not match.
};
/// "too short", "another version", ...
std::string_view Name(Refusal refusal);

/// Encodes a PDU in network byte order, with the layout of IEEE 1278.1.
std::vector<std::byte> Encode(Pdu pdu);
/// Decodes one PDU at the beginning of a datagram. Ignores the bytes after it: `LengthOf` returns where the next one
/// begins.
std::variant<Pdu, Refusal> Decode(std::span<const std::byte> bytes);
/// The length in the header at the beginning; 0 if the header or the PDU is incomplete.
std::size_t LengthOf(std::span<const std::byte> bytes);

}  // namespace soarbox::dis
