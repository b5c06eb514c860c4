// SPDX-License-Identifier: BSD-2-Clause
// The commands extract and extract_once: a filter whose values are written to working memory.
#include <algorithm>
#include <bit>
#include <cstdlib>
#include <optional>
#include <unordered_set>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "kernel/base/known_symbols.h"
#include "kernel/imagery/filter_kinds.h"
#include "kernel/imagery/filter_pool.h"
#include "kernel/imagery/scene_command.h"
#include "kernel/imagery/scene_lines.h"

namespace soarbox::kernel::imagery {
namespace {

/// Builds the filter that an identifier describes, including the filters in its parameters.
class FilterReader {
 public:
  /// `alone`: shares no filters.
  FilterReader(const CommandParts& parts, bool alone) : parts_(parts), alone_(alone) {}

  /// Returns null if a part is not a valid filter.
  std::unique_ptr<FilterUse> Read(Symbol described) {
    if (!described.IsIdentifier()) return ReadConstant(described);
    if (path_.size() >= kDeepest || ++filters_ > kMostFilters) return nullptr;
    for (const Symbol above : path_) {
      if (above == described) return nullptr;  // It contains itself.
    }
    path_.push_back(described);
    std::unique_ptr<FilterUse> filter = ReadFilter(described);
    path_.pop_back();
    return filter;
  }

  /// The unknown type that prevented reading; empty if there is none.
  const std::string& unknown() const { return unknown_; }

 private:
  static constexpr std::size_t kDeepest = 100, kMostFilters = 10'000;

  FilterParts Parts() const { return {parts_.scene, parts_.filters, parts_.random}; }

  std::unique_ptr<FilterUse> Use(Symbol owner, std::shared_ptr<Filter> filter,
                                 std::vector<std::unique_ptr<FilterUse>> parameters = {}) const {
    return std::make_unique<FilterUse>(parts_.writer, owner, std::move(filter), std::move(parameters));
  }

  std::unique_ptr<FilterUse> ReadConstant(Symbol constant) {
    const MemoryWriter& writer = parts_.writer;
    Content content;
    std::string description;
    if (constant.IsString()) {
      content = std::string(writer.TextOf(constant));
      description = "|" + std::string(writer.TextOf(constant));
    } else if (constant.IsInteger()) {
      content = writer.IntegerOf(constant);
      description = "i" + std::to_string(writer.IntegerOf(constant));
    } else if (constant.IsFloat()) {
      content = writer.NumberOf(constant);
      description = "f" + std::to_string(std::bit_cast<std::uint64_t>(writer.NumberOf(constant)));
    } else {
      return nullptr;
    }
    return Use({}, parts_.filters.Share(description, [&] { return MakeConstant(Parts(), content); }));
  }

  std::unique_ptr<FilterUse> ReadFilter(Symbol described) {
    std::string type, input_type;
    bool readable = true;
    std::vector<std::pair<std::string, Symbol>> found;
    parts_.writer.ForEachValue(described, [&](Symbol attribute, Symbol value) {
      if (!attribute.IsString()) return;
      const std::string name(parts_.writer.TextOf(attribute));
      if (name == "type" || name == "input-type") {
        if (!value.IsString()) readable = false;
        if (value.IsString()) (name == "type" ? type : input_type) = parts_.writer.TextOf(value);
      } else if (name != "status" && name != "result") {
        found.emplace_back(name, value);
      }
    });
    const FilterKind* const kind = readable ? FindFilterKind(type) : nullptr;
    if (kind == nullptr) {
      unknown_ = type;
      return nullptr;
    }
    FilterParts parts = Parts();
    parts.each_alone = input_type == "concat" || type == "combine_nodes";
    std::string description = "(" + type + (parts.each_alone ? "+" : "");
    std::vector<std::unique_ptr<FilterUse>> uses;
    for (const auto& [name, value] : found) {
      std::unique_ptr<FilterUse> use = Read(value);
      if (use == nullptr) return nullptr;
      description += " " + std::to_string(name.size()) + name + std::to_string(use->filter().serial());
      parts.parameters.push_back({name, use->shared()});
      uses.push_back(std::move(use));
    }
    parts.kind = kind;
    const auto make = [&] { return std::shared_ptr<Filter>(kind->make(std::move(parts))); };
    if (alone_ || kind->sharing == Sharing::kNever) return Use(described, make(), std::move(uses));
    if (kind->sharing == Sharing::kSameLook) description += ")" + std::to_string(parts_.filters.look());
    return Use(described, parts_.filters.Share(description, make), std::move(uses));
  }

  const CommandParts& parts_;
  bool alone_;
  std::vector<Symbol> path_;
  std::size_t filters_ = 0;
  std::string unknown_;
};

std::string HintForFilter(const std::string& type) {
  if (type.empty()) return "each filter is an object with a ^type; svs filters lists the types";
  std::vector<std::string_view> names;
  for (const FilterKind& kind : FilterKinds()) names.push_back(kind.name);
  const std::string_view near = Suggest(type, names);
  return near.empty() ? "svs filters lists the filters" : "did you mean " + std::string(near) + "?";
}

class Extract final : public SceneCommand {
 public:
  Extract(const CommandParts& parts, bool once) : SceneCommand(parts.id), parts_(parts), once_(once) {}
  bool writes() const override { return false; }

  void Update(bool look_again) override {
    if (!once_ && !first_ && !look_again) return;
    if (!result_) result_ = parts_.writer.AddObject(parts_.id, "result");
    if (const std::size_t size = SizeOfCommand(); size_ != size) {
      size_ = size;
      if (!Read()) return;
    }
    if (use_ == nullptr || (once_ && !first_)) return;
    if (!use_->filter().Update()) {
      use_->Tell();
      NoteChange();
      expected_ = 0;
      ForgetRecords();
      return;
    }
    Show();
    first_ = false;
  }

  const Filter* filter() const override { return use_ == nullptr ? nullptr : &use_->filter(); }
  Symbol RecordOf(const Value& value) const override {
    return value.slot < records_.size() ? records_[value.slot].id : Symbol();
  }
  Trouble trouble() const override {
    if (use_ != nullptr) return use_->filter().FindTrouble();
    if (!size_) return {};
    return {"incorrect filter syntax" + (unknown_.empty() ? "" : ": there is no filter " + unknown_),
            HintForFilter(unknown_)};
  }

  void Mark(const std::function<void(Symbol)>& mark) const override {
    mark(parts_.id);
    if (result_) mark(result_);
    if (use_ != nullptr) use_->Mark(mark);
    for (const Record& record : records_) {
      if (record.id) mark(record.id);
      if (record.params) mark(record.params);
    }
  }

 private:
  struct Record {
    Symbol id, params;
    std::uint32_t number = 0;  ///< In order of creation.
  };

  bool Read() {
    NoteChange();
    ForgetRecords();
    FilterReader reader(parts_, once_);
    use_ = reader.Read(parts_.id);
    unknown_ = reader.unknown();
    if (use_ == nullptr) {
      StatusLine(parts_.writer, parts_.id).Set("incorrect filter syntax");
      return false;
    }
    first_ = true;
    expected_ = 0;
    return true;
  }

  /// The number of elements of the command and below it, without results. The command is read again when it changes.
  std::size_t SizeOfCommand() const {
    std::size_t size = 0;
    std::unordered_set<std::uint32_t> seen{parts_.id.bits()};
    std::vector<Symbol> waiting{parts_.id};
    while (!waiting.empty()) {
      const Symbol id = waiting.back();
      waiting.pop_back();
      parts_.writer.ForEachValue(id, [&](Symbol attribute, Symbol value) {
        if (attribute.IsString()) {
          const std::string_view name = parts_.writer.TextOf(attribute);
          if (name == "result" || name == "status") return;
        }
        ++size;
        if (value.IsIdentifier() && seen.insert(value.bits()).second) waiting.push_back(value);
      });
    }
    return size;
  }

  void Show() {
    const Filter& filter = use_->filter();
    const TrackedList<Value>& output = filter.output();
    use_->TellParameters();
    const bool anew = expected_ != filter.cleared();
    expected_ = filter.will_be_cleared();
    if (anew) {
      use_->Tell();
      ForgetRecords();
      records_.resize(output.slots());
      for (const Value& value : output) ShowValue(value);
      NoteChange();
      return;
    }
    for (const Inputs::Rewritten& rewritten : filter.inputs().rewritten()) {
      if (rewritten.output == nullptr || rewritten.output->slot >= records_.size()) continue;
      const Record& record = records_[rewritten.output->slot];
      if (record.id) ShowParams(record.params, *rewritten.combination);
    }
    use_->Tell();
    if (!output.HasChanges()) return;
    records_.resize(output.slots());
    for (const Value& value : output.fresh()) ShowValue(value);
    for (const Value& gone : output.removed()) {
      Record& record = records_[gone.slot];
      if (!record.id) continue;  // It was added and removed between two updates.
      parts_.writer.Remove(result_, "record", record.id);
      record = {};
    }
    for (const Value* const changed : output.changed()) {
      if (changed != nullptr) ShowValue(*changed);
    }
    NoteChange();
  }

  void ShowValue(const Value& value) {
    MemoryWriter& writer = parts_.writer;
    Record& record = records_[value.slot];
    if (record.id) {
      if (!value.rewritten) return;
      if (const std::optional<Symbol> constant = ConstantOf(value.content)) {
        writer.Replace(record.id, words::kValue, *constant);
      } else {
        writer.RemoveAll(record.id, "value");
        WriteObject(record.id, "value", value.content);
      }
      return;
    }
    record.id = writer.AddObject(result_, "record");
    if (!record.id) return;
    record.number = ++last_record_;
    Write(record.id, "value", value.content);
    record.params = writer.AddObject(record.id, "params");
    if (value.from != nullptr) ShowParams(record.params, *value.from);
  }

  void ShowParams(Symbol params, const Combination& combination) {
    const Inputs& inputs = use_->filter().inputs();
    for (std::size_t n = 0; n < inputs.parameters().size(); ++n) {
      const Value* const argument = inputs.ArgumentOf(combination, n);
      if (argument == nullptr) continue;
      const std::string& name = inputs.parameters()[n].name;
      const Symbol shown = parts_.writer.ValueOf(params, name);
      if (shown && Says(shown, argument->content)) continue;
      if (shown) parts_.writer.Remove(params, name, shown);
      Write(params, name, argument->content);
    }
  }

  /// Whether a constant represents the content. Always false for vectors and boxes, so they are always written again.
  bool Says(Symbol symbol, const Content& content) const {
    if (const auto* number = std::get_if<double>(&content))
      return symbol.IsNumber() && parts_.writer.NumberOf(symbol) == *number;
    if (const auto* number = std::get_if<std::int64_t>(&content)) {
      return symbol.IsInteger() && parts_.writer.IntegerOf(symbol) == *number;
    }
    const std::optional<std::string_view> text = WordOf(content);
    return text && symbol.IsString() && parts_.writer.TextOf(symbol) == *text;
  }

  static std::optional<std::string_view> WordOf(const Content& content) {
    if (const bool* const answer = std::get_if<bool>(&content)) return *answer ? "true" : "false";
    if (const auto* text = std::get_if<std::string>(&content)) return *text;
    if (Node* const* const node = std::get_if<Node*>(&content)) return (*node)->id();
    return std::nullopt;
  }

  /// The constant for a value; none for vectors and boxes, which are objects.
  std::optional<Symbol> ConstantOf(const Content& content) const {
    if (const auto* number = std::get_if<double>(&content)) return parts_.writer.Float(*number);
    if (const auto* integer = std::get_if<std::int64_t>(&content)) return parts_.writer.Integer(*integer);
    if (const std::optional<std::string_view> word = WordOf(content)) return parts_.writer.Text(*word);
    return std::nullopt;
  }

  void Write(Symbol id, std::string_view attribute, const Content& content) {
    if (const std::optional<Symbol> constant = ConstantOf(content)) {
      parts_.writer.Add(id, attribute, *constant);
    } else {
      WriteObject(id, attribute, content);
    }
  }

  void WriteObject(Symbol id, std::string_view attribute, const Content& content) {
    const Symbol object = parts_.writer.AddObject(id, attribute);
    if (!object) return;
    // Numbers inside objects are rounded to 6 significant digits.
    const auto add = [&](std::string_view name, double value) {
      parts_.writer.Add(object, name, parts_.writer.Float(std::strtod(NumberText(value).c_str(), nullptr)));
    };
    if (const auto* vector = std::get_if<Vec3>(&content)) {
      add("x", vector->x);
      add("y", vector->y);
      add("z", vector->z);
    } else if (const auto* box = std::get_if<Box>(&content)) {
      add("max-x", box->high.x);
      add("max-y", box->high.y);
      add("max-z", box->high.z);
      add("min-x", box->low.x);
      add("min-y", box->low.y);
      add("min-z", box->low.z);
    }
  }

  void ForgetRecords() {
    std::vector<Record> records;
    for (const Record& record : std::exchange(records_, {})) {
      if (record.id) records.push_back(record);
    }
    std::sort(records.begin(), records.end(), [](const Record& a, const Record& b) { return a.number < b.number; });
    for (const Record& record : records) parts_.writer.Remove(result_, "record", record.id);
  }

  CommandParts parts_;
  bool once_ = false;
  bool first_ = true;  ///< The filter has not succeeded yet.
  std::optional<std::size_t> size_;
  std::string unknown_;  ///< The unknown type, if the filter could not be read.
  Symbol result_;
  std::unique_ptr<FilterUse> use_;
  std::uint64_t expected_ = 0;   ///< The value of Filter::cleared() if no change was missed.
  std::vector<Record> records_;  ///< By slot of the value.
  std::uint32_t last_record_ = 0;
};

}  // namespace

std::unique_ptr<SceneCommand> MakeExtract(const CommandParts& parts, bool once) {
  return std::make_unique<Extract>(parts, once);
}

}  // namespace soarbox::kernel::imagery
