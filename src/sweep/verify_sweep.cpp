// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/verify_sweep.h"

#include <cstdio>
#include <map>

#include "diagnostics/problem.h"
#include "mission/child_pool.h"
#include "record/header.h"
#include "sweep/one_run.h"
#include "sweep/run_sweep.h"

namespace soarbox::sweep {
namespace {

namespace fs = std::filesystem;

std::string HashText(std::uint64_t hash) {
  char text[20];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

/// The difference between a row and a repeated run; empty if they are equal.
std::string DifferenceOf(const Spec& spec, const Row& row, const Row& again) {
  if (again.result.outcome != "ok") return "it " + again.result.outcome + " now: " + again.result.error;
  if (row.result.state_hash != again.result.state_hash)
    return "its state is " + HashText(again.result.state_hash) + " now, and " + HashText(row.result.state_hash) +
           " in its row (made on " + row.host + ")";
  for (std::size_t i = 0; i < spec.metrics.size() && i < row.metrics.size() && i < again.metrics.size(); ++i)
    if (row.metrics[i] != again.metrics[i]) return "'" + spec.metrics[i].name + "' differs";
  return row.result.passed == again.result.passed ? std::string() : "'passed' differs";
}

/// At most `most` rows, distributed evenly.
std::vector<Row> SampleOf(const std::vector<Row>& rows, std::size_t most) {
  if (most == 0 || most >= rows.size()) return rows;
  std::vector<Row> sample;
  for (std::size_t i = 0; i < most; ++i) sample.push_back(rows[i * rows.size() / most]);
  return sample;
}

}  // namespace

Result<Verification> VerifySweep(const fs::path& folder, const sim::DataFolders& data, std::size_t most, int jobs,
                                 const std::function<bool()>& goes_on) {
  std::vector<Diagnostic> problems;
  std::error_code error;
  if (!fs::exists(KeptSpec(folder), error))
    return ProblemIn(folder.string(),
                     "this is not a folder of a sweep: it holds no " + KeptSpec(folder).filename().string(),
                     "soarbox sweep SPEC makes one: SPEC.sweep");
  const Spec spec = ReadSpec(KeptSpec(folder), problems, true);
  if (!problems.empty()) return problems.front();
  const Result<Plan> plan = MakePlan(spec, folder, data, Sources::kTrust);
  if (!plan) return plan.error();
  std::vector<Row> rows = RowsOf(spec, *plan, folder, problems);
  Verification found;
  found.unmatched = ReadRows(folder / "parts", problems).size() - rows.size();
  std::erase_if(rows, [&](const Row& row) {
    return row.result.outcome != "ok" || !plan->variants[row.variant].variant.kernel.empty();
  });
  if (rows.empty())
    return ProblemIn(folder.string(), "this sweep has no runs that can be made again",
                     found.unmatched > 0 ? "its " + std::to_string(found.unmatched) +
                                               " rows are of other variants: files in its folder have changed"
                                         : "soarbox sweep makes them");
  found.all = rows.size();
  for (const Row& row : rows)
    if (row.build != record::BuildId()) found.other_build = row.build;
  const std::vector<Row> sample = SampleOf(rows, most);
  const int at_a_time = jobs > 0 ? jobs : mission::Processors();
  mission::ChildPool pool(at_a_time);
  std::map<std::size_t, std::string> differing;
  std::size_t next = 0;
  while ((next < sample.size() || !pool.IsIdle()) && goes_on()) {
    while (next < sample.size() && pool.HasRoom()) {
      const Row& row = sample[next];
      const ReadyVariant& variant = plan->variants[row.variant];
      const Result<void> started = pool.Start(
          next, [&] { return Work(spec, variant, row.seed, {}); }, mission::LimitsOf(variant.loaded, at_a_time));
      if (!started && pool.IsIdle()) return started.error();
      if (!started) break;
      ++next;
    }
    std::optional<mission::ChildPool::Done> done = pool.Wait(0.2);
    if (!done) continue;
    const Row& row = sample[done->id];
    const ReadyVariant& variant = plan->variants[row.variant];
    const Row again =
        RowOf(*plan, row.variant, row.seed, 1, std::move(done->end), mission::LimitsOf(variant.loaded, at_a_time));
    ++found.made;
    if (const std::string difference = DifferenceOf(spec, row, again); !difference.empty())
      differing[done->id] =
          "variant '" + variant.variant.name + "', seed " + std::to_string(row.seed) + ": " + difference;
  }
  for (auto& [index, text] : differing) found.differing.push_back(std::move(text));
  return found;
}

}  // namespace soarbox::sweep
