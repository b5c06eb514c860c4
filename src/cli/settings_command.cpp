// SPDX-License-Identifier: BSD-2-Clause
#include "cli/settings_command.h"

#include <fmt/format.h>

#include "cli/session.h"
#include "cli/setting_store.h"

namespace soarbox::cli {

bool NamedSetting(CommandCall& call, std::string_view group, std::string_view unknown, std::string_view invalid) {
  const SettingInfo* info = SettingStore::Find(group, call.words[1].text, true);
  if (!info || info->name == "mode") return call.Fail(unknown);
  SettingStore& store = call.session.settings();
  if (call.words.size() == 2) {
    call.Out(fmt::format("{} is {}\n", info->name, store.Get(group, info->name)));
    return true;
  }
  if (call.words.size() > 3) return call.Fail(invalid);
  const std::string& value = call.words[2].text;
  if (store.Set(group, info->name, value) != SettingStore::SetResult::kOk) return call.Fail(invalid);
  call.Out(fmt::format("{} is now {}\n", info->name, value));
  return true;
}

}  // namespace soarbox::cli
