// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string_view>

namespace soarbox::kernel {

/// The version of Soar that an agent imitates (`soar like`). It matters only for differences between versions that
/// rules can observe. docs/spec/soar_9_6_5.md lists them.
enum class SoarVersion : std::uint8_t { k963, k965 };

constexpr std::string_view TextOf(SoarVersion version) {
  return version == SoarVersion::k963 ? "9.6.3" : "9.6.5";
}

}  // namespace soarbox::kernel
