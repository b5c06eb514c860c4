// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <list>  // Soar's header includes it, too.
#include <string>

#include "Export.h"

namespace sml {

class Agent;
class Identifier;
class IdentifierSymbol;
class IntElement;
class FloatElement;
class StringElement;
class WorkingMemory;
template <typename T>
class ObjectPool;

/// An element of working memory as a client sees it: input that it made, or output that its agent made.
///
/// Objects belong to their agent. One that was destroyed, or removed from the output link, is kept for a while as a
/// dead object: calls on it and with it fail with an error of the agent, they do not crash.
class EXPORT WMElement {
 public:
  virtual ~WMElement();

  /// True for output that arrived since the list of changes was last cleared.
  bool IsJustAdded();

  /// The identifier that this element hangs on; NULL for the input link and the output link themselves.
  IdentifierSymbol* GetParent() const { return parent_; }
  IdentifierSymbol* GetIdentifier() const { return parent_; }
  /// Its name ("I2").
  char const* GetIdentifierName() const;

  char const* GetAttribute() const { return attribute_; }

  /// "string", "int", "double" or "id".
  virtual char const* GetValueType() const = 0;
  /// The value as text. Numbers: valid until the next call of this function for a number.
  virtual char const* GetValueAsString() const = 0;
  /// The same, written to the buffer and returned from there.
  virtual char const* GetValueAsString(std::string& buf) const = 0;

  /// Negative for elements that a client made, positive for those of the agent. Changes with every update.
  long long GetTimeTag() const { return time_tag_; }

  virtual bool IsIdentifier() const { return false; }
  virtual Identifier* ConvertToIdentifier() { return nullptr; }
  virtual IntElement* ConvertToIntElement() { return nullptr; }
  virtual FloatElement* ConvertToFloatElement() { return nullptr; }
  virtual StringElement* ConvertToStringElement() { return nullptr; }

  Agent* GetAgent();

  /// As Agent::DestroyWME(this).
  bool DestroyWME();

  /// Appends a line for people.
  void DebugString(std::string& result);

#ifndef SOARBOX_PUBLIC_API_ONLY
  /// A number that no other element of this process has or had; 0 once the element is a dead object. While its agent is
  /// there, it can be asked of any element that was one of that agent. Not part of the interface of Soar 9.6.3.
  unsigned long long GetLife() const {
    return life_;
  }
#endif

  WMElement(WMElement const&) = delete;
  WMElement& operator=(WMElement const&) = delete;

 protected:
  enum class Kind : unsigned char { kString, kInt, kFloat, kIdentifier };
  explicit WMElement(Kind kind)
      : kind_(kind), just_added_(false), live_(false), output_(false), owns_attribute_(false) {}

 private:
  friend class WorkingMemory;
  friend class IdentifierSymbol;
  friend class ChildIterator;
  template <typename T>
  friend class ObjectPool;

  IdentifierSymbol* parent_ = nullptr;
  char const* attribute_ = "";
  WMElement* next_ = nullptr;  ///< Of the parent's children; of a dead object: see ObjectPool.
  union {
    WMElement* previous_ = nullptr;  ///< If it has a parent.
    Agent* agent_;                   ///< If it has none.
  };
  long long time_tag_ = 0;
  unsigned long long life_ = 0;
  unsigned int input_ = 0;  ///< Its handle on the way to the kernel.
  Kind kind_;
  bool just_added_ : 1;
  bool live_ : 1;            ///< False for dead objects.
  bool output_ : 1;          ///< Made by the agent.
  bool owns_attribute_ : 1;  ///< Else it is one that all agents share.
};

}  // namespace sml
