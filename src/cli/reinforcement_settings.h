// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "cli/setting_store.h"
#include "kernel/learn/rl_settings.h"

namespace soarbox::cli {

/// The outcome of `rl --set NAME VALUE`. kLocked: the setting cannot change while `apoptosis` is on.
enum class RlSetResult { kOk, kUnknown, kInvalid, kLocked };

/// Stores a value as Soar reads it: the number at the start of the text, or 0 if there is none; `apoptosis-thresh`
/// takes the threshold without its sign.
RlSetResult SetReinforcement(SettingStore& store, const std::string& name, const std::string& value);

/// The settings of the store in the kernel's form.
kernel::RlSettings ReinforcementSettings(const SettingStore& store);

}  // namespace soarbox::cli
