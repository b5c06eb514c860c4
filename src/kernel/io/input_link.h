// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/plain_vector.h"
#include "kernel/base/symbol.h"
#include "kernel/base/symbol_table.h"
#include "kernel/memory/wme_changes.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

/// An object on the input side: the input link, an identifier that the client creates, or an existing identifier of the
/// kernel. Using an invalid handle has no effect. At init-soar all handles but kInputLink become invalid. New objects
/// may get the same handles again, so clients must forget the old ones.
enum class InputObject : std::uint32_t { kInputLink = 0, kNone = 0xFFFFFFFFu };
/// An element that a client created. The handle of a removed element is invalid. Its index is reused by other elements
/// with different handles (handles repeat after about 1,000 reuses).
enum class InputElement : std::uint32_t { kNone = 0xFFFFFFFFu };

/// The value of an input element: text, an integer, a float, or an object.
using InputValue = std::variant<std::string_view, std::int64_t, double, InputObject>;

class InputTap;

/// The elements that clients add to the input link. Calls are only buffered; the next input phase applies them in call
/// order, which determines the time tags. If several updates of an element are buffered, rules see only the last value.
/// If an element is added and removed between two input phases, no rule matches it, but it uses up a time tag (as in
/// Soar 9.6.3). The link is not a set: equal triples from two calls are two elements.
///
/// The kernel's identifier of a new object is created when the first element with the object as its value enters
/// working memory. Its letter is the first letter of that element's attribute (I if that is not a letter, or if it is
/// S). Working memory collects structure that loses its connection with the link, as usual; its handles become invalid.
class InputLink {
 public:
  InputLink(SymbolTable& symbols, WorkingMemory& memory, WmeChanges& changes)
      : symbols_(symbols), memory_(memory), changes_(changes) {}

  /// Creates an object. It is in working memory as soon as an element has it as its value.
  InputObject NewObject();
  /// Returns a handle for an identifier that is already in working memory (a command on the output link).
  InputObject ObjectFor(Symbol identifier);
  /// `tag` is a number of at most 53 bits by which the client identifies the element. The link only stores it.
  InputElement Add(InputObject parent, std::string_view attribute, const InputValue& value, std::int64_t tag = 0);
  /// Removes the element and adds one with the new value and tag. The handle stays valid.
  void Update(InputElement element, const InputValue& value, std::int64_t tag = 0);
  /// Same for constants; cheaper.
  void Update(InputElement element, std::string_view value, std::int64_t tag = 0) {
    if (Retag(element, tag)) BufferUpdate(element, symbols_.String(value));
  }
  void Update(InputElement element, std::int64_t value, std::int64_t tag = 0) {
    if (Retag(element, tag)) BufferUpdate(element, symbols_.Integer(value));
  }
  void Update(InputElement element, double value, std::int64_t tag = 0) {
    if (Retag(element, tag)) BufferUpdate(element, symbols_.Float(value));
  }
  void Remove(InputElement element);

  /// The working memory element of a handle; kNone before the input phase that adds it and after its removal.
  WmeId Wme(InputElement element) const;
  /// The kernel's identifier of an object; none before the input phase that creates it.
  Symbol Identifier(InputObject object) const;
  bool HasPendingChanges() const { return !pending_.empty(); }
  /// Calls `visit(element, wme, tag)` for each element that has a tag, in unspecified order. `wme` is kNone before the
  /// input phase that adds it.
  template <typename Visit>
  void ForEachTagged(Visit visit) const {
    for (std::uint32_t place = 0; place < elements_.size(); ++place) {
      const Element& element = elements_[place];
      if (element.live && element.tag != 0) visit(HandleOf(place), element.wme, element.tag);
    }
  }

  /// The tap records or replays input (input_tap.h); null for none. Not owned: reset it before it is destroyed.
  void SetTap(InputTap* tap) { tap_ = tap; }
  InputTap* tap() const { return tap_; }
  /// Discards the buffered changes. Handles of elements that they would have added become invalid.
  void DropPending();

  /// For the core. Apply: applies the buffered changes (input phase). `unheard`: no observer or module needs individual
  /// elements, and no match waits for its retraction. Reset: forgets everything and uses the identifier of a new input
  /// link (init-soar). Forget, IdentifierGone: working memory removed an element or an identifier. Mark: calls `mark`
  /// for each symbol in use.
  void Apply(bool unheard);
  void Reset(Symbol input_link);
  [[gnu::noinline]] void Forget(std::uint32_t element);
  void IdentifierGone(Symbol identifier);
  template <typename MarkSymbol>
  void Mark(MarkSymbol mark) const {
    for (const Pending& change : pending_) {
      if (change.constant) mark(change.constant);
    }
    for (const Element& element : elements_) {
      if (element.live || element.buffered > 0) mark(element.attribute);
    }
    for (const Object& object : objects_) {
      if (object.identifier) mark(object.identifier);
    }
  }

 private:
  static constexpr std::uint32_t kNoPlace = 0xFFFFFFFFu;
  static constexpr std::uint32_t kPlaceBits = 22, kGenerationBits = 32 - kPlaceBits;
  static constexpr std::uint32_t kPlaceMask = (1u << kPlaceBits) - 1;
  static constexpr std::uint32_t kGenerationMask = (1u << kGenerationBits) - 1;
  enum class Change : std::uint8_t { kAdd, kRemove, kUpdate };
  struct Element {
    WmeId wme = WmeId::kNone;
    InputObject parent = InputObject::kNone;
    Symbol attribute;
    std::uint32_t buffered = 0;  ///< Number of its buffered changes.
    std::uint64_t live : 1 = 0;  ///< The handle is valid.
    std::uint64_t generation : kGenerationBits = 0;
    std::int64_t tag : 63 - kGenerationBits = 0;
  };
  struct Pending {
    Change change = Change::kAdd;
    std::uint32_t element = 0;
    Symbol constant;  ///< kUpdate, and kAdd with a constant value.
    InputObject object = InputObject::kNone;
  };
  struct Object {
    Symbol identifier;
    bool live = false;
    std::uint32_t generation = 0;
  };

  InputElement HandleOf(std::uint32_t place) const {
    return static_cast<InputElement>(place | static_cast<std::uint32_t>(elements_[place].generation) << kPlaceBits);
  }
  Element* Find(InputElement element);
  const Element* Find(InputElement element) const;
  Object* Find(InputObject object);
  const Object* Find(InputObject object) const;
  InputObject MakeObject(Symbol identifier);
  Symbol Constant(const InputValue& value);
  /// Returns false if the handle is invalid.
  bool Retag(InputElement element, std::int64_t tag);
  void BufferUpdate(InputElement element, Symbol value) {
    Buffer(Change::kUpdate, static_cast<std::uint32_t>(element) & kPlaceMask, value);
  }
  void Buffer(Change kind, std::uint32_t place, Symbol constant = {}, InputObject object = InputObject::kNone);
  void LoseElement(std::uint32_t place);
  void MakeElement(const Pending& change);
  void ApplyChange(const Pending& change);
  [[gnu::noinline]] void ApplyTapped(const Pending& change);
  void Void(Element& element);
  void ReleaseIfDone(std::uint32_t place);

  SymbolTable& symbols_;
  WorkingMemory& memory_;
  WmeChanges& changes_;
  InputTap* tap_ = nullptr;
  std::vector<Object> objects_;
  std::vector<std::uint32_t> free_objects_;
  PlainVector<Element> elements_;
  std::uint32_t first_generation_ = 0;  ///< Of new elements; increased by init-soar, so that old handles are invalid.
  std::vector<std::uint32_t> free_elements_;
  std::vector<Pending> pending_;
  std::vector<std::uint32_t> object_of_;  ///< By identifier index: index of its object, or kNoPlace.
};

}  // namespace soarbox::kernel
