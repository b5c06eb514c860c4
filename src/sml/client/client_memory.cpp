// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/client_memory.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstring>

#include "sml/client/agent_data.h"

namespace sml {

using soarbox::server::InputWme;

namespace {

/// Whether input is sent immediately. An optimized kernel does so regardless of the auto-commit setting.
bool CommitsAtOnce(const KernelData& data) {
  return data.auto_commit || data.direct;
}

}  // namespace

WorkingMemory::~WorkingMemory() = default;

Agent& WorkingMemory::agent() const {
  return data_.agent;
}

/// Reserves numbers for 2^40 elements.
unsigned long long WorkingMemory::NewLife() {
  static std::atomic<unsigned long long> memories{0};
  return ++memories << 40;
}

bool WorkingMemory::Owns(const WMElement* wme) const {
  return wme && wme->live_ && (wme->parent_ ? wme->parent_->memory_ == this : wme->agent_ == &data_.agent);
}

IdentifierSymbol* WorkingMemory::FindSymbol(long long key) {
  IdentifierSymbol** found = symbols_by_key_.Find(key);
  return found ? *found : nullptr;
}

IdentifierSymbol* WorkingMemory::NewSymbol(std::string_view name, long long key) {
  IdentifierSymbol* symbol = symbols_.Take();
  symbol->memory_ = this;
  symbol->life_ = ++last_life_;
  symbol->name_ = name;
  symbol->key_ = key;
  symbol->ForgetUsers();
  symbol->children_modified_ = false;
  symbol->has_own_ = false;
  symbol->hint_ = 0;
  return symbol;
}

IdentifierSymbol* WorkingMemory::SymbolFor(long long key) {
  if (IdentifierSymbol* found = FindSymbol(key)) return found;
  IdentifierSymbol* symbol = NewSymbol({}, key);
  symbols_by_key_.Add(key, symbol);
  return symbol;
}

void WorkingMemory::Attach(WMElement* wme, IdentifierSymbol* parent, std::string_view attribute, long long tag,
                           bool output) {
  wme->parent_ = nullptr;
  wme->agent_ = &data_.agent;
  wme->attribute_ = attribute;
  wme->time_tag_ = tag;
  wme->life_ = ++last_life_;
  wme->just_added_ = output;
  wme->live_ = true;
  wme->input_ = kNoInputHandle;
  wme->output_ = output;
  if (!parent) return;
  if (!output) parent->has_own_ = true;
  parent->Append(wme);
}

void WorkingMemory::Detach(WMElement* wme) {
  if (wme->parent_) wme->parent_->TakeOut(wme);
}

void WorkingMemory::RetireElement(WMElement* wme) {
  wme->life_ = 0;
  switch (wme->kind_) {
    case WMElement::Kind::kString:
      strings_.GiveBack(static_cast<StringElement*>(wme));
      break;
    case WMElement::Kind::kInt:
      ints_.GiveBack(static_cast<IntElement*>(wme));
      break;
    case WMElement::Kind::kFloat:
      floats_.GiveBack(static_cast<FloatElement*>(wme));
      break;
    case WMElement::Kind::kIdentifier:
      identifiers_.GiveBack(static_cast<Identifier*>(wme));
      break;
  }
}

/// Removes an identifier from the users of its symbol. If it was the last user, destroys the symbol and appends its
/// children to `below`.
void WorkingMemory::DropSymbol(Identifier* identifier, std::vector<WMElement*>& below) {
  IdentifierSymbol* symbol = identifier->symbol_;
  if (!symbol) return;
  identifier->symbol_ = nullptr;
  if (symbol->GetNumberUsing() > 1) {
    symbol->NoLongerUsedBy(identifier);
    return;
  }
  symbol->ForgetUsers();
  while (WMElement* child = symbol->first_child_) {
    symbol->TakeOut(child);
    below.push_back(child);
  }
  if (symbol->key_ != 0) symbols_by_key_.Take(symbol->key_);
  symbol->life_ = 0;
  symbols_.GiveBack(symbol);
}

/// Converts an element, and everything below it that is not shared, to dead objects.
void WorkingMemory::Release(WMElement* wme) {
  const std::size_t base = work_.size();
  const auto release = [&](WMElement* element) {
    Detach(element);
    if (element->kind_ == WMElement::Kind::kIdentifier) DropSymbol(static_cast<Identifier*>(element), work_);
    // (Elements whose removal was reported are no longer in the table.)
    if (element->output_) {
      if (element->live_) output_by_tag_.Take(element->time_tag_);
    } else {
      Cancel(element->time_tag_);
    }
    if (!element->live_ && std::find(removed_.begin(), removed_.end(), element) != removed_.end()) return;
    element->live_ = false;
    RetireElement(element);
  };
  release(wme);
  while (work_.size() > base) {
    WMElement* element = work_.back();
    work_.pop_back();
    release(element);
  }
}

void WorkingMemory::ReleaseBelow(IdentifierSymbol* symbol) {
  while (symbol->first_child_) Release(symbol->first_child_);
}

/// Cancels a buffered addition.
bool WorkingMemory::Cancel(long long tag) {
  if (pending_.changes_.empty()) return false;
  return std::erase_if(pending_.changes_,
                       [&](const TagWme& change) { return !change.remove && change.time_tag == tag; }) > 0;
}

Identifier* WorkingMemory::InputLink() {
  if (input_link_) return input_link_;
  AgentLink* link = data_.Usable();
  if (!link) return nullptr;
  const std::string name = link->InputLinkName();
  if (name.empty()) {
    data_.SetError(kFailedToGetResponse, "The kernel did not report the name of the input link");
    return nullptr;
  }
  input_link_ = identifiers_.Take();
  const long long key = IdentifierKey(name);
  IdentifierSymbol* symbol = key ? SymbolFor(key) : NewSymbol(name, 0);
  input_link_->symbol_ = symbol;
  symbol->UsedBy(input_link_);
  Attach(input_link_, nullptr, "input-link", --data_.kernel_data().next_tag, false);
  return input_link_;
}

bool WorkingMemory::CheckParent(Identifier* parent, char const*& attribute) {
  if (!Owns(parent) || !parent->symbol_) {
    data_.SetError(kInvalidArgument, "The parent is not an identifier of this agent, or it has been removed");
    return false;
  }
  if (!attribute) {
    std::fprintf(stderr, "sml: an element without an attribute was created; its attribute is \"nil\"\n");
    attribute = "nil";
  }
  return data_.Usable() != nullptr;
}

StringElement* WorkingMemory::CreateString(Identifier* parent, char const* attribute, char const* value) {
  if (!CheckParent(parent, attribute)) return nullptr;
  if (!value) {
    std::fprintf(stderr, "sml: an element without a value was created; its value is \"nil\"\n");
    value = "nil";
  }
  StringElement* wme = strings_.Take();
  wme->value_ = value;
  Attach(wme, parent->symbol_, attribute, --data_.kernel_data().next_tag, false);
  SendNew(wme);
  return wme;
}

IntElement* WorkingMemory::CreateInt(Identifier* parent, char const* attribute, long long value) {
  if (!CheckParent(parent, attribute)) return nullptr;
  IntElement* wme = ints_.Take();
  wme->value_ = value;
  Attach(wme, parent->symbol_, attribute, --data_.kernel_data().next_tag, false);
  SendNew(wme);
  return wme;
}

FloatElement* WorkingMemory::CreateFloat(Identifier* parent, char const* attribute, double value) {
  if (!CheckParent(parent, attribute)) return nullptr;
  FloatElement* wme = floats_.Take();
  wme->value_ = value;
  Attach(wme, parent->symbol_, attribute, --data_.kernel_data().next_tag, false);
  SendNew(wme);
  return wme;
}

std::string WorkingMemory::NewName(char const* attribute) {
  char letter = attribute[0];
  if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  if (letter < 'a' || letter > 'z') letter = 'a';
  return letter + std::to_string(++data_.kernel_data().next_name);
}

Identifier* WorkingMemory::CreateId(Identifier* parent, char const* attribute) {
  if (!CheckParent(parent, attribute)) return nullptr;
  Identifier* wme = identifiers_.Take();
  wme->symbol_ = NewSymbol(NewName(attribute), 0);
  wme->symbol_->UsedBy(wme);
  Attach(wme, parent->symbol_, attribute, --data_.kernel_data().next_tag, false);
  SendNew(wme);
  return wme;
}

Identifier* WorkingMemory::CreateSharedId(Identifier* parent, char const* attribute, Identifier* shared) {
  if (!CheckParent(parent, attribute)) return nullptr;
  if (!Owns(shared) || !shared->symbol_) {
    data_.SetError(kInvalidArgument, "The shared value is not an identifier of this agent, or it has been removed");
    return nullptr;
  }
  // As in Soar, other elements may have the same attribute and value; each is removed individually.
  const bool is_there = shared->parent_ == parent->symbol_ && std::strcmp(shared->GetAttribute(), attribute) == 0;
  if (is_there) return nullptr;
  Identifier* wme = identifiers_.Take();
  wme->symbol_ = shared->symbol_;
  wme->symbol_->UsedBy(wme);
  Attach(wme, parent->symbol_, attribute, --data_.kernel_data().next_tag, false);
  SendNew(wme);
  return wme;
}

InputWme WorkingMemory::Describe(WMElement* wme) {
  InputWme described;
  described.tag = wme->time_tag_;
  // The kernel does not need the names of its own identifiers.
  if (wme->parent_->hint_ == 0) described.id = wme->parent_->Name();
  described.id_key = wme->parent_->key_;
  described.id_hint = wme->parent_->hint_;
  described.attribute = wme->GetAttribute();
  switch (wme->kind_) {
    case WMElement::Kind::kString:
      described.text = static_cast<StringElement*>(wme)->value_.c_str();
      break;
    case WMElement::Kind::kInt:
      described.type = InputWme::Type::kInt;
      described.integer = static_cast<IntElement*>(wme)->value_;
      break;
    case WMElement::Kind::kFloat:
      described.type = InputWme::Type::kDouble;
      described.real = static_cast<FloatElement*>(wme)->value_;
      break;
    case WMElement::Kind::kIdentifier:
      described.type = InputWme::Type::kId;
      described.text = static_cast<Identifier*>(wme)->symbol_->Name();
      break;
  }
  return described;
}

void WorkingMemory::SendNew(WMElement* wme) {
  if (!CommitsAtOnce(data_.kernel_data())) {
    pending_.changes_.push_back({false, wme->time_tag_, wme, kNoInputHandle});
    return;
  }
  wme->input_ = data_.link->AddInput(Describe(wme));
  data_.link->FlushInput();
}

/// Assigns a new tag to an element with a new value.
void WorkingMemory::SendUpdated(WMElement* wme) {
  const long long old_tag = wme->time_tag_;
  wme->time_tag_ = --data_.kernel_data().next_tag;
  if (CommitsAtOnce(data_.kernel_data())) {
    wme->input_ = data_.link->UpdateInput(wme->input_, old_tag, Describe(wme));
    data_.link->FlushInput();
    return;
  }
  if (!Cancel(old_tag)) pending_.changes_.push_back({true, old_tag, nullptr, wme->input_});
  wme->input_ = kNoInputHandle;
  pending_.changes_.push_back({false, wme->time_tag_, wme, kNoInputHandle});
}

bool WorkingMemory::CheckUpdate(WMElement* wme) {
  if (!Owns(wme)) {
    data_.SetError(kInvalidArgument, "The element to update does not belong to this agent, or it has been removed");
    return false;
  }
  if (wme->output_ || !wme->parent_) {
    data_.SetError(kInvalidArgument, "Only input can be updated");
    return false;
  }
  return data_.Usable() != nullptr;
}

void WorkingMemory::Update(StringElement* wme, char const* value) {
  if (!CheckUpdate(wme)) return;
  if (!value) value = "nil";
  if (!data_.blink && std::strcmp(wme->value_.c_str(), value) == 0) return;
  wme->value_ = value;
  SendUpdated(wme);
}

void WorkingMemory::Update(IntElement* wme, long long value) {
  if (!CheckUpdate(wme)) return;
  if (!data_.blink && wme->value_ == value) return;
  wme->value_ = value;
  SendUpdated(wme);
}

void WorkingMemory::Update(FloatElement* wme, double value) {
  if (!CheckUpdate(wme)) return;
  if (!data_.blink && wme->value_ == value) return;
  wme->value_ = value;
  SendUpdated(wme);
}

bool WorkingMemory::Destroy(WMElement* wme) {
  if (!Owns(wme)) {
    data_.SetError(kInvalidArgument,
                   "The element to destroy does not belong to this agent, or it has already been removed");
    return false;
  }
  if (!wme->parent_) {
    data_.SetError(kInvalidArgument, "The input link and the output link cannot be destroyed");
    return false;
  }
  if (wme->output_) {
    data_.SetError(kInvalidArgument, "Output belongs to the agent: only its rules can remove it");
    return false;
  }
  if (!data_.Usable()) return false;
  if (!Cancel(wme->time_tag_)) {
    if (CommitsAtOnce(data_.kernel_data())) {
      data_.link->RemoveInput(wme->input_, wme->time_tag_);
      data_.link->FlushInput();
    } else {
      pending_.changes_.push_back({true, wme->time_tag_, nullptr, wme->input_});
    }
  }
  Release(wme);
  return true;
}

bool WorkingMemory::Commit() {
  if (pending_.changes_.empty()) return true;
  AgentLink* link = data_.Usable();
  if (!link) return false;
  std::vector<TagWme> changes;
  changes.swap(pending_.changes_);
  for (const TagWme& change : changes) {
    if (change.remove) {
      link->RemoveInput(change.input, change.time_tag);
    } else {
      change.wme->input_ = link->AddInput(Describe(change.wme));
    }
  }
  link->FlushInput();
  return true;
}

void WorkingMemory::Refresh() {
  pending_.changes_.clear();
  AgentLink* link = data_.Usable();
  if (!input_link_ || !link) return;
  const std::string name = link->InputLinkName();
  if (!name.empty() && name != input_link_->symbol_->Name()) {
    IdentifierSymbol* symbol = input_link_->symbol_;
    symbols_by_key_.Take(symbol->key_);
    symbol->name_ = name;
    symbol->key_ = IdentifierKey(name);
    symbols_by_key_.Set(symbol->key_, symbol);
  }
  std::vector<IdentifierSymbol*> seen{input_link_->symbol_};
  std::vector<WMElement*> open;
  const auto open_children = [&open](IdentifierSymbol* symbol) {  // The first child is the last entry.
    for (WMElement* child = symbol->last_child_; child; child = child->previous_) open.push_back(child);
  };
  open_children(input_link_->symbol_);
  while (!open.empty()) {
    WMElement* wme = open.back();
    open.pop_back();
    wme->input_ = link->AddInput(Describe(wme));
    Identifier* identifier = wme->ConvertToIdentifier();
    if (!identifier || std::find(seen.begin(), seen.end(), identifier->symbol_) != seen.end()) continue;
    seen.push_back(identifier->symbol_);
    open_children(identifier->symbol_);
  }
  link->FlushInput();
}

bool WorkingMemory::SynchronizeInput() {
  Identifier* root = InputLink();
  if (!root) return false;
  pending_.changes_.clear();
  ReleaseBelow(root->symbol_);
  data_.link->ListInput([this](const OutputWme& wme) {
    IdentifierSymbol* parent = FindSymbol(wme.id);
    if (!parent) return;
    WMElement* made = MakeOutput(wme, parent);
    made->output_ = false;
    made->just_added_ = false;
  });
  return true;
}

}  // namespace sml
