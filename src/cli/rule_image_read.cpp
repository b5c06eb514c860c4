// SPDX-License-Identifier: BSD-2-Clause
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "cli/rule_image.h"
#include "diagnostics/problem.h"
#include "kernel/base/known_symbols.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/functions/builtin_functions.h"

namespace soarbox::cli {

using namespace rule_image;
using kernel::ActionDraft;
using kernel::BindingSite;
using kernel::ConditionDraft;
using kernel::ConditionKind;
using kernel::Field;
using kernel::PreferenceType;
using kernel::RhsValue;
using kernel::RhsValueKind;
using kernel::RuleDraft;
using kernel::Symbol;
using kernel::TestDraft;
using kernel::TestKind;
using kernel::ValueDraft;

namespace {

/// More than the parser of rules permits.
constexpr int kMaxNesting = 200;
/// The match counts conditions with 16 bits.
constexpr std::size_t kMaxConditions = 60000;

/// Reads the payload of an image. After the first error all values are zero and empty.
class Reader {
 public:
  /// `make`: false only validates the payload.
  Reader(std::string_view bytes, kernel::SymbolTable& table, bool make) : bytes_(bytes), table_(table), make_(make) {}

  bool failed() const { return !error_.empty(); }
  /// The error, and the byte of the payload at which it occurred.
  const std::string& error() const { return error_; }
  std::size_t error_place() const { return error_place_; }

  std::vector<kernel::ProductionPtr> Rules() {
    const kernel::SymbolTable::PinScope pin(table_);
    Symbols();
    std::vector<kernel::FileName> files(Count("files"));
    for (kernel::FileName& file : files) file = Text("the name of a file");
    std::vector<kernel::ProductionPtr> rules(Count("rules"));
    std::unordered_set<std::string> names;
    for (std::size_t i = 0; i < rules.size() && !failed(); ++i) {
      arena_.Clear();
      RuleDraft rule;
      rule_name_ = {};
      part_ = "rule";
      number_ = i + 1;
      Rule(rule, files);
      if (!failed() && !names.emplace(rule.name).second) Fail("a second rule has this name");
      if (!failed() && make_) rules[i] = kernel::Production::Make(rule);
    }
    rule_name_ = {};
    part_ = nullptr;
    if (!failed() && place_ != bytes_.size()) Fail("bytes are left over after the last rule");
    if (failed()) rules.clear();
    return rules;
  }

 private:
  void Fail(std::string what) {
    if (failed()) return;
    if (!rule_name_.empty())
      error_ = fmt::format("rule '{}': {}", rule_name_, what);
    else
      error_ = part_ ? fmt::format("{} number {}: {}", part_, number_, what) : std::move(what);
    error_place_ = place_;
    place_ = bytes_.size();
  }

  // Bytes -------------------------------------------------------------------------------------------------------------

  std::uint8_t Byte() {
    if (place_ < bytes_.size()) return static_cast<std::uint8_t>(bytes_[place_++]);
    Fail("the image ends too early");
    return 0;
  }

  std::uint64_t Number() {
    std::uint64_t number = 0;
    for (int shift = 0; shift < 70; shift += 7) {
      const std::uint8_t byte = Byte();
      if (shift == 63 && byte > 1) break;
      number |= static_cast<std::uint64_t>(byte & 0x7F) << shift;
      if ((byte & 0x80) == 0) return number;
    }
    Fail("a number has too many bytes");
    return 0;
  }

  /// Reads a number of things; each takes at least a byte, so that a false number cannot cause a large allocation.
  std::size_t Count(std::string_view what) {
    const std::uint64_t count = Number();
    if (count <= bytes_.size() - place_) return static_cast<std::size_t>(count);
    Fail(fmt::format("it announces {} {}, but the rest of the image is too short for them", count, what));
    return 0;
  }

  std::string Text(std::string_view what) {
    const std::size_t length = Count("letters");
    std::string text(bytes_.substr(place_, length));
    place_ += length;
    if (text.find('\0') != std::string::npos) Fail(fmt::format("{} holds a zero byte", what));
    return text;
  }

  // Symbols -----------------------------------------------------------------------------------------------------------

  void Symbols() {
    symbols_.resize(Count("symbols"));
    for (std::size_t i = 0; i < symbols_.size() && !failed(); ++i) {
      part_ = "symbol";
      number_ = i + 1;
      symbols_[i] = OneSymbol();
    }
    part_ = nullptr;
  }

  Symbol OneSymbol() {
    switch (const std::uint8_t code = Byte(); static_cast<SymbolCode>(code)) {
      case SymbolCode::kVariable: {
        const std::string name = Text("a variable");
        if (name.size() >= 3 && name.front() == '<' && name.back() == '>') return table_.Variable(name);
        Fail("a variable's name needs angle brackets");
        return {};
      }
      case SymbolCode::kString:
        return table_.String(Text("a string"));
      case SymbolCode::kInteger: {
        const std::uint64_t folded = Number();
        return table_.Integer(static_cast<std::int64_t>(folded >> 1 ^ (~(folded & 1) + 1)));
      }
      case SymbolCode::kFloat: {
        std::uint64_t bits = 0;
        for (int i = 0; i < 8; ++i) bits |= static_cast<std::uint64_t>(Byte()) << (8 * i);
        const double value = std::bit_cast<double>(bits);
        if (!std::isnan(value)) return table_.Float(value);
        Fail("a float is not a number");
        return {};
      }
      default:
        Fail(fmt::format("there is no kind {} of symbols", code));
        return {};
    }
  }

  Symbol SymbolOf() {
    const std::uint64_t number = Number();
    if (number < symbols_.size()) return symbols_[static_cast<std::size_t>(number)];
    Fail(fmt::format("there is no symbol {}", number));
    return {};
  }

  /// Reads an enumeration whose last value is `last`.
  template <typename Enum>
  Enum Code(std::uint8_t code, Enum last, std::string_view what) {
    if (code <= static_cast<std::uint8_t>(last)) return static_cast<Enum>(code);
    Fail(fmt::format("there is no {} {}", what, code));
    return {};
  }

  // Rules -------------------------------------------------------------------------------------------------------------

  void Rule(RuleDraft& rule, const std::vector<kernel::FileName>& files) {
    rule.name = arena_.Copy(Text("the rule's name"));
    if (rule.name.empty()) Fail("a rule has no name");
    if (failed()) return;
    rule_name_ = rule.name;
    table_.String(rule.name);
    const std::uint8_t flags = Byte();
    if (flags > 7) Fail("unknown flags");
    rule.has_documentation = (flags & 1) != 0;
    rule.interrupt = (flags & 2) != 0;
    rule.explain = (flags & 4) != 0;
    if (rule.has_documentation) rule.documentation = arena_.Copy(Text("the documentation"));
    rule.type = Code(Byte(), kernel::ProductionType::kTemplate, "type of rules");
    if (rule.type == kernel::ProductionType::kJustification) Fail("an image cannot hold justifications");
    rule.declared_support = Code(Byte(), kernel::DeclaredSupport::kISupport, "kind of support");
    const std::uint64_t file = Number();
    if (file < files.size())
      rule.file = files[static_cast<std::size_t>(file)];
    else
      Fail(fmt::format("there is no file {}", file));
    const std::uint64_t line = Number();
    if (line > 0x7FFFFFFF) Fail("the line is too large a number");
    rule.line = static_cast<int>(line & 0x7FFFFFFF);

    conditions_ = 0;
    Conditions(rule.conditions, 0);
    if (!failed() && (rule.conditions.empty() || rule.conditions.first->kind != ConditionKind::kPositive)) {
      Fail("the first condition must be a positive one");
    }
    if (failed()) return;
    Bind(rule);
    const std::size_t actions = Count("actions");
    for (std::size_t i = 0; i < actions && !failed(); ++i) {
      ActionDraft* const action = arena_.New<ActionDraft>();
      ActionOf(*action, rule);
      rule.actions.Add(action);
    }
    rule.is_rl = rule.type != kernel::ProductionType::kTemplate && rule.actions.first != nullptr &&
                 rule.actions.first == rule.actions.last &&
                 rule.actions.first->preference == PreferenceType::kNumericIndifferent;
  }

  void Conditions(kernel::DraftList<ConditionDraft>& conditions, int depth) {
    if (depth > kMaxNesting) {
      Fail("negations are nested too deeply");
      return;
    }
    const std::size_t count = Count("conditions");
    conditions_ += count;
    if (conditions_ > kMaxConditions) {
      Fail("a rule has too many conditions");
      return;
    }
    for (std::size_t i = 0; i < count && !failed(); ++i) {
      conditions.Add(arena_.New<ConditionDraft>());
      ConditionDraft& condition = *conditions.last;
      const std::uint8_t code = Byte();
      condition.tests_acceptable = (code & 0x80) != 0;
      condition.kind = Code(code & 0x7F, ConditionKind::kConjunctiveNegation, "kind of conditions");
      if (condition.kind == ConditionKind::kConjunctiveNegation) {
        Conditions(condition.conditions, depth + 1);
        if (!failed() && condition.conditions.empty()) Fail("a negated conjunction is empty");
        continue;
      }
      condition.id = TestOf(false);
      condition.attribute = TestOf(false);
      condition.value = TestOf(false);
      if (!failed() && !EqualitySymbol(condition.id).IsVariable()) Fail("a condition's object is not a variable");
    }
  }

  TestDraft TestOf(bool as_part) {
    TestDraft test;
    test.kind = Code(Byte(), TestKind::kLiteral, "kind of tests");
    switch (test.kind) {
      case TestKind::kBlank:
        if (as_part) Fail("a part of a test is blank");
        break;
      case TestKind::kState:
      case TestKind::kImpasse:
      case TestKind::kIsLti:
      case TestKind::kIsNotLti:
        break;
      case TestKind::kDisjunction:
        Disjuncts(test);
        break;
      case TestKind::kConjunction: {
        if (as_part) {
          Fail("a test within a test has parts");
          break;
        }
        const std::size_t count = Count("tests");
        int equalities = 0;
        for (std::size_t i = 0; i < count && !failed(); ++i) {
          test.parts.Add(arena_.New(TestOf(true)));
          equalities += test.parts.last->kind == TestKind::kEqual;
        }
        if (test.parts.empty() || equalities > 1) Fail("the parts of a test do not fit together");
        break;
      }
      default:
        test.referent = SymbolOf();
        break;
    }
    return test;
  }

  void Disjuncts(TestDraft& test) {
    const std::size_t count = Count("symbols");
    if (count == 0 || count > kMaxConditions) {
      Fail("a disjunction has a wrong size");
      return;
    }
    Symbol* const disjuncts = arena_.NewArray<Symbol>(count);
    for (std::size_t i = 0; i < count; ++i) {
      disjuncts[i] = SymbolOf();
      if (!failed() && !disjuncts[i].IsConstant()) Fail("a disjunction holds a variable");
    }
    test.disjuncts = disjuncts;
    test.disjunct_count = static_cast<std::uint32_t>(count);
  }

  // Actions -----------------------------------------------------------------------------------------------------------

  /// Notes the first binding of each variable.
  void Bind(const RuleDraft& rule) {
    sites_.clear();
    known_.clear();
    std::uint16_t position = 0;
    for (const ConditionDraft& condition : rule.conditions) {
      if (condition.kind != ConditionKind::kPositive) continue;
      const auto note = [&](const TestDraft& test, Field field) {
        if (const Symbol symbol = EqualitySymbol(test); symbol.IsVariable()) {
          sites_.emplace(symbol.bits(), BindingSite{position, field});
        }
      };
      note(condition.id, Field::kId);
      note(condition.attribute, Field::kAttribute);
      note(condition.value, Field::kValue);
      ++position;
    }
  }

  void ActionOf(ActionDraft& action, RuleDraft& rule) {
    const std::uint8_t code = Byte();
    if (code == 0x80) {
      action.is_function_call = true;
      action.value = ValueOf(rule, 0, true);
      if (!failed() && action.value.kind != RhsValueKind::kFunction) Fail("an action on its own calls no function");
      Ready(action.value);
      return;
    }
    action.preference = Code(code, PreferenceType::kWorse, "kind of preferences");
    action.id = ValueOf(rule, 0, false);
    if (!failed() && (!action.id.symbol.IsVariable() || !Known(action.id))) {
      Fail("an action's object is bound by no condition and made by no earlier action");
    }
    action.attribute = ValueOf(rule, 0, false);
    action.value = ValueOf(rule, 0, false);
    if (action.HasReferent()) action.referent = ValueOf(rule, 0, false);
    const bool is_operator =
        action.attribute.kind == RhsValueKind::kConstant && action.attribute.symbol == kernel::words::kOperator;
    if (action.preference != PreferenceType::kAcceptable && action.preference != PreferenceType::kReject &&
        !is_operator) {
      Fail("only the attribute operator takes this preference");
    }
    // A referent that is known only when the rule fires makes a binary preference until then.
    if (action.preference == PreferenceType::kNumericIndifferent &&
        !(action.referent.kind == RhsValueKind::kConstant && action.referent.symbol.IsNumber())) {
      Fail("a numeric preference has no number");
    }
    for (const ValueDraft* value : {&action.attribute, &action.value, &action.referent}) Ready(*value);
    for (const ValueDraft* value : {&action.attribute, &action.value, &action.referent}) {
      if (value->kind == RhsValueKind::kNew) known_.insert(value->symbol.bits());
    }
  }

  bool Known(const ValueDraft& value) const {
    return value.kind != RhsValueKind::kNew || known_.contains(value.symbol.bits());
  }

  /// The arguments of a function must be bound before it is called.
  void Ready(const ValueDraft& value) {
    for (const ValueDraft& argument : value.arguments) {
      if (!Known(argument)) Fail("a function's argument is bound by no condition and made by no earlier action");
      Ready(argument);
    }
  }

  ValueDraft ValueOf(RuleDraft& rule, int depth, bool as_action) {
    ValueDraft value;
    if (depth > kMaxNesting) {
      Fail("functions are nested too deeply");
      return value;
    }
    if (Code(Byte(), ValueCode::kLast, "kind of values") == ValueCode::kFunction) {
      value.kind = RhsValueKind::kFunction;
      Function(value, rule, depth, as_action);
      return value;
    }
    value.symbol = SymbolOf();
    if (!value.symbol.IsVariable()) return value;
    if (const auto site = sites_.find(value.symbol.bits()); site != sites_.end()) {
      value.kind = RhsValueKind::kBound;
      value.site = site->second;
      return value;
    }
    value.kind = RhsValueKind::kNew;
    std::vector<Symbol>& fresh = rule.new_identifiers;
    std::size_t index = 0;
    while (index < fresh.size() && fresh[index] != value.symbol) ++index;
    if (index >= kMaxConditions) Fail("a rule makes too many identifiers");
    if (index == fresh.size()) fresh.push_back(value.symbol);
    value.index = static_cast<std::uint16_t>(index);
    return value;
  }

  void Function(ValueDraft& value, RuleDraft& rule, int depth, bool as_action) {
    const std::string name = Text("a function's name");
    value.index = kernel::FindBuiltinFunction(name);
    if (!failed() && value.index == RhsValue::kUserFunction) {
      Fail("there is no function '" + name + "'");
    }
    const std::size_t count = Count("arguments");
    for (std::size_t i = 0; i < count && !failed(); ++i)
      value.arguments.Add(arena_.New(ValueOf(rule, depth + 1, false)));
    if (failed()) return;
    const kernel::BuiltinFunction& builtin = kernel::BuiltinFunctions()[value.index];
    if (as_action ? !builtin.as_action : !builtin.as_value) Fail("function '" + name + "' is not allowed here");
    if (builtin.arguments >= 0 && value.arguments.Count() != static_cast<std::uint32_t>(builtin.arguments)) {
      Fail("function '" + name + "' has a wrong number of arguments");
    }
  }

  std::string_view bytes_;
  kernel::SymbolTable& table_;
  bool make_;
  std::size_t place_ = 0;
  // The part that is being read, for messages.
  const char* part_ = nullptr;
  std::size_t number_ = 0;
  std::string_view rule_name_;
  std::string error_;
  std::size_t error_place_ = 0;
  std::vector<Symbol> symbols_;
  kernel::Arena arena_;                                   ///< Of the current rule.
  std::size_t conditions_ = 0;                            ///< Of the current rule, including nested ones.
  std::unordered_map<std::uint32_t, BindingSite> sites_;  ///< By variable.
  std::unordered_set<std::uint32_t> known_;               ///< Variables of identifiers that were created so far.
};

Diagnostic ImageProblem(const std::string& file, std::string message, std::string hint) {
  return ProblemIn(file, std::move(message), std::move(hint));
}

std::uint64_t Fixed(std::string_view bytes, std::size_t place, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < size; ++i) {
    number |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[place + i])) << (8 * i);
  }
  return number;
}

constexpr const char* kWriteAgain = "write it again with 'save rete-network --save FILE', or source the rules";

/// Checks the header; nothing: the payload is as its header says.
std::optional<Diagnostic> CheckHeader(std::string_view bytes, const std::string& file) {
  // The first line of an image of another Soar contains its name.
  if (bytes.substr(0, 32).find("CompactReteNet") != std::string_view::npos) {
    return ImageProblem(
        file, "this is an image that another Soar wrote: it holds that program's own match network",
        "source the rules that it was made from; with them, 'save rete-network' writes an image for Soarbox");
  }
  if (bytes.empty()) return ImageProblem(file, "the file is empty", kWriteAgain);
  const std::string_view start = bytes.substr(0, kMagic.size());
  if (start != kMagic) {
    if (start.substr(0, 13) == kMagic.substr(0, 13)) {
      return ImageProblem(file, "the line ends of this image were changed at byte 13: it was copied as if it were text",
                          "copy it as a binary file");
    }
    return ImageProblem(file, "this is not an image of rules: it does not begin with the mark of one",
                        "use 'source' for files with rules and commands");
  }
  if (bytes.size() < kHeaderSize) {
    return ImageProblem(file, fmt::format("the image ends within its header, at byte {}", bytes.size()), kWriteAgain);
  }
  if (const std::uint64_t version = Fixed(bytes, 16, 4); version != kVersion) {
    return ImageProblem(file, fmt::format("the image has format {}, this program reads format {}", version, kVersion),
                        kWriteAgain);
  }
  const std::string_view payload = bytes.substr(kHeaderSize);
  if (const std::uint64_t length = Fixed(bytes, 20, 8); length != payload.size()) {
    return ImageProblem(
        file,
        fmt::format("the image should have {} bytes after its header but has {}: it was cut or added to", length,
                    payload.size()),
        kWriteAgain);
  }
  if (Fixed(bytes, 28, 8) != Checksum(payload)) {
    return ImageProblem(file, "the checksum does not fit: the image was changed after it was written", kWriteAgain);
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<kernel::ProductionPtr>> ReadRuleImage(std::string_view bytes, const std::string& name,
                                                         kernel::SymbolTable& symbols) {
  if (std::optional<Diagnostic> problem = CheckHeader(bytes, name)) return *std::move(problem);
  const std::string_view payload = bytes.substr(kHeaderSize);
  {
    // First with a separate table, because a bad image must have no effect.
    kernel::SymbolTable scratch;
    Reader trial(payload, scratch, false);
    trial.Rules();
    if (trial.failed()) {
      return ImageProblem(name, fmt::format("byte {}: {}", kHeaderSize + trial.error_place(), trial.error()),
                          kWriteAgain);
    }
  }
  Reader reader(payload, symbols, true);
  return reader.Rules();
}

}  // namespace soarbox::cli
