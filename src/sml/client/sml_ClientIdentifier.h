// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sml_ClientFloatElement.h"
#include "sml_ClientIntElement.h"
#include "sml_ClientStringElement.h"
#include "sml_ClientWMElement.h"
#include "soarbox_ChildIterator.h"

namespace sml {

class Identifier;
class OutputDeltaList;

/// An identifier and its children. Elements with the same identifier as their value share one IdentifierSymbol, which
/// is destroyed with the last of them.
class EXPORT IdentifierSymbol {
 public:
  IdentifierSymbol(IdentifierSymbol const&) = delete;
  IdentifierSymbol& operator=(IdentifierSymbol const&) = delete;
  ~IdentifierSymbol();

  char const* GetIdentifierSymbol() { return Name(); }
  void SetIdentifierSymbol(char const* pID);

  /// Returns true if children were added or removed since the list of output changes was last cleared.
  bool AreChildrenModified() { return children_modified_; }
  void SetAreChildrenModified(bool state) { children_modified_ = state; }

  void UsedBy(Identifier* pIdentifier);
  void NoLongerUsedBy(Identifier* pIdentifier);
  bool IsFirstUser(Identifier* pIdentifier) { return first_user_ && first_user_ == pIdentifier; }
  Identifier* GetFirstUser() { return first_user_; }
  int GetNumberUsing();

  void AddChild(WMElement* pWME);
  void RemoveChild(WMElement* pWME);
  WMElement* GetChildByTimeTag(long long timeTag);
  /// Moves all children of the other symbol to this one.
  void TransferChildren(IdentifierSymbol* pFrom);
  /// Removes all children locally, without removing them from the agent.
  void DeleteAllChildren();

  void DebugString(std::string& result);

#ifndef SOARBOX_PUBLIC_API_ONLY
  /// Like WMElement::GetLife. Not part of the interface of Soar 9.6.3.
  unsigned long long GetLife() const {
    return life_;
  }
#endif

 private:
  friend class Identifier;
  friend class WMElement;
  friend class WorkingMemory;
  friend class ObjectPool<IdentifierSymbol>;
  friend class ChildIterator;
  IdentifierSymbol() = default;
  char const* Name();
  Agent* GetAgent() const;
  ChildIterator begin() {
    return {this, first_child_};
  }
  ChildIterator end() {
    return {this, nullptr};
  }
  void Append(WMElement* child);
  void TakeOut(WMElement* child);
  void ForgetUsers();

  WorkingMemory* memory_ = nullptr;
  std::string name_;  ///< If the kernel created the name: empty until it is first needed.
  unsigned long long life_ = 0;
  long long key_ = 0;     ///< The kernel's name as a number; 0 for names that clients created.
  bool has_own_ = false;  ///< It may have children that the agent did not create.
  bool children_modified_ = false;
  unsigned int child_count_ = 0;
  WMElement *first_child_ = nullptr, *last_child_ = nullptr;
  Identifier* first_user_ = nullptr;
  IdentifierSymbol* next_ = nullptr;                         ///< See ObjectPool.
  std::unique_ptr<std::vector<Identifier*>> further_users_;  ///< Null while there was never more than one.
  unsigned int hint_ = 0;                                    ///< The kernel's handle, if it is in this process.
};

/// An element whose value is an identifier: a node of the input or output structure. Commands on the output link are
/// Identifiers.
class EXPORT Identifier : public WMElement {
 public:
  typedef ChildIterator ChildrenIter;
  typedef ChildIterator ChildrenConstIter;

  ~Identifier() override;

  /// The children in the order in which they were added.
  ChildrenIter GetChildrenBegin();
  ChildrenIter GetChildrenEnd();
  int GetNumberChildren() const;
  /// Returns NULL if there is no such child.
  WMElement* GetChild(int index);

  /// Searches the entire structure below; returns NULL if the element is not found.
  WMElement* FindFromTimeTag(long long timeTag) const;
  /// The index-th direct child with this attribute (case-insensitive); NULL if there is none.
  WMElement* FindByAttribute(char const* pAttribute, int index) const;
  /// The value of the first child with this attribute, as text; NULL if there is none.
  char const* GetParameterValue(char const* pAttribute) const;

  /// The name of the command: the attribute of this element.
  char const* GetCommandName() const { return GetAttribute(); }

  /// Adds ^status complete below this command.
  void AddStatusComplete();
  /// Adds ^status error below this command.
  void AddStatusError();
  /// Adds ^error-code N below this command.
  void AddErrorCode(int errorCode);

  bool AreChildrenModified();
  IdentifierSymbol* GetSymbol() const { return symbol_; }

  /// Like the functions of Agent, with this identifier as the parent.
  StringElement* CreateStringWME(char const* pAttribute, char const* pValue);
  IntElement* CreateIntWME(char const* pAttribute, long long value);
  FloatElement* CreateFloatWME(char const* pAttribute, double value);
  Identifier* CreateIdWME(char const* pAttribute);
  Identifier* CreateSharedIdWME(char const* pAttribute, Identifier* pSharedValue);

  char const* GetValueType() const override { return "id"; }
  char const* GetValueAsString() const override;
  char const* GetValueAsString(std::string& buf) const override;
  bool IsIdentifier() const override { return true; }
  Identifier* ConvertToIdentifier() override { return this; }

 private:
  friend class WorkingMemory;
  friend class IdentifierSymbol;
  friend class ObjectPool<Identifier>;
  Identifier() : WMElement(Kind::kIdentifier) {}

  IdentifierSymbol* symbol_ = nullptr;
};

}  // namespace sml
