// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <map>
#include <unordered_map>

#include "bytes/byte_stream.h"
#include "cli/rule_image.h"
#include "kernel/agent.h"
#include "kernel/rules/functions/builtin_functions.h"

namespace soarbox::cli {

using namespace rule_image;
using kernel::Action;
using kernel::Condition;
using kernel::ConditionKind;
using kernel::Production;
using kernel::RhsValue;
using kernel::RhsValueKind;
using kernel::Symbol;
using kernel::Test;
using kernel::TestKind;

namespace {

class Writer : public ByteWriter {
 public:
  explicit Writer(const kernel::SymbolTable& table) : ByteWriter(bytes_), table_(table) {}

  std::string Take() { return std::move(bytes_); }

  void Symbols(const std::vector<Symbol>& symbols) {
    Number(symbols.size());
    for (const Symbol symbol : symbols) {
      numbers_.emplace(symbol.bits(), numbers_.size());
      if (symbol.IsVariable() || symbol.IsString()) {
        Byte(static_cast<std::uint8_t>(symbol.IsVariable() ? SymbolCode::kVariable : SymbolCode::kString));
        Text(table_.Text(symbol));
      } else if (symbol.IsInteger()) {
        Byte(static_cast<std::uint8_t>(SymbolCode::kInteger));
        const std::int64_t value = table_.IntegerValue(symbol);
        // The sign is stored in the lowest bit, so that small negative numbers are short.
        Number(static_cast<std::uint64_t>(value) << 1 ^ static_cast<std::uint64_t>(value >> 63));
      } else {
        Byte(static_cast<std::uint8_t>(SymbolCode::kFloat));
        Double(table_.FloatValue(symbol));
      }
    }
  }

  /// Name, flags (bit 0: documentation follows, 1: interrupt, 2: explain), documentation, type, support, file and line;
  /// then the conditions and the actions.
  void Rule(const Production& rule, std::size_t file) {
    Text(rule.name);
    Byte(static_cast<std::uint8_t>(rule.has_documentation | rule.interrupt << 1 | rule.explain << 2));
    if (rule.has_documentation) Text(rule.documentation);
    Byte(static_cast<std::uint8_t>(rule.type));
    Byte(static_cast<std::uint8_t>(rule.declared_support));
    Number(file);
    Number(static_cast<std::uint64_t>(std::max(rule.line, 0)));
    Conditions(rule.conditions);
    Number(rule.actions.size());
    for (const Action& action : rule.actions) ActionOf(action);
  }

 private:
  void SymbolOf(Symbol symbol) { Number(numbers_.at(symbol.bits())); }

  /// Kind, with bit 7 for the sign of acceptable preferences; then three tests, or the conditions of a conjunction.
  void Conditions(std::span<const Condition> conditions) {
    Number(conditions.size());
    for (const Condition& condition : conditions) {
      Byte(static_cast<std::uint8_t>(static_cast<int>(condition.kind) | condition.tests_acceptable << 7));
      if (condition.kind == ConditionKind::kConjunctiveNegation) {
        Conditions(condition.conditions());
        continue;
      }
      TestOf(condition.id);
      TestOf(condition.attribute);
      TestOf(condition.value);
    }
  }

  void TestOf(const Test& test) {
    Byte(static_cast<std::uint8_t>(test.kind));
    switch (test.kind) {
      case TestKind::kBlank:
      case TestKind::kState:
      case TestKind::kImpasse:
      case TestKind::kIsLti:
      case TestKind::kIsNotLti:
        break;
      case TestKind::kDisjunction:
        Number(test.disjuncts().size());
        for (const Symbol symbol : test.disjuncts()) SymbolOf(symbol);
        break;
      case TestKind::kConjunction:
        Number(test.parts().size());
        for (const Test& part : test.parts()) TestOf(part);
        break;
      default:
        SymbolOf(test.referent());
        break;
    }
  }

  /// 0x80 for a separate function, else the preference; then the values.
  void ActionOf(const Action& action) {
    if (action.is_function_call) {
      Byte(0x80);
      ValueOf(action.value);
      return;
    }
    Byte(static_cast<std::uint8_t>(action.preference));
    ValueOf(action.id);
    ValueOf(action.attribute);
    ValueOf(action.value);
    if (action.HasReferent()) ValueOf(action.referent);
  }

  void ValueOf(const RhsValue& value) {
    if (value.kind != RhsValueKind::kFunction) {
      Byte(static_cast<std::uint8_t>(ValueCode::kSymbol));
      SymbolOf(value.symbol());
      return;
    }
    Byte(static_cast<std::uint8_t>(ValueCode::kFunction));
    Text(kernel::BuiltinFunctions()[value.function_index()].name);
    Number(value.arguments().size());
    for (const RhsValue& argument : value.arguments()) ValueOf(argument);
  }

  const kernel::SymbolTable& table_;
  std::unordered_map<std::uint32_t, std::size_t> numbers_;
  std::string bytes_;
};

/// Collects the symbols of rules: first constants, ordered by age, because the rule parser breaks ties by age; then
/// variables.
class Collector {
 public:
  explicit Collector(const kernel::SymbolTable& table) : table_(table) {}

  void Add(const Production& rule) {
    Add(table_.FindString(rule.name));
    for (const Condition& condition : rule.conditions) Add(condition);
    for (const Action& action : rule.actions) {
      for (const RhsValue* value : {&action.id, &action.attribute, &action.value, &action.referent}) Add(*value);
    }
  }

  std::vector<Symbol> Take() {
    std::stable_sort(found_.begin(), found_.end(), [this](Symbol a, Symbol b) { return Age(a) < Age(b); });
    return std::move(found_);
  }

 private:
  void Add(const Condition& condition) {
    for (const Test* test : {&condition.id, &condition.attribute, &condition.value}) Add(*test);
    for (const Condition& part : condition.conditions()) Add(part);
  }
  void Add(const Test& test) {
    Add(test.referent());
    for (const Symbol symbol : test.disjuncts()) Add(symbol);
    for (const Test& part : test.parts()) Add(part);
  }
  void Add(const RhsValue& value) {
    Add(value.symbol());
    for (const RhsValue& argument : value.arguments()) Add(argument);
  }
  void Add(Symbol symbol) {
    if (symbol && seen_.emplace(symbol.bits(), true).second) found_.push_back(symbol);
  }
  std::uint64_t Age(Symbol symbol) const { return symbol.IsVariable() ? std::uint64_t{1} << 32 : table_.Stamp(symbol); }

  const kernel::SymbolTable& table_;
  std::unordered_map<std::uint32_t, bool> seen_;
  std::vector<Symbol> found_;
};

}  // namespace

std::uint64_t rule_image::Checksum(std::string_view bytes) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001B3u;
  return hash;
}

std::string WriteRuleImage(const kernel::Agent& agent) {
  // With their values from reinforcement learning.
  std::vector<kernel::ProductionPtr> rules;
  for (const kernel::ProductionId id : agent.Productions()) rules.push_back(agent.ProductionAsLearned(id));
  Collector collector(agent.symbols());
  std::map<std::string, std::size_t> file_numbers;
  std::vector<std::string_view> files;
  for (const kernel::ProductionPtr& rule : rules) {
    collector.Add(*rule);
    const auto [file, is_new] = file_numbers.emplace(rule->file(), files.size());
    if (is_new) files.push_back(file->first);
  }
  Writer payload(agent.symbols());
  payload.Symbols(collector.Take());
  payload.Number(files.size());
  for (const std::string_view file : files) payload.Text(file);
  payload.Number(rules.size());
  for (const kernel::ProductionPtr& rule : rules) payload.Rule(*rule, file_numbers.at(rule->file()));
  const std::string body = payload.Take();
  std::string image(kMagic);
  ByteWriter header(image);
  header.Fixed32(kVersion);
  header.Fixed64(body.size());
  header.Fixed64(Checksum(body));
  return image + body;
}

}  // namespace soarbox::cli
