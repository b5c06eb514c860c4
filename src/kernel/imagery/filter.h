// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

#include "kernel/base/symbol.h"
#include "kernel/imagery/memory_writer.h"
#include "kernel/imagery/scene.h"
#include "kernel/imagery/tracked_list.h"

namespace soarbox::kernel::imagery {

struct Combination;
struct FilterKind;
struct Trouble;
class PlainRandom;

/// What a filter can give: a number, an answer, a word, a vector, a box or a node.
using Content = std::variant<double, std::int64_t, bool, std::string, Vec3, Box, Node*>;

/// One value that a filter gave.
struct Value : Tracked<Value> {
  Content content;
  Combination* from = nullptr;      ///< What it was computed from; null for constants and the like.
  std::vector<Combination*> users;  ///< Of the filter that reads it.
  bool rewritten = true;            ///< The content changed since it was shown last.
};

/// One input of a filter: a value per parameter, null where it has none.
struct Combination : Tracked<Combination> {
  std::vector<Value*> arguments;
  Value* output = nullptr;  ///< What the filter made of it, if anything.
  double rank = 0;          ///< For filters that choose the best.
};

/// A ^status on an identifier, which changes only when its text does.
class StatusLine {
 public:
  StatusLine(MemoryWriter& writer, Symbol owner);
  /// The identifier; none for filters that rules cannot see.
  Symbol owner() const { return owner_; }
  void Set(std::string_view text);
  Symbol symbol() const { return shown_; }
  const std::string& text() const { return text_; }

 private:
  MemoryWriter& writer_;
  Symbol owner_, shown_;
  std::string text_;
};

class Filter;

/// The parameters of a filter, and their values combined: each with each, the first parameter fastest, or each alone.
/// Only what is new is combined.
class Inputs {
 public:
  struct Parameter {
    std::string name;
    std::unique_ptr<Filter> source;
  };

  Inputs(std::vector<Parameter> parameters, bool each_alone)
      : parameters_(std::move(parameters)), each_alone_(each_alone) {}

  const std::vector<Parameter>& parameters() const { return parameters_; }
  TrackedList<Combination>& combinations() { return combinations_; }
  const TrackedList<Combination>& combinations() const { return combinations_; }
  /// Hears of combinations of which a value changed, before they are computed again.
  std::function<void(Combination&)> on_change;

  /// Brings the parameters up to date. Returns what is wrong, or nothing: if one of them failed, or there are too many
  /// combinations; then none is left.
  std::string_view Update();
  static constexpr std::size_t kMostCombinations = 2'000'000;

 private:
  void Forget();
  void DropUsersOf(Value& gone);
  void NoteChanges(Value& changed);
  void CombineEachWithEach();
  void Add(std::vector<Value*> arguments);

  std::vector<Parameter> parameters_;
  bool each_alone_ = false;
  TrackedList<Combination> combinations_;
};

/// What a filter is made with.
struct FilterParts {
  MemoryWriter& writer;
  Scene& scene;
  Symbol owner;                             ///< The identifier that describes it.
  const struct FilterKind* kind = nullptr;  ///< Null for constants.
  std::vector<Inputs::Parameter> parameters;
  bool each_alone = false;
  PlainRandom& random;
};

/// A computation over a scene: it keeps the list of its values, and computes again only what depends on something that
/// changed. It lives no longer than its scene.
class Filter : private SceneWatcher {
 public:
  explicit Filter(FilterParts parts);
  ~Filter() override;
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  /// Brings the values up to date, those of its parameters first. False if it failed: its status tells why, and it has
  /// no values.
  bool Update();
  TrackedList<Value>& output() { return output_; }
  Inputs& inputs() { return inputs_; }
  const Inputs& inputs() const { return inputs_; }
  const TrackedList<Value>& output() const { return output_; }
  /// Null for constants.
  const FilterKind* kind() const { return kind_; }
  /// "success", or what is wrong.
  const std::string& status() const { return status_.text(); }
  /// What is wrong with it or with a parameter of it, the deepest first; nothing if it works.
  Trouble FindTrouble() const;
  /// Calls `mark` for each symbol that it and its parameters hold.
  void Mark(const std::function<void(Symbol)>& mark) const;

 protected:
  /// Turns the changes of the inputs into changes of the output. False: it failed, and has set a status.
  virtual bool Compute() = 0;
  /// What a filter hears of its scene, if it watches it.
  void OnNode(Node& node, NodeChange change, std::string_view tag) override;
  void WatchScene();

  /// What it asks for that is not there, though it succeeds.
  virtual Trouble Missing() const;
  void Fail(std::string_view status) { status_.Set(status); }
  Scene& scene() { return scene_; }
  const Scene& scene() const { return scene_; }
  PlainRandom& random() { return random_; }

  /// Parameters of one name.
  using Slots = std::vector<std::size_t>;
  Slots SlotsOf(std::string_view name) const;
  /// The first value under a name, or null.
  const Value* Argument(const Combination& combination, const Slots& slots) const;
  /// The same as a node, text or number; null or none if it is missing. One of another kind counts as missing, and the
  /// status says so (if `tell`).
  Node* NodeOf(const Combination& combination, const Slots& slots, std::string_view name);
  const std::string* TextOf(const Combination& combination, const Slots& slots, std::string_view name,
                            bool tell = true);
  std::optional<double> NumberOf(const Combination& combination, const Slots& slots, std::string_view name);

  /// Sets the value for a combination, or for all of them (null).
  Value& Give(Combination* combination, Content content);
  void Change(Value& value, Content content);
  void Drop(Combination& combination);
  void Drop(Value& value);
  virtual void ClearOutput();

 private:
  void TellWrongType(std::string_view name);

  Scene& scene_;
  PlainRandom& random_;
  const FilterKind* kind_;
  StatusLine status_;
  Inputs inputs_;
  TrackedList<Value> output_;
  std::unordered_map<const Node*, std::vector<Value*>> nodes_;  ///< Values that are nodes.
  bool watches_ = false;
};

}  // namespace soarbox::kernel::imagery
