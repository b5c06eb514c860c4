// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/base/symbol_table.h"

#include <array>
#include <bit>
#include <cstring>
#include <utility>
#include <vector>

#include "kernel/base/constant_pool.h"
#include "kernel/base/known_symbols.h"
#include "kernel/base/text_arena.h"

namespace soarbox::kernel {

namespace {

template <typename Word>
std::uint64_t WordAt(const char* text) {
  Word word;
  std::memcpy(&word, text, sizeof(word));
  return word;
}

/// Reads eight characters at a time. The last step re-reads some characters instead of reading fewer.
std::uint32_t HashText(std::string_view text) {
  constexpr std::uint64_t kFactor = 0x9E3779B97F4A7C15ull;
  const char* at = text.data();
  std::size_t left = text.size();
  std::uint64_t hash = left * kFactor;
  for (; left > 8; at += 8, left -= 8) {
    hash = std::rotl(hash ^ WordAt<std::uint64_t>(at), 29) * kFactor;
  }
  std::uint64_t last = 0;
  if (left == 8) {
    last = WordAt<std::uint64_t>(at);
  } else if (left >= 4) {
    last = WordAt<std::uint32_t>(at) << 32 | WordAt<std::uint32_t>(at + left - 4);
  } else if (left > 0) {
    last =
        WordAt<std::uint8_t>(at) << 16 | WordAt<std::uint8_t>(at + left / 2) << 8 | WordAt<std::uint8_t>(at + left - 1);
  }
  hash = (hash ^ last) * kFactor;
  hash = (hash ^ hash >> 32) * kFactor;
  return static_cast<std::uint32_t>(hash >> 32);
}

}  // namespace

/// The constants of a table, by kind. `small_integers` contains no values (the handles contain them) but the stamps of
/// the small integers that rules mention; its indices have no meaning.
struct ConstantPools {
  ConstantPool<TextEntry> strings, variables;
  ConstantPool<NumberEntry> large_integers, floats, small_integers;
  std::uint32_t next_stamp = 1;
};

struct FrozenSymbols {
  ConstantPools pools;
  TextArena texts;
};

namespace {

/// The initial base of every table: the words of the architecture and the first integers.
std::shared_ptr<const FrozenSymbols> Predefined() {
  static const std::shared_ptr<const FrozenSymbols> kPredefined = [] {
    auto frozen = std::make_shared<FrozenSymbols>();
    ConstantPools& pools = frozen->pools;
    const PoolMarks marks{PoolMarks::kLive | PoolMarks::kPinned};
    for (std::size_t i = 0; i < kPredefinedWords.size(); ++i) {
      if (i == kPredefinedBeforeIntegers) {
        for (std::uint64_t value = 0; value <= 100; ++value) {
          pools.small_integers.Add({value, pools.next_stamp++, marks});
        }
      }
      const std::string_view word = kPredefinedWords[i];
      pools.strings.Add(
          {word.data(), static_cast<std::uint32_t>(word.size()), HashText(word), pools.next_stamp++, marks});
    }
    return frozen;
  }();
  return kPredefined;
}

/// The number of entries of `own` that a new base takes over: all before the first unpinned one.
template <typename Entry>
std::size_t FreezablePrefix(const ConstantPool<Entry>& own) {
  std::size_t count = 0;
  while (count < own.entries().size() && own.entries()[count].marks.Pinned()) {
    ++count;
  }
  return count;
}

bool Same(const TextEntry& a, const TextEntry& b) {
  return a.stamp == b.stamp && a.View() == b.View();
}
bool Same(const NumberEntry& a, const NumberEntry& b) {
  return a.stamp == b.stamp && a.bits == b.bits;
}

/// Returns true if every own entry is pinned and is in `base` under the same index.
template <typename Entry>
bool CoveredBy(const ConstantPool<Entry>& own, const ConstantPool<Entry>& base) {
  if (own.end_index() > base.end_index()) {
    return false;
  }
  for (std::uint32_t index = own.first_index(); index < own.end_index(); ++index) {
    if (!own[index].marks.Pinned() || !Same(own[index], base[index])) {
      return false;
    }
  }
  return true;
}

template <typename Entry>
ConstantPool<Entry> Joined(const ConstantPool<Entry>& base, const ConstantPool<Entry>& own, std::size_t count) {
  std::vector<Entry> entries = base.entries();
  entries.insert(entries.end(), own.entries().begin(), own.entries().begin() + static_cast<std::ptrdiff_t>(count));
  ConstantPool<Entry> joined;
  joined.Reset(0, std::move(entries));
  return joined;
}

template <typename Entry>
void DropFront(ConstantPool<Entry>& own, std::size_t count) {
  std::vector<Entry> rest(own.entries().begin() + static_cast<std::ptrdiff_t>(count), own.entries().end());
  own.Reset(own.first_index() + static_cast<std::uint32_t>(count), std::move(rest));
}

}  // namespace

struct SymbolTable::Contents {
  std::shared_ptr<const FrozenSymbols> base = Predefined();
  ConstantPools own;
  TextArena texts;
  std::size_t unpinned = 0;
  std::uint64_t digest = 0;

  /// A cache of recently used variables with short names, indexed by the characters of the name. Rules use the same few
  /// names.
  struct RecentVariable {
    std::uint64_t characters = 0;
    std::uint32_t length = 0;
    Symbol variable;
  };
  static constexpr int kRecentBits = 6;
  static constexpr std::size_t kLeastRecent = 3, kMostRecent = 8;  ///< Of the names, in characters.
  std::array<RecentVariable, std::size_t{1} << kRecentBits> recent_variables;

  /// Indices at which FindIdentifier last found a name, by letter and number. Each is checked before it is used.
  std::array<std::uint32_t, 64> found_identifiers{};

  Contents() { RestartAboveBase(); }

  void RestartAboveBase() {
    own.strings.Reset(base->pools.strings.end_index(), {});
    own.variables.Reset(base->pools.variables.end_index(), {});
    own.large_integers.Reset(base->pools.large_integers.end_index(), {});
    own.floats.Reset(base->pools.floats.end_index(), {});
    own.small_integers.Reset(base->pools.small_integers.end_index(), {});
    own.next_stamp = base->pools.next_stamp;
  }

  template <typename Entry>
  const Entry& At(const ConstantPool<Entry>& in_base, const ConstantPool<Entry>& in_own, std::uint32_t index) const {
    return index < in_own.first_index() ? in_base[index] : in_own[index];
  }
  const TextEntry& Text(Symbol symbol) const {
    return symbol.IsVariable() ? At(base->pools.variables, own.variables, symbol.index())
                               : At(base->pools.strings, own.strings, symbol.index());
  }

  /// Pins the entry and adds it to the digest.
  template <typename Entry>
  void Pin(Entry& entry, Symbol::Tag tag, std::uint32_t index) {
    if (entry.marks.Pinned()) {
      return;
    }
    entry.marks.bits |= PoolMarks::kPinned;
    const std::uint64_t what = (std::uint64_t{Symbol(tag, index).bits()} << 32) | entry.Hash();
    digest = (std::rotl(digest, 5) ^ what) * 0x9E3779B97F4A7C15ull;
  }

  template <typename Entry, typename Key, typename Make>
  Symbol Intern(const ConstantPool<Entry>& in_base, ConstantPool<Entry>& in_own, Symbol::Tag tag, std::uint32_t hash,
                const Key& key, bool pin, Make make) {
    std::uint32_t index = in_base.Find(hash, key);
    if (index != ConstantPool<Entry>::kNotFound) {
      return Symbol(tag, index);
    }
    index = in_own.FindOrAdd(hash, key, [&] {
      ++unpinned;
      return make(own.next_stamp++);
    });
    if (pin && !in_own[index].marks.Pinned()) {
      Pin(in_own[index], tag, index);
      --unpinned;
    }
    return Symbol(tag, index);
  }

  Symbol InternText(const ConstantPool<TextEntry>& in_base, ConstantPool<TextEntry>& in_own, Symbol::Tag tag,
                    std::string_view text, bool pin) {
    const std::uint32_t hash = HashText(text);
    return Intern(in_base, in_own, tag, hash, text, pin, [&](std::uint32_t stamp) {
      return TextEntry{texts.Store(text), static_cast<std::uint32_t>(text.size()), hash, stamp, {PoolMarks::kLive}};
    });
  }

  Symbol InternVariable(std::string_view name) {
    return InternText(base->pools.variables, own.variables, Symbol::Tag::kVariable, name, true);
  }

  Symbol InternNumber(const ConstantPool<NumberEntry>& in_base, ConstantPool<NumberEntry>& in_own, Symbol::Tag tag,
                      std::uint64_t bits, bool pin) {
    return Intern(in_base, in_own, tag, NumberEntry::HashOf(bits), bits, pin, [&](std::uint32_t stamp) {
      return NumberEntry{bits, stamp, {PoolMarks::kLive}};
    });
  }

  /// Frees the entries that are neither pinned nor marked, and clears the marks.
  template <typename Entry, typename Release>
  void Sweep(ConstantPool<Entry>& pool, Release release) {
    unpinned -= pool.FreeIf([&](Entry& entry) {
      if ((entry.marks.bits & (PoolMarks::kPinned | PoolMarks::kMarked)) == 0) {
        release(entry);
        return true;
      }
      entry.marks.bits &= static_cast<std::uint8_t>(~PoolMarks::kMarked);
      return false;
    });
  }
};

SymbolTable::SymbolTable() : contents_(std::make_unique<Contents>()) {
  next_number_.fill(1);
}
SymbolTable::~SymbolTable() = default;
SymbolTable::SymbolTable(SymbolTable&&) noexcept = default;
SymbolTable& SymbolTable::operator=(SymbolTable&&) noexcept = default;

Symbol SymbolTable::String(std::string_view text) {
  Contents& c = *contents_;
  return c.InternText(c.base->pools.strings, c.own.strings, Symbol::Tag::kString, text, pinning_);
}

Symbol SymbolTable::Variable(std::string_view name) {
  Contents& c = *contents_;
  const std::size_t length = name.size();
  if (length >= Contents::kLeastRecent && length <= Contents::kMostRecent) {
    const std::uint64_t characters =
        length == 3 ? WordAt<std::uint16_t>(name.data()) << 8 | WordAt<std::uint8_t>(name.data() + 2)
                    : WordAt<std::uint32_t>(name.data()) << 32 | WordAt<std::uint32_t>(name.data() + length - 4);
    constexpr int kShift = 64 - Contents::kRecentBits;
    Contents::RecentVariable& recent = c.recent_variables[characters * 0x9E3779B97F4A7C15ull >> kShift];
    if (recent.characters != characters || recent.length != length) {
      recent = {characters, static_cast<std::uint32_t>(length), c.InternVariable(name)};
    }
    return recent.variable;
  }
  return c.InternVariable(name);
}

Symbol SymbolTable::InternInteger(std::int64_t value) {
  Contents& c = *contents_;
  const std::uint64_t bits = static_cast<std::uint64_t>(value);
  if (!Symbol::FitsInHandle(value)) {
    return c.InternNumber(c.base->pools.large_integers, c.own.large_integers, Symbol::Tag::kLargeInteger, bits,
                          pinning_);
  }
  if (pinning_) {
    c.InternNumber(c.base->pools.small_integers, c.own.small_integers, Symbol::Tag::kSmallInteger, bits, true);
  }
  return Symbol::SmallInteger(value);
}

Symbol SymbolTable::Float(double value) {
  Contents& c = *contents_;
  return c.InternNumber(c.base->pools.floats, c.own.floats, Symbol::Tag::kFloat, std::bit_cast<std::uint64_t>(value),
                        pinning_);
}

Symbol SymbolTable::FindString(std::string_view text) const {
  const Contents& c = *contents_;
  const std::uint32_t hash = HashText(text);
  std::uint32_t index = c.base->pools.strings.Find(hash, text);
  if (index == ConstantPool<TextEntry>::kNotFound) {
    index = c.own.strings.Find(hash, text);
  }
  return index == ConstantPool<TextEntry>::kNotFound ? Symbol() : Symbol(Symbol::Tag::kString, index);
}

std::string_view SymbolTable::Text(Symbol symbol) const {
  return contents_->Text(symbol).View();
}

std::int64_t SymbolTable::LargeIntegerValue(Symbol symbol) const {
  const Contents& c = *contents_;
  return static_cast<std::int64_t>(c.At(c.base->pools.large_integers, c.own.large_integers, symbol.index()).bits);
}

double SymbolTable::FloatValue(Symbol symbol) const {
  const Contents& c = *contents_;
  return std::bit_cast<double>(c.At(c.base->pools.floats, c.own.floats, symbol.index()).bits);
}

std::uint32_t SymbolTable::Stamp(Symbol constant) const {
  const Contents& c = *contents_;
  switch (constant.tag()) {
    case Symbol::Tag::kString:
      return c.Text(constant).stamp;
    case Symbol::Tag::kLargeInteger:
      return c.At(c.base->pools.large_integers, c.own.large_integers, constant.index()).stamp;
    case Symbol::Tag::kFloat:
      return c.At(c.base->pools.floats, c.own.floats, constant.index()).stamp;
    case Symbol::Tag::kSmallInteger: {
      const std::uint64_t bits = static_cast<std::uint64_t>(constant.SmallValue());
      const std::uint32_t hash = NumberEntry::HashOf(bits);
      for (const ConstantPool<NumberEntry>* pool : {&c.base->pools.small_integers, &c.own.small_integers}) {
        const std::uint32_t index = pool->Find(hash, bits);
        if (index != ConstantPool<NumberEntry>::kNotFound) {
          return (*pool)[index].stamp;
        }
      }
      return 0;
    }
    default:
      return 0;
  }
}

Symbol SymbolTable::NewIdentifier(char letter, std::uint64_t number) {
  std::uint64_t& next = next_number_[static_cast<std::size_t>(letter - 'A')];
  if (number >= next) {
    next = number + 1;
  }
  return PlaceIdentifier(letter, number);
}

Symbol SymbolTable::FindIdentifier(char letter, std::uint64_t number) const {
  if (letter == 0) return {};
  const auto is_at = [&](std::size_t i) {
    return identifiers_[i].letter == letter && identifiers_[i].number == number;
  };
  auto& found = contents_->found_identifiers;
  std::uint32_t& at = found[(number + static_cast<unsigned char>(letter) * 7u) % found.size()];
  if (at >= identifiers_.size() || !is_at(at)) {
    // A name that is not in the cache is usually that of a new identifier, and new identifiers are at the end.
    std::size_t i = identifiers_.size();
    while (i > 0 && !is_at(i - 1)) --i;
    if (i == 0) return {};
    at = static_cast<std::uint32_t>(i - 1);
  }
  return Symbol(Symbol::Tag::kIdentifier, at);
}

void SymbolTable::ResetIdentifierCounters() {
  next_number_.fill(1);
  identifiers_.clear();
  free_identifiers_.clear();
}

std::strong_ordering SymbolTable::Compare(Symbol left, Symbol right) const {
  if (left.IsInteger() && right.IsInteger()) {
    return IntegerValue(left) <=> IntegerValue(right);
  }
  if (left.IsNumber() && right.IsNumber()) {
    const double a = NumberValue(left), b = NumberValue(right);
    return a > b ? std::strong_ordering::greater : a == b ? std::strong_ordering::equal : std::strong_ordering::less;
  }
  if (left.kind() == right.kind() && (left.IsString() || left.IsVariable())) {
    return Text(left).compare(Text(right)) <=> 0;
  }
  if (left.IsIdentifier() && right.IsIdentifier()) {
    if (Letter(left) != Letter(right)) {
      return Letter(left) <=> Letter(right);
    }
    return Number(left) <=> Number(right);
  }
  return std::strong_ordering::less;
}

SymbolTable::PinScope::PinScope(SymbolTable& table) : table_(table), before_(table.pinning_) {
  table.pinning_ = true;
}
SymbolTable::PinScope::~PinScope() {
  table_.pinning_ = before_;
}

bool SymbolTable::IsLive(Symbol symbol) const {
  const ConstantPools &own = contents_->own, &base = contents_->base->pools;
  const auto in = [&](const auto& mine, const auto& shared) {
    if (symbol.index() < mine.first_index()) return symbol.index() < shared.end_index();
    return symbol.index() < mine.end_index() && mine[symbol.index()].marks.Live();
  };
  switch (symbol.tag()) {
    case Symbol::Tag::kString:
      return in(own.strings, base.strings);
    case Symbol::Tag::kVariable:
      return in(own.variables, base.variables);
    case Symbol::Tag::kLargeInteger:
      return in(own.large_integers, base.large_integers);
    case Symbol::Tag::kFloat:
      return in(own.floats, base.floats);
    case Symbol::Tag::kIdentifier:
      return symbol.index() < identifiers_.size() && identifiers_[symbol.index()].letter != 0;
    default:
      return static_cast<bool>(symbol);
  }
}

void SymbolTable::BeginMark() {
  const ConstantPools& own = contents_->own;
  sweepable_from_.fill(0xFFFFFFFFu);
  sweepable_from_[static_cast<std::size_t>(Symbol::Tag::kString)] = own.strings.first_index();
  sweepable_from_[static_cast<std::size_t>(Symbol::Tag::kLargeInteger)] = own.large_integers.first_index();
  sweepable_from_[static_cast<std::size_t>(Symbol::Tag::kFloat)] = own.floats.first_index();
}

void SymbolTable::MarkOwn(Symbol symbol) {
  Contents& c = *contents_;
  const auto mark = [&](auto& pool) { pool[symbol.index()].marks.bits |= PoolMarks::kMarked; };
  switch (symbol.tag()) {
    case Symbol::Tag::kString:
      mark(c.own.strings);
      break;
    case Symbol::Tag::kLargeInteger:
      mark(c.own.large_integers);
      break;
    case Symbol::Tag::kFloat:
      mark(c.own.floats);
      break;
    default:
      break;
  }
}

void SymbolTable::Sweep() {
  Contents& c = *contents_;
  c.Sweep(c.own.strings, [&](const TextEntry& entry) { c.texts.Release(entry.text, entry.length); });
  c.Sweep(c.own.large_integers, [](const NumberEntry&) {});
  c.Sweep(c.own.floats, [](const NumberEntry&) {});
}

std::size_t SymbolTable::UnpinnedCount() const {
  return contents_->unpinned;
}
std::uint64_t SymbolTable::Digest() const {
  return contents_->digest;
}

std::shared_ptr<const FrozenSymbols> SymbolTable::Freeze() {
  Contents& c = *contents_;
  const std::size_t strings = FreezablePrefix(c.own.strings);
  const std::size_t variables = FreezablePrefix(c.own.variables);
  const std::size_t large = FreezablePrefix(c.own.large_integers);
  const std::size_t floats = FreezablePrefix(c.own.floats);
  const std::size_t small = FreezablePrefix(c.own.small_integers);
  if (strings + variables + large + floats + small == 0) {
    return c.base;
  }
  auto frozen = std::make_shared<FrozenSymbols>();
  const ConstantPools& base = c.base->pools;
  ConstantPools& pools = frozen->pools;
  pools.next_stamp = c.own.next_stamp;

  // The texts are moved to the frozen base, because the old base may be destroyed.
  std::vector<TextEntry> entries;
  const auto take_texts = [&](const ConstantPool<TextEntry>& from_base, ConstantPool<TextEntry>& own, std::size_t count,
                              ConstantPool<TextEntry>& to) {
    to = Joined(from_base, own, count);
    for (std::uint32_t index = 0; index < to.end_index(); ++index) {
      const std::string_view text = to[index].View();
      to[index].text = frozen->texts.Store(text);
      if (index >= own.first_index()) {
        c.texts.Release(text.data(), text.size());
      }
    }
    DropFront(own, count);
  };
  take_texts(base.strings, c.own.strings, strings, pools.strings);
  take_texts(base.variables, c.own.variables, variables, pools.variables);
  const auto take_numbers = [](const ConstantPool<NumberEntry>& from_base, ConstantPool<NumberEntry>& own,
                               std::size_t count, ConstantPool<NumberEntry>& to) {
    to = Joined(from_base, own, count);
    DropFront(own, count);
  };
  take_numbers(base.large_integers, c.own.large_integers, large, pools.large_integers);
  take_numbers(base.floats, c.own.floats, floats, pools.floats);
  take_numbers(base.small_integers, c.own.small_integers, small, pools.small_integers);
  c.base = frozen;
  return frozen;
}

bool SymbolTable::Adopt(std::shared_ptr<const FrozenSymbols> base) {
  Contents& c = *contents_;
  const ConstantPools& pools = base->pools;
  // Our base must be a part of the new one. This is certain only if it is the predefined base or the new base itself.
  if (c.base != base && c.base != Predefined()) {
    return false;
  }
  if (c.base == base) {
    return true;
  }
  if (!CoveredBy(c.own.strings, pools.strings) || !CoveredBy(c.own.variables, pools.variables) ||
      !CoveredBy(c.own.large_integers, pools.large_integers) || !CoveredBy(c.own.floats, pools.floats) ||
      !CoveredBy(c.own.small_integers, pools.small_integers)) {
    return false;
  }
  c.base = std::move(base);
  c.texts = TextArena();
  c.unpinned = 0;
  c.RestartAboveBase();
  return true;
}

void SymbolTable::LimitTexts(std::size_t bytes) {
  contents_->texts.Limit(bytes);
}

std::size_t SymbolTable::MemoryBytes() const {
  const Contents& c = *contents_;
  return sizeof(Contents) + c.texts.MemoryBytes() + c.own.strings.MemoryBytes() + c.own.variables.MemoryBytes() +
         c.own.large_integers.MemoryBytes() + c.own.floats.MemoryBytes() + c.own.small_integers.MemoryBytes() +
         identifiers_.capacity() * sizeof(IdentifierEntry) + free_identifiers_.capacity() * sizeof(std::uint32_t);
}

}  // namespace soarbox::kernel
