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

/// An element of working memory from a client's view: input that the client created, or output of its agent.
///
/// Elements belong to their agent. An element that was destroyed, or removed from the output link, is kept for a while
/// as a dead object: calls that use it fail with an error of the agent instead of crashing.
class EXPORT WMElement {
 public:
  virtual ~WMElement();

  /// Returns true for output that was added since the list of changes was last cleared.
  bool IsJustAdded();

  /// The identifier that this element belongs to; NULL for the input link and the output link themselves.
  IdentifierSymbol* GetParent() const { return parent_; }
  IdentifierSymbol* GetIdentifier() const { return parent_; }
  /// The name of that identifier ("I2").
  char const* GetIdentifierName() const;

  char const* GetAttribute() const { return attribute_.c_str(); }

  /// "string", "int", "double" or "id".
  virtual char const* GetValueType() const = 0;
  /// The value as text. For numbers, valid until the next call of this function for a number.
  virtual char const* GetValueAsString() const = 0;
  /// Same, but written to `buf`; returns the text of `buf`.
  virtual char const* GetValueAsString(std::string& buf) const = 0;

  /// Negative for elements of clients, positive for those of the agent. Changes with every update.
  long long GetTimeTag() const { return time_tag_; }

  virtual bool IsIdentifier() const { return false; }
  virtual Identifier* ConvertToIdentifier() { return nullptr; }
  virtual IntElement* ConvertToIntElement() { return nullptr; }
  virtual FloatElement* ConvertToFloatElement() { return nullptr; }
  virtual StringElement* ConvertToStringElement() { return nullptr; }

  Agent* GetAgent();

  /// Same as Agent::DestroyWME(this).
  bool DestroyWME();

  /// Appends a readable description.
  void DebugString(std::string& result);

#ifndef SOARBOX_PUBLIC_API_ONLY
  /// A number that is unique among all elements that this process ever creates; 0 for dead objects. May be called for
  /// any element of an existing agent, even a dead one. Not part of the interface of Soar 9.6.3.
  unsigned long long GetLife() const {
    return life_;
  }
#endif

  WMElement(WMElement const&) = delete;
  WMElement& operator=(WMElement const&) = delete;

 protected:
  enum class Kind : unsigned char { kString, kInt, kFloat, kIdentifier };
  explicit WMElement(Kind kind) : kind_(kind), just_added_(false), live_(false), output_(false) {}

 private:
  friend class WorkingMemory;
  friend class IdentifierSymbol;
  friend class ChildIterator;
  template <typename T>
  friend class ObjectPool;

  IdentifierSymbol* parent_ = nullptr;
  std::string attribute_;
  WMElement* next_ = nullptr;  ///< The next child of the parent; for dead objects see ObjectPool.
  union {
    WMElement* previous_ = nullptr;  ///< If it has a parent.
    Agent* agent_;                   ///< If it has no parent.
  };
  long long time_tag_ = 0;
  unsigned long long life_ = 0;
  unsigned int input_ = 0;  ///< Its handle in the connection to the kernel.
  Kind kind_;
  bool just_added_ : 1;
  bool live_ : 1;    ///< False for dead objects.
  bool output_ : 1;  ///< The agent created it.
};

}  // namespace sml
