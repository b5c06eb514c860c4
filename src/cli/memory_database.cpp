// SPDX-License-Identifier: BSD-2-Clause
#include "cli/memory_database.h"

#include <algorithm>

#include "cli/interpreter.h"
#include "cli/session.h"

namespace soarbox::cli {

Database DatabaseOf(CommandCall& call, const LongTermMemory& memory) {
  const SettingStore& store = call.session.settings();
  Database database;
  database.path = store.Get(memory.group, "path");
  database.is_file = store.Get(memory.group, "database") == "file" && database.path != ":memory:";
  if (!database.path.empty()) database.path = call.interpreter.Resolve(database.path).string();
  database.options.overwrite = !store.IsOn(memory.group, "append");
  database.options.survive_power = store.Get(memory.group, "optimization") == "safety";
  return database;
}

bool FailWith(CommandCall& call, const Diagnostic& problem) {
  return call.Fail(problem.hint.empty() ? problem.message : problem.message + ": " + problem.hint);
}

bool MayTake(CommandCall& call, std::string_view setting, const std::string& value) {
  if (setting == "path" && value != ":memory:") {
    std::filesystem::path path;
    return call.interpreter.ResolveForWriting(call, value, path);
  }
  if (setting == "database" && value == "file" && call.interpreter.fence() != nullptr) {
    return call.Fail("The files of a scenario may not write files: the database stays in memory.");
  }
  return true;
}

bool Store(CommandCall& call, const LongTermMemory& memory, const std::string& setting, const std::string& value,
           bool is_open, std::span<const std::string_view> closed_only) {
  SettingStore& store = call.session.settings();
  const std::string before = store.Get(memory.group, setting);
  switch (store.Set(memory.group, setting, value)) {
    case SettingStore::SetResult::kUnknown:
      return call.Fail(fmt::format("Invalid {} parameter.", memory.title));
    case SettingStore::SetResult::kInvalid:
      return call.Fail(fmt::format("Invalid setting for {} parameter.", memory.title));
    case SettingStore::SetResult::kOk:
      break;
  }
  if (!is_open || std::ranges::find(closed_only, setting) == closed_only.end()) return true;
  store.Set(memory.group, setting, before);
  return call.Fail(fmt::format("This parameter is protected while the {} memory database is open.", memory.adjective));
}

void WarnOfAppend(CommandCall& call, const LongTermMemory& memory) {
  call.Out(
      fmt::format("Warning: Since append mode is off, starting/reinitializing,\n"
                  "         Soar will erase the {} memory database.\n\n",
                  memory.adjective));
}

}  // namespace soarbox::cli
