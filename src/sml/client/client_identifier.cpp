// SPDX-License-Identifier: BSD-2-Clause
#include <strings.h>

#include <algorithm>
#include <iterator>

#include "sml/client/agent_data.h"
#include "sml/client/sml_ClientIdentifier.h"

namespace sml {

// The children of a symbol ------------------------------------------------------------------------------------------

IdentifierSymbol::~IdentifierSymbol() = default;

char const* IdentifierSymbol::Name() {
  if (name_.empty() && key_ != 0) AssignIdentifierName(name_, key_);
  return name_.c_str();
}

Agent* IdentifierSymbol::GetAgent() const {
  return &memory_->agent();
}

void IdentifierSymbol::SetIdentifierSymbol(char const* pID) {
  if (!pID) pID = "";
  name_ = pID;
}

void IdentifierSymbol::UsedBy(Identifier* pIdentifier) {
  if (!first_user_) {
    first_user_ = pIdentifier;
    return;
  }
  if (!further_users_) further_users_ = std::make_unique<std::vector<Identifier*>>();
  further_users_->push_back(pIdentifier);
}

void IdentifierSymbol::NoLongerUsedBy(Identifier* pIdentifier) {
  if (further_users_) std::erase(*further_users_, pIdentifier);
  if (first_user_ != pIdentifier) return;
  first_user_ = nullptr;
  if (!further_users_ || further_users_->empty()) return;
  first_user_ = further_users_->front();
  further_users_->erase(further_users_->begin());
}

int IdentifierSymbol::GetNumberUsing() {
  return (first_user_ ? 1 : 0) + (further_users_ ? static_cast<int>(further_users_->size()) : 0);
}

void IdentifierSymbol::ForgetUsers() {
  first_user_ = nullptr;
  if (further_users_) further_users_->clear();
}

/// Appends an element without a parent to the children.
void IdentifierSymbol::Append(WMElement* child) {
  child->parent_ = this;
  child->next_ = nullptr;
  child->previous_ = last_child_;
  (last_child_ ? last_child_->next_ : first_child_) = child;
  last_child_ = child;
  ++child_count_;
}

void IdentifierSymbol::TakeOut(WMElement* child) {
  (child->previous_ ? child->previous_->next_ : first_child_) = child->next_;
  (child->next_ ? child->next_->previous_ : last_child_) = child->previous_;
  child->parent_ = nullptr;
  child->agent_ = GetAgent();
  --child_count_;
}

ChildIterator& ChildIterator::operator--() {
  at_ = at_ ? at_->previous_ : parent_->last_child_;
  return *this;
}

void IdentifierSymbol::AddChild(WMElement* pWME) {
  if (!pWME || !pWME->live_ || pWME->parent_ == this || pWME->GetAgent() != GetAgent()) return;
  if (pWME->parent_) pWME->parent_->RemoveChild(pWME);
  Append(pWME);
  has_own_ = true;
  children_modified_ = true;
}

void IdentifierSymbol::RemoveChild(WMElement* pWME) {
  if (!pWME || pWME->parent_ != this) return;
  TakeOut(pWME);
  children_modified_ = true;
}

WMElement* IdentifierSymbol::GetChildByTimeTag(long long timeTag) {
  for (WMElement* child : *this) {
    if (child->GetTimeTag() == timeTag) return child;
  }
  return nullptr;
}

void IdentifierSymbol::TransferChildren(IdentifierSymbol* pFrom) {
  if (!pFrom || pFrom == this || pFrom->memory_ != memory_) return;
  while (WMElement* child = pFrom->first_child_) {
    pFrom->TakeOut(child);
    Append(child);
  }
  has_own_ = true;
  children_modified_ = true;
}

void IdentifierSymbol::DeleteAllChildren() {
  if (memory_) memory_->ReleaseBelow(this);
}

void IdentifierSymbol::DebugString(std::string& result) {
  for (WMElement* child : *this) child->DebugString(result);
}

// The element ---------------------------------------------------------------------------------------------------------

Identifier::~Identifier() = default;

Identifier::ChildrenIter Identifier::GetChildrenBegin() {
  return symbol_ ? symbol_->begin() : ChildrenIter();
}

Identifier::ChildrenIter Identifier::GetChildrenEnd() {
  return symbol_ ? symbol_->end() : ChildrenIter();
}

int Identifier::GetNumberChildren() const {
  return symbol_ ? static_cast<int>(symbol_->child_count_) : 0;
}

WMElement* Identifier::GetChild(int index) {
  if (!symbol_ || index < 0 || index >= GetNumberChildren()) return nullptr;
  return *std::next(symbol_->begin(), index);
}

WMElement* Identifier::FindFromTimeTag(long long timeTag) const {
  if (!symbol_) return nullptr;
  std::vector<IdentifierSymbol*> seen{symbol_};
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (WMElement* child : *seen[i]) {
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
  for (WMElement* child : *symbol_) {
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
  return symbol_ ? symbol_->Name() : "";
}

char const* Identifier::GetValueAsString(std::string& buf) const {
  buf = symbol_ ? symbol_->Name() : "";
  return buf.c_str();
}

}  // namespace sml
