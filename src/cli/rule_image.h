// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "kernel/base/symbol_table.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {
class Agent;
}

/// Images of an agent's rules (`save rete-network`, `load rete-network`, files named .soarx).
///
/// An image contains the rules after parsing, checking and ordering, in the order of loading. Loading an image
/// therefore skips the work on the text. The match network is built again, with the same nodes in the same order.
///
/// Layout (numbers without a size are varints: seven bits per byte, lowest first):
///
///     magic       16 bytes: "Soarbox rules\r\n" and 0x1A
///     version     4 bytes, lowest first: 1
///     length      8 bytes: of the payload
///     checksum    8 bytes: FNV-1a of the payload
///     payload     symbols: count, then kind and contents of each: constants in order of age, then variables;
///                 files: count, then their names; rules: count, then each (see rule_image_write.cpp)
///
/// Derived data, such as where variables are bound and which functions the names refer to, are not stored but
/// recomputed.
namespace soarbox::cli {

namespace rule_image {

inline constexpr std::string_view kMagic("Soarbox rules\r\n\x1a", 16);
inline constexpr std::uint32_t kVersion = 1;
inline constexpr std::size_t kHeaderSize = 16 + 4 + 8 + 8;

enum class SymbolCode : std::uint8_t { kVariable, kString, kInteger, kFloat, kLast = kFloat };
enum class ValueCode : std::uint8_t { kSymbol, kFunction, kLast = kFunction };

/// FNV-1a, 64 bits: detects damage, not intent.
std::uint64_t Checksum(std::string_view bytes);

}  // namespace rule_image

/// The image of all rules except justifications, which exist only at one moment of a run.
std::string WriteRuleImage(const kernel::Agent& agent);

/// Reads the rules of an image, with symbols of this table. The content is not trusted: either every rule is one that
/// the rule parser could have produced, or the error says what is wrong and at which byte. `name` is the name of the
/// file, for messages. The table changes only if the image is valid.
Result<std::vector<kernel::ProductionPtr>> ReadRuleImage(std::string_view bytes, const std::string& name,
                                                         kernel::SymbolTable& symbols);

}  // namespace soarbox::cli
