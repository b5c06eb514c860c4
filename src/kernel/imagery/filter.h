// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kernel/imagery/imagery_scene.h"
#include "kernel/imagery/tracked_list.h"

namespace soarbox::kernel::imagery {

class Filter;
class FilterPool;
class PlainRandom;
struct Combination;
struct FilterKind;
struct Trouble;

/// The possible contents of a filter's value: a number, a truth value, a word, a vector, a box or a node.
using Content = std::variant<double, std::int64_t, bool, std::string, Vec3, Box, Node*>;

/// One value of a filter.
struct Value : Tracked<Value> {
  Content content;
  Combination* from = nullptr;  ///< The combination that it was computed from; null for constants and similar filters.
  bool rewritten = true;        ///< The content has changed since the changes were cleared.
};

/// One input of a filter: a value per parameter (Inputs::ArgumentOf).
struct Combination : Tracked<Combination> {
  Value* output = nullptr;  ///< The filter's value for this combination, if any.
  double rank = 0;          ///< For filters that choose the best combination.
  bool told = false;        ///< It is in Inputs::rewritten() already.
};

/// The parameters of a filter and the combinations of their values: the Cartesian product with the first parameter
/// varying fastest, or one parameter at a time. Only new values are combined.
class Inputs {
 public:
  struct Parameter {
    std::string name;
    std::shared_ptr<Filter> source;
  };
  /// A combination in which one value replaced another, with its value before it was recomputed.
  struct Rewritten {
    Combination* combination;
    const Value* output;
  };

  Inputs(std::vector<Parameter> parameters, bool each_alone);

  const std::vector<Parameter>& parameters() const { return parameters_; }
  TrackedList<Combination>& combinations() { return combinations_; }
  const TrackedList<Combination>& combinations() const { return combinations_; }
  /// Valid until the changes of the filter are cleared.
  const std::vector<Rewritten>& rewritten() const { return rewritten_; }
  void ClearRewritten();
  /// The value of a parameter in a combination; null if it has none.
  const Value* ArgumentOf(const Combination& combination, std::size_t parameter) const;

  /// Updates the parameters. Returns an empty text, or an error: a parameter failed, or there are too many
  /// combinations. After an error there are no combinations.
  std::string_view Update();
  static constexpr std::size_t kMostCombinations = 2'000'000;
  std::size_t MemoryBytes() const;

 private:
  /// A parameter whose value may differ between combinations.
  struct Column {
    std::size_t parameter;
    std::uint64_t expected = 0;         ///< The value of Filter::cleared() if no change was missed.
    std::vector<std::uint32_t> chains;  ///< By slot of a value: 1 + its first combination.
  };
  /// A combination's value in a column, and its neighbours in the list of combinations with the same value (index + 1).
  struct Link {
    Value* value = nullptr;
    std::uint32_t previous = 0, next = 0;
  };
  static constexpr std::size_t kNoColumn = ~std::size_t{0};

  Link& LinkOf(std::uint32_t combination, std::size_t column) { return links_[combination * columns_.size() + column]; }
  Filter& SourceOf(const Column& column) const { return *parameters_[column.parameter].source; }
  bool MissedChanges() const;
  void Forget();
  void DropUsersOf(std::size_t column, const Value& gone);
  void NoteChanges(std::size_t column, const Value& changed);
  void CombineEachAlone(bool anew);
  void CombineEachWithEach(bool anew);
  /// `values` has one value per column, null for none.
  void Add(const std::vector<Value*>& values);
  void Chain(std::uint32_t combination, std::size_t column, Value* value);
  void Unchain(std::uint32_t combination, std::size_t column);

  std::vector<Parameter> parameters_;
  bool each_alone_ = false;
  std::vector<Column> columns_;
  std::vector<std::size_t> column_of_;  ///< By parameter.
  TrackedList<Combination> combinations_;
  std::vector<Link> links_;  ///< By slot of a combination, then by column.
  std::vector<Rewritten> rewritten_;
};

/// The arguments of a filter's construction.
struct FilterParts {
  Scene& scene;
  FilterPool& pool;
  PlainRandom& random;
  const FilterKind* kind = nullptr;  ///< Null for constants.
  std::vector<Inputs::Parameter> parameters = {};
  bool each_alone = false;
};

/// A computation over a scene. It stores the list of its values and recomputes only those that depend on a change. A
/// reader calls Update first, and can read the changes until the look ends (FilterPool). A filter must not outlive its
/// scene and its pool.
class Filter : private SceneWatcher {
 public:
  explicit Filter(FilterParts parts);
  ~Filter() override;
  Filter(const Filter&) = delete;
  Filter& operator=(const Filter&) = delete;

  /// Updates the parameters and then the values, once per look. Returns false on failure: then the status describes the
  /// error, and there are no values.
  bool Update();
  /// Whether the last update succeeded.
  bool works() const { return works_; }
  TrackedList<Value>& output() { return output_; }
  const TrackedList<Value>& output() const { return output_; }
  Inputs& inputs() { return inputs_; }
  const Inputs& inputs() const { return inputs_; }
  /// Null for constants.
  const FilterKind* kind() const { return kind_; }
  bool is_constant() const { return kind_ == nullptr; }
  /// "success", or a description of the error.
  const std::string& status() const { return status_; }
  /// The statuses of this look, in order; empty if the status did not change.
  const std::vector<std::string>& said() const { return said_; }
  /// The number of times that changes were cleared, from 1. If it differs from the expected number, the reader has
  /// missed changes.
  std::uint64_t cleared() const { return cleared_; }
  /// The number that a reader must expect in the next look if it has read all changes of this one.
  std::uint64_t will_be_cleared() const { return cleared_ + (output_.HasChanges() ? 1 : 0); }
  void ClearChanges();
  /// Unique among the filters of a pool.
  std::uint64_t serial() const { return serial_; }
  /// The error of the filter or of one of its parameters, the deepest first; empty if everything works.
  Trouble FindTrouble() const;
  std::size_t MemoryBytes() const;

 protected:
  /// Converts the changes of the inputs to changes of the output. Returns false on failure: the status describes the
  /// error.
  virtual bool Compute() = 0;
  /// A change in the scene; called if the filter watches it.
  void OnNode(Node& node, NodeChange change, std::string_view tag) override;
  void WatchScene();

  /// A reference to something that does not exist; the filter succeeds nevertheless.
  virtual Trouble Missing() const;
  void Fail(std::string_view status);
  Scene& scene() { return scene_; }
  const Scene& scene() const { return scene_; }
  PlainRandom& random() { return random_; }

  /// The indices of parameters with the same name.
  using Slots = std::vector<std::size_t>;
  Slots SlotsOf(std::string_view name) const;
  /// The first value of a parameter name, or null.
  const Value* Argument(const Combination& combination, const Slots& slots) const;
  /// The value as a node, text or number; null or none if it is missing. A value of another kind counts as missing, and
  /// the status reports it. TextOf does not report it if `tell` is false.
  Node* NodeOf(const Combination& combination, const Slots& slots, std::string_view name);
  const std::string* TextOf(const Combination& combination, const Slots& slots, std::string_view name,
                            bool tell = true);
  std::optional<double> NumberOf(const Combination& combination, const Slots& slots, std::string_view name);

  /// Sets the value of a combination. With null, adds a value that belongs to no combination.
  Value& Give(Combination* combination, Content content);
  void Change(Value& value, Content content);
  void Drop(Combination& combination);
  void Drop(Value& value);
  virtual void ClearOutput();

 private:
  void OnHeld(std::uint32_t slot, NodeChange change) override;
  void TellWrongType(std::string_view name);

  Scene& scene_;
  FilterPool& pool_;
  PlainRandom& random_;
  const FilterKind* kind_;
  std::string status_;
  std::vector<std::string> said_;
  Inputs inputs_;
  TrackedList<Value> output_;
  std::uint64_t serial_, cleared_ = 1;
  std::uint64_t look_ = 0;  ///< The last look in which it was updated.
  bool watches_ = false, works_ = false;
};

}  // namespace soarbox::kernel::imagery
