// SPDX-License-Identifier: BSD-2-Clause
#include <strings.h>

#include <algorithm>

#include "sml/client/agent_data.h"
#include "sml/client/sml_ClientIdentifier.h"

namespace sml {

namespace {

/// What a dead object has for children.
std::list<WMElement*> no_children;

}  // namespace

// The children of a symbol
// ----------------------------------------------------------------------------------------------

IdentifierSymbol::~IdentifierSymbol() = default;

std::string const& IdentifierSymbol::Name() {
  if (name_.empty() && key_ != 0) AssignIdentifierName(name_, key_);
  return name_;
}

void IdentifierSymbol::UsedBy(Identifier* pIdentifier) {
  users_.push_back(pIdentifier);
}

void IdentifierSymbol::NoLongerUsedBy(Identifier* pIdentifier) {
  std::erase(users_, pIdentifier);
}

void IdentifierSymbol::AddChild(WMElement* pWME) {
  if (!pWME || pWME->parent_ == this) return;
  if (pWME->parent_) pWME->parent_->RemoveChild(pWME);
  children_.push_back(pWME);
  has_own_ = true;
  pWME->parent_ = this;
  pWME->place_ = std::prev(children_.end());
  children_modified_ = true;
}

void IdentifierSymbol::RemoveChild(WMElement* pWME) {
  if (!pWME || pWME->parent_ != this) return;
  children_.erase(pWME->place_);
  pWME->parent_ = nullptr;
  children_modified_ = true;
}

WMElement* IdentifierSymbol::GetChildByTimeTag(long long timeTag) {
  for (WMElement* child : children_) {
    if (child->GetTimeTag() == timeTag) return child;
  }
  return nullptr;
}

void IdentifierSymbol::TransferChildren(IdentifierSymbol* pFrom) {
  if (!pFrom || pFrom == this) return;
  for (WMElement* child : pFrom->children_) child->parent_ = this;
  children_.splice(children_.end(), pFrom->children_);
  has_own_ = true;
  children_modified_ = true;
}

void IdentifierSymbol::DeleteAllChildren() {
  if (memory_) memory_->ReleaseBelow(this);
}

void IdentifierSymbol::DebugString(std::string& result) {
  for (WMElement* child : children_) child->DebugString(result);
}

// The element
// -----------------------------------------------------------------------------------------------------------

Identifier::~Identifier() = default;

Identifier::ChildrenIter Identifier::GetChildrenBegin() {
  return symbol_ ? symbol_->children_.begin() : no_children.begin();
}

Identifier::ChildrenIter Identifier::GetChildrenEnd() {
  return symbol_ ? symbol_->children_.end() : no_children.end();
}

int Identifier::GetNumberChildren() const {
  return symbol_ ? static_cast<int>(symbol_->children_.size()) : 0;
}

WMElement* Identifier::GetChild(int index) {
  if (!symbol_ || index < 0 || index >= GetNumberChildren()) return nullptr;
  return *std::next(symbol_->children_.begin(), index);
}

WMElement* Identifier::FindFromTimeTag(long long timeTag) const {
  if (!symbol_) return nullptr;
  std::vector<IdentifierSymbol*> seen{symbol_};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (WMElement* child : seen[i]->children_) {
      if (child->GetTimeTag() == timeTag) return child;
      Identifier* identifier = child->ConvertToIdentifier();
      if (!identifier || !identifier->symbol_) continue;
      if (std::find(seen.begin(), seen.end(), identifier->symbol_) == seen.end()) seen.push_back(identifier->symbol_);
    }
  }
  return nullptr;
}

WMElement* Identifier::FindByAttribute(char const* pAttribute, int index) const {
  if (!symbol_ || !pAttribute) return nullptr;
  for (WMElement* child : symbol_->children_) {
    if (strcasecmp(child->GetAttribute(), pAttribute) == 0 && index-- == 0) return child;
  }
  return nullptr;
}

char const* Identifier::GetParameterValue(char const* pAttribute) const {
  WMElement* child = FindByAttribute(pAttribute, 0);
  return child ? child->GetValueAsString() : nullptr;
}

bool Identifier::AreChildrenModified() {
  if (GetAgent()) AgentData::Of(*GetAgent()).memory.DropOldChanges();
  return symbol_ && symbol_->children_modified_;
}

void Identifier::AddStatusComplete() {
  CreateStringWME("status", "complete");
}

void Identifier::AddStatusError() {
  CreateStringWME("status", "error");
}

void Identifier::AddErrorCode(int errorCode) {
  CreateIntWME("error-code", errorCode);
}

StringElement* Identifier::CreateStringWME(char const* pAttribute, char const* pValue) {
  return GetAgent() ? GetAgent()->CreateStringWME(this, pAttribute, pValue) : nullptr;
}

IntElement* Identifier::CreateIntWME(char const* pAttribute, long long value) {
  return GetAgent() ? GetAgent()->CreateIntWME(this, pAttribute, value) : nullptr;
}

FloatElement* Identifier::CreateFloatWME(char const* pAttribute, double value) {
  return GetAgent() ? GetAgent()->CreateFloatWME(this, pAttribute, value) : nullptr;
}

Identifier* Identifier::CreateIdWME(char const* pAttribute) {
  return GetAgent() ? GetAgent()->CreateIdWME(this, pAttribute) : nullptr;
}

Identifier* Identifier::CreateSharedIdWME(char const* pAttribute, Identifier* pSharedValue) {
  return GetAgent() ? GetAgent()->CreateSharedIdWME(this, pAttribute, pSharedValue) : nullptr;
}

char const* Identifier::GetValueAsString() const {
  return symbol_ ? symbol_->Name().c_str() : "";
}

char const* Identifier::GetValueAsString(std::string& buf) const {
  buf = symbol_ ? symbol_->Name() : std::string();
  return buf.c_str();
}

}  // namespace sml
