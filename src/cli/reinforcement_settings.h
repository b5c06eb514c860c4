// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "cli/setting_store.h"
#include "kernel/learn/rl_settings.h"

namespace soarbox::cli {

/// What became of `rl --set NAME VALUE`.
enum class RlSetResult { kOk, kUnknown, kInvalid, kLocked };

/// Puts a value into the store as Soar reads it: a number may be any text that begins with one, else it is 0;
/// `apoptosis-thresh` takes the threshold without its sign.
RlSetResult SetReinforcement(SettingStore& store, const std::string& name, const std::string& value);

/// The settings of the store as the kernel has them.
kernel::RlSettings ReinforcementSettings(const SettingStore& store);

}  // namespace soarbox::cli
