// SPDX-License-Identifier: BSD-2-Clause
#include "world/navigation.h"

#include <algorithm>
#include <future>
#include <memory>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>

#include "diagnostics/problem.h"
#include "world/navigation_build.h"
#include "world/overlay_snapshot.h"
#include "world/state_hash.h"

namespace soarbox::world {
namespace {

constexpr Color kFill{0, 1, 1, 32.0f / 255};
constexpr Color kEdge{0, 0.5f, 0.5f, 1};
/// Drawn above the mesh, so that floors do not cover it.
constexpr Vec3 kDrawnLift_m{0, 0.02f, 0};

std::string Quoted(std::string_view name) {
  return "\"" + std::string(name) + "\"";
}

/// Adds a mesh to the triangles and lines of a snapshot.
void AddMesh(const NavigationMesh& mesh, auto& out) {
  for (const auto& [a, b, c] : mesh.triangles()) {
    out.triangles.push_back({a + kDrawnLift_m, b + kDrawnLift_m, c + kDrawnLift_m, kFill});
    out.lines.push_back({a + kDrawnLift_m, b + kDrawnLift_m, kEdge});
    out.lines.push_back({b + kDrawnLift_m, c + kDrawnLift_m, kEdge});
    out.lines.push_back({c + kDrawnLift_m, a + kDrawnLift_m, kEdge});
  }
}

/// Joins its thread when it is destroyed.
struct Builder {
  ~Builder() {
    if (thread.joinable()) thread.join();
  }
  std::thread thread;
};

/// Runs `build` on another thread. If no thread can be started, it runs when the result is asked for. A single call of
/// std::async would do the same, but libc++ waits without end after it failed to start a thread (WebAssembly).
template <typename Build>
std::future<std::invoke_result_t<Build>> StartBuild(const Build& build) {
  std::packaged_task<std::invoke_result_t<Build>()> task(build);
  auto built = task.get_future();
  auto builder = std::make_unique<Builder>();
  try {
    builder->thread = std::thread(std::move(task));
  } catch (const std::system_error&) {
    return std::async(std::launch::deferred, build);
  }
  return std::async(std::launch::deferred,
                    [builder = std::move(builder), built = std::move(built)]() mutable { return built.get(); });
}

}  // namespace

Navigation::Navigation() = default;
Navigation::~Navigation() = default;

Result<bool> Navigation::Create(std::string_view name, NavigationGeometry geometry, const NavigationConfig& config) {
  if (Result<void> checked = NavigationMesh::Check(geometry, config); !checked.ok()) return checked.error();
  if (entries_.size() >= kMaxMeshes && !entries_.contains(name)) {
    return NewProblem("there are " + std::to_string(kMaxMeshes) + " navigation meshes already",
                      "use a name again: the new mesh replaces the old one");
  }
  // Only one build runs at a time, because several would slow each other down.
  for (auto& [other, entry] : entries_) Finish(entry);
  Vec3 min, max;
  geometry.Bounds(min, max);
  const float farthest = std::max({-min.x, -min.y, -min.z, max.x, max.y, max.z});
  Entry& entry = entries_[std::string(name)];
  entry = Entry();
  entry.source_hash = SourceHash(geometry, config);
  const auto build = [geometry = std::make_shared<const NavigationGeometry>(std::move(geometry)), config] {
    return NavigationMesh::Build(*geometry, config);
  };
  entry.building = StartBuild(build);
  return farthest > NavigationMesh::kHalfExtent_m;
}

void Navigation::Finish(Entry& entry) {
  if (!entry.building.valid()) return;
  Outcome outcome = entry.building.get();
  if (outcome.ok()) {
    entry.mesh = std::move(outcome.value());
  } else {
    entry.fault = outcome.error();
  }
}

Result<const NavigationMesh*> Navigation::Find(std::string_view name) {
  const auto found = entries_.find(name);
  if (found == entries_.end()) {
    Diagnostic fault;
    fault.message = "there is no navigation mesh " + Quoted(name);
    const std::string_view meant = Suggest(name, Names());
    fault.hint = meant.empty() ? "make one with Sandbox.CreateNavigationMesh" : "did you mean " + Quoted(meant) + "?";
    return fault;
  }
  Entry& entry = found->second;
  Finish(entry);
  if (entry.mesh) return static_cast<const NavigationMesh*>(entry.mesh.get());
  Diagnostic fault = entry.fault;
  fault.message = "the navigation mesh " + Quoted(name) + " could not be made: " + fault.message;
  return fault;
}

std::vector<std::string_view> Navigation::Names() const {
  std::vector<std::string_view> names;
  for (const auto& [name, entry] : entries_) names.emplace_back(name);
  return names;
}

Result<void> Navigation::Show(std::string_view name, bool show) {
  const Result<const NavigationMesh*> mesh = Find(name);
  if (!mesh.ok()) return mesh.error();
  entries_.find(name)->second.shown = show;
  return {};
}

void Navigation::FillSnapshot(SceneSnapshot& snapshot) const {
  for (const auto& [name, entry] : entries_) {
    if (entry.shown && entry.mesh) AddMesh(*entry.mesh, snapshot);
  }
}

void Navigation::FillOverlay(OverlaySnapshot& overlays) const {
  for (const auto& [name, entry] : entries_) {
    if (!entry.mesh) continue;
    overlays.has_navigation = true;
    AddMesh(*entry.mesh, overlays);
  }
}

std::uint64_t Navigation::Hash() const {
  StateHash hash;
  for (const auto& [name, entry] : entries_) {
    hash.Add(std::string_view(name));
    hash.Add(entry.source_hash);
  }
  return hash.value();
}

}  // namespace soarbox::world
