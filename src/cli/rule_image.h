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
/// An image holds the rules as the reader left them: parsed, checked and put in match order, in the order in which they
/// were loaded. So loading an image skips the work on the text. The match network is built again, which gives the same
/// nodes in the same order.
///
/// Layout (numbers without a size are varints: seven bits per byte, lowest first):
///
///     magic       16 bytes: "Soarbox rules\r\n" and 0x1A
///     version     4 bytes, lowest first: 1
///     length      8 bytes: of the payload
///     checksum    8 bytes: FNV-1a of the payload
///     payload     symbols: count, then kind and contents of each, in the order in which they came up;
///                 files: count, then their names; rules: count, then each (see rule_image_write.cpp)
///
/// Derived facts, such as where variables are bound and which functions the names stand for, are not stored but
/// computed again.
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

/// The image of all rules but justifications, which belong to one moment of a run.
std::string WriteRuleImage(const kernel::Agent& agent);

/// The rules of an image, with symbols of this table. The content is not trusted: whatever the bytes are, either every
/// rule is one that the rule reader could have made, or the error says what is wrong and at which byte. `name` is the
/// file's, for messages. Only a good image changes the table.
Result<std::vector<kernel::ProductionPtr>> ReadRuleImage(std::string_view bytes, const std::string& name,
                                                         kernel::SymbolTable& symbols);

}  // namespace soarbox::cli
