// SPDX-License-Identifier: BSD-2-Clause
#include "script/script_profiler.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <lua.hpp>

#include "script/lua_function_names.h"
#include "script/lua_machine.h"

namespace soarbox::script {
namespace {

double Now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

void ScriptProfiler::OnCall(LuaMachine& machine, lua_State* state, lua_Debug& frame) {
  lua_Debug info = frame;
  if (lua_getinfo(state, "S", &info) == 0 || *info.what == 'C' || info.source == nullptr) return;
  const double now_s = Now_s();
  begun_.emplace(&machine, calls_.size());
  // Calls that ended by a tail call or an error were not reported.
  EndCalls(state, frame.i_ci, now_s);
  const Function function{info.source[0] == '@' ? info.source + 1 : "text", info.linedefined};
  std::string& name = names_[function];
  if (name.empty()) {
    if (*info.what == 'm') {
      name = "the main chunk";
    } else if (lua_getinfo(state, "n", &info) != 0 && info.name != nullptr) {
      name = info.name;
    } else {
      name = NameOfGlobalFunction(state, frame);
    }
  }
  Totals& totals = totals_[function];
  ++totals.calls;
  ++totals.under_way;
  calls_.push_back({state, frame.i_ci, &totals, now_s, 0});
}

void ScriptProfiler::OnReturn(LuaMachine&, lua_State* state, lua_Debug& frame) {
  EndCalls(state, frame.i_ci, Now_s());
}

void ScriptProfiler::OnEnd(LuaMachine& machine) {
  const auto begun = begun_.find(&machine);
  if (begun == begun_.end()) return;
  const double now_s = Now_s();
  while (calls_.size() > begun->second) EndLast(now_s);
  begun_.erase(begun);
}

void ScriptProfiler::EndCalls(const lua_State* state, int place, double now_s) {
  while (!calls_.empty() && calls_.back().state == state && calls_.back().place >= place) EndLast(now_s);
}

void ScriptProfiler::EndLast(double now_s) {
  const Call call = calls_.back();
  calls_.pop_back();
  const double took_s = now_s - call.began_s;
  call.totals->self_s += took_s - call.inner_s;
  if (--call.totals->under_way == 0) call.totals->total_s += took_s;
  if (!calls_.empty()) calls_.back().inner_s += took_s;
}

std::vector<ScriptProfiler::Row> ScriptProfiler::Rows() const {
  std::vector<Row> rows;
  for (const auto& [function, totals] : totals_)
    rows.push_back({names_.at(function), function.first + ":" + std::to_string(function.second), totals.calls,
                    totals.self_s, totals.total_s});
  std::ranges::sort(rows, {}, [](const Row& row) { return std::pair(row.function, row.place); });
  return rows;
}

std::string ScriptProfiler::Table(std::uint64_t ticks, std::size_t most) const {
  std::vector<Row> rows = Rows();
  std::ranges::stable_sort(rows, std::ranges::greater(), &Row::self_s);
  const auto per_tick = [&](double value) { return value / static_cast<double>(std::max<std::uint64_t>(ticks, 1)); };
  std::string text = "functions of scripts, for each of " + std::to_string(ticks) + " ticks:\n";
  char line[256];
  std::snprintf(line, sizeof line, "%10s  %8s  %8s  %s\n", "calls", "own ms", "all ms", "function");
  text += line;
  for (const Row& row : rows) {
    if (most-- == 0) break;
    std::snprintf(line, sizeof line, "%10.2f  %8.4f  %8.4f  ", per_tick(static_cast<double>(row.calls)),
                  per_tick(row.self_s * 1000), per_tick(row.total_s * 1000));
    text += line + row.function + " (" + row.place + ")\n";
  }
  return text;
}

}  // namespace soarbox::script
