// SPDX-License-Identifier: BSD-2-Clause
// The commands extract and extract_once: a filter whose values stand in working memory.
#include <algorithm>
#include <cstdlib>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "kernel/imagery/filter_kinds.h"
#include "kernel/imagery/scene_command.h"
#include "kernel/imagery/scene_lines.h"

namespace soarbox::kernel::imagery {
namespace {

/// Builds the filter that an identifier describes, with all filters that its parameters are.
class FilterReader {
 public:
  explicit FilterReader(const CommandParts& parts) : parts_(parts) {}

  /// Null if something in it is no filter.
  std::unique_ptr<Filter> Read(Symbol described) {
    if (!described.IsIdentifier()) return ReadConstant(described);
    if (path_.size() >= kDeepest || ++filters_ > kMostFilters) return nullptr;
    for (const Symbol above : path_) {
      if (above == described) return nullptr;  // It contains itself.
    }
    path_.push_back(described);
    std::unique_ptr<Filter> filter = ReadFilter(described);
    path_.pop_back();
    return filter;
  }

  /// The type of the filter that could not be read, if there is no such type.
  const std::string& unknown() const { return unknown_; }

 private:
  static constexpr std::size_t kDeepest = 100, kMostFilters = 10'000;

  FilterParts PartsFor(Symbol owner) const {
    return {parts_.writer, parts_.scene, owner, nullptr, {}, false, parts_.random};
  }

  std::unique_ptr<Filter> ReadConstant(Symbol constant) {
    if (constant.IsString()) return MakeConstant(PartsFor({}), std::string(parts_.writer.TextOf(constant)));
    if (constant.IsInteger()) return MakeConstant(PartsFor({}), parts_.writer.IntegerOf(constant));
    if (constant.IsFloat()) return MakeConstant(PartsFor({}), parts_.writer.NumberOf(constant));
    return nullptr;
  }

  std::unique_ptr<Filter> ReadFilter(Symbol described) {
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
    FilterParts parts = PartsFor(described);
    parts.each_alone = input_type == "concat" || type == "combine_nodes";
    for (const auto& [name, value] : found) {
      std::unique_ptr<Filter> source = Read(value);
      if (source == nullptr) return nullptr;
      parts.parameters.push_back({name, std::move(source)});
    }
    parts.kind = kind;
    return kind->make(std::move(parts));
  }

  const CommandParts& parts_;
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
    if (filter_ == nullptr || (once_ && !first_)) return;
    if (!filter_->Update()) {
      NoteChange();
      ForgetRecords();
      return;
    }
    Show();
    first_ = false;
  }

  const Filter* filter() const override { return filter_.get(); }
  Symbol RecordOf(const Value& value) const override {
    const auto found = records_.find(&value);
    return found == records_.end() ? Symbol() : found->second.id;
  }
  Trouble trouble() const override {
    if (filter_ != nullptr) return filter_->FindTrouble();
    if (!size_) return {};
    return {"incorrect filter syntax" + (unknown_.empty() ? "" : ": there is no filter " + unknown_),
            HintForFilter(unknown_)};
  }

  void Mark(const std::function<void(Symbol)>& mark) const override {
    mark(parts_.id);
    if (result_) mark(result_);
    if (filter_ != nullptr) filter_->Mark(mark);
    for (const auto& [value, record] : records_) {
      mark(record.id);
      if (record.params) mark(record.params);
    }
  }

 private:
  struct Record {
    Symbol id, params;
    std::uint64_t number = 0;  ///< In order of making.
  };

  bool Read() {
    NoteChange();
    ForgetRecords();
    FilterReader reader(parts_);
    filter_ = reader.Read(parts_.id);
    unknown_ = reader.unknown();
    if (filter_ == nullptr) {
      StatusLine(parts_.writer, parts_.id).Set("incorrect filter syntax");
      return false;
    }
    filter_->inputs().on_change = [this](Combination& combination) {
      if (const auto found = records_.find(combination.output); found != records_.end()) {
        ShowParams(found->second.params, combination);
      }
    };
    first_ = true;
    return true;
  }

  /// How many elements the command and what hangs on it have, without answers. When it changes the command is read
  /// anew.
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
    TrackedList<Value>& output = filter_->output();
    for (auto at = output.FirstFresh(); at != output.entries().end(); ++at) ShowValue(**at);
    for (const auto& gone : output.removed()) {
      const auto found = records_.find(gone.get());
      if (found == records_.end()) continue;  // It came and went unseen.
      parts_.writer.Remove(result_, "record", found->second.id);
      records_.erase(found);
    }
    for (Value* const changed : output.changed()) ShowValue(*changed);
    if (output.HasChanges()) NoteChange();
    output.ClearChanges();
  }

  void ShowValue(Value& value) {
    if (const auto found = records_.find(&value); found != records_.end()) {
      if (value.rewritten) {
        parts_.writer.RemoveAll(found->second.id, "value");
        Write(found->second.id, "value", value.content);
      }
    } else if (const Symbol id = parts_.writer.AddObject(result_, "record")) {
      Write(id, "value", value.content);
      const Symbol params = parts_.writer.AddObject(id, "params");
      if (value.from != nullptr) ShowParams(params, *value.from);
      records_.emplace(&value, Record{id, params, ++last_record_});
    }
    value.rewritten = false;
  }

  void ShowParams(Symbol params, const Combination& combination) {
    const std::vector<Inputs::Parameter>& parameters = filter_->inputs().parameters();
    for (std::size_t n = 0; n < parameters.size(); ++n) {
      const Value* const argument = combination.arguments[n];
      if (argument == nullptr) continue;
      const Symbol shown = parts_.writer.ValueOf(params, parameters[n].name);
      if (shown && Says(shown, argument->content)) continue;
      if (shown) parts_.writer.Remove(params, parameters[n].name, shown);
      Write(params, parameters[n].name, argument->content);
    }
  }

  /// Whether a constant is what would be shown. Vectors and boxes are always shown anew.
  bool Says(Symbol symbol, const Content& content) const {
    if (const auto* number = std::get_if<double>(&content))
      return symbol.IsNumber() && parts_.writer.NumberOf(symbol) == *number;
    if (const auto* number = std::get_if<std::int64_t>(&content)) {
      return symbol.IsInteger() && parts_.writer.IntegerOf(symbol) == *number;
    }
    const std::optional<std::string> text = WordOf(content);
    return text && symbol.IsString() && parts_.writer.TextOf(symbol) == *text;
  }

  static std::optional<std::string> WordOf(const Content& content) {
    if (const bool* const answer = std::get_if<bool>(&content)) return *answer ? "true" : "false";
    if (const auto* text = std::get_if<std::string>(&content)) return *text;
    if (Node* const* const node = std::get_if<Node*>(&content)) return (*node)->id();
    return std::nullopt;
  }

  void Write(Symbol id, std::string_view attribute, const Content& content) {
    MemoryWriter& writer = parts_.writer;
    if (const auto* number = std::get_if<double>(&content)) {
      writer.Add(id, attribute, writer.Float(*number));
    } else if (const auto* integer = std::get_if<std::int64_t>(&content)) {
      writer.Add(id, attribute, writer.Integer(*integer));
    } else if (const std::optional<std::string> word = WordOf(content)) {
      writer.Add(id, attribute, writer.Text(*word));
    } else if (const Symbol object = writer.AddObject(id, attribute)) {
      // Of numbers within objects only 6 digits count.
      const auto add = [&](std::string_view name, double value) {
        writer.Add(object, name, writer.Float(std::strtod(NumberText(value).c_str(), nullptr)));
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
  }

  void ForgetRecords() {
    std::vector<Record> records;
    for (const auto& [value, record] : records_) records.push_back(record);
    std::sort(records.begin(), records.end(), [](const Record& a, const Record& b) { return a.number < b.number; });
    for (const Record& record : records) parts_.writer.Remove(result_, "record", record.id);
    records_.clear();
  }

  CommandParts parts_;
  bool once_ = false;
  bool first_ = true;  ///< The filter has not succeeded yet.
  std::optional<std::size_t> size_;
  std::string unknown_;  ///< The type that is none, if the filter could not be read.
  Symbol result_;
  std::unique_ptr<Filter> filter_;
  std::unordered_map<const Value*, Record> records_;
  std::uint64_t last_record_ = 0;
};

}  // namespace

std::unique_ptr<SceneCommand> MakeExtract(const CommandParts& parts, bool once) {
  return std::make_unique<Extract>(parts, once);
}

}  // namespace soarbox::kernel::imagery
