// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/working_memory.h"

#include <algorithm>
#include <cstdio>

#include "sml/client/agent_data.h"

namespace sml {

using soarbox::server::InputWme;

namespace {

/// How many destroyed elements of a type stay husks.
constexpr std::size_t kQuarantine = 32;

}  // namespace

WorkingMemory::~WorkingMemory() = default;

template <typename T>
T* WorkingMemory::Take(Pool<T>& pool) {
  if (pool.husks.size() <= kQuarantine) {
    pool.all.push_back(std::unique_ptr<T>(new T));
    return pool.all.back().get();
  }
  T* element = pool.husks.front();
  pool.spare.splice(pool.spare.end(), pool.husks, pool.husks.begin());
  return element;
}

// Used by working_memory_output.cpp too.
template IdentifierSymbol* WorkingMemory::Take(Pool<IdentifierSymbol>&);
template StringElement* WorkingMemory::Take(Pool<StringElement>&);
template IntElement* WorkingMemory::Take(Pool<IntElement>&);
template FloatElement* WorkingMemory::Take(Pool<FloatElement>&);
template Identifier* WorkingMemory::Take(Pool<Identifier>&);

template <typename T>
void WorkingMemory::Retire(Pool<T>& pool, T* element) {
  if (pool.spare.empty()) {
    pool.husks.push_back(element);
    return;
  }
  pool.spare.front() = element;
  pool.husks.splice(pool.husks.end(), pool.spare, pool.spare.begin());
}

bool WorkingMemory::Owns(const WMElement* wme) const { return wme && wme->live_ && wme->agent_ == &data_.agent; }

IdentifierSymbol* WorkingMemory::FindSymbol(long long key) {
  IdentifierSymbol** found = symbols_by_key_.Find(key);
  return found ? *found : nullptr;
}

IdentifierSymbol* WorkingMemory::NewSymbol(std::string_view name) {
  IdentifierSymbol* symbol = Take(symbols_);
  symbol->memory_ = this;
  symbol->name_ = name;
  symbol->users_.clear();
  symbol->children_modified_ = false;
  symbol->hint_ = 0;
  return symbol;
}

IdentifierSymbol* WorkingMemory::SymbolFor(long long key) {
  if (IdentifierSymbol* found = FindSymbol(key)) return found;
  IdentifierSymbol* symbol = NewSymbol({});
  AssignIdentifierName(symbol->name_, key);
  symbols_by_key_.Set(key, symbol);
  return symbol;
}

void WorkingMemory::Attach(WMElement* wme, IdentifierSymbol* parent, std::string_view attribute, long long tag, bool output) {
  wme->agent_ = &data_.agent;
  wme->parent_ = parent;
  wme->attribute_ = attribute;
  wme->time_tag_ = tag;
  wme->just_added_ = output;
  wme->live_ = true;
  wme->output_ = output;
  if (!parent) return;
  if (spare_nodes_.empty()) {
    parent->children_.push_back(wme);
  } else {
    spare_nodes_.front() = wme;
    parent->children_.splice(parent->children_.end(), spare_nodes_, spare_nodes_.begin());
  }
  wme->place_ = std::prev(parent->children_.end());
}

void WorkingMemory::Detach(WMElement* wme) {
  if (!wme->parent_) return;
  spare_nodes_.splice(spare_nodes_.end(), wme->parent_->children_, wme->place_);
  wme->parent_ = nullptr;
}

void WorkingMemory::RetireElement(WMElement* wme) {
  if (auto* text = wme->ConvertToStringElement()) return Retire(strings_, text);
  if (auto* number = wme->ConvertToIntElement()) return Retire(ints_, number);
  if (auto* number = wme->ConvertToFloatElement()) return Retire(floats_, number);
  Retire(identifiers_, wme->ConvertToIdentifier());
}

/// Ends an identifier's use of its symbol. If it was the last one, the symbol goes, and its children with it.
void WorkingMemory::DropSymbol(Identifier* identifier, std::vector<WMElement*>& below) {
  IdentifierSymbol* symbol = identifier->symbol_;
  if (!symbol) return;
  identifier->symbol_ = nullptr;
  std::erase(symbol->users_, identifier);
  if (!symbol->users_.empty()) return;
  for (WMElement* child : symbol->children_) {
    child->parent_ = nullptr;
    below.push_back(child);
  }
  spare_nodes_.splice(spare_nodes_.end(), symbol->children_);
  if (const long long key = IdentifierKey(symbol->name_)) symbols_by_key_.Take(key);
  Retire(symbols_, symbol);
}

/// Makes husks of an element and of everything below it that nothing else shares.
void WorkingMemory::Release(WMElement* wme) {
  const std::size_t base = work_.size();
  work_.push_back(wme);
  while (work_.size() > base) {
    WMElement* element = work_.back();
    work_.pop_back();
    Detach(element);
    if (Identifier* identifier = element->ConvertToIdentifier()) DropSymbol(identifier, work_);
    if (element->output_) output_by_tag_.Take(element->time_tag_);
    Cancel(element->time_tag_);
    if (!element->live_ && std::find(removed_.begin(), removed_.end(), element) != removed_.end()) continue;
    element->live_ = false;
    RetireElement(element);
  }
}

void WorkingMemory::ReleaseBelow(IdentifierSymbol* symbol) {
  while (!symbol->children_.empty()) Release(symbol->children_.front());
}

/// Takes a waiting addition back.
bool WorkingMemory::Cancel(long long tag) {
  if (pending_.changes_.empty()) return false;
  return std::erase_if(pending_.changes_, [&](const TagWme& change) { return !change.remove && change.time_tag == tag; }) > 0;
}

Identifier* WorkingMemory::InputLink() {
  if (input_link_) return input_link_;
  AgentLink* link = data_.Usable();
  if (!link) return nullptr;
  const std::string name = link->InputLinkName();
  if (name.empty()) {
    data_.SetError(kFailedToGetResponse, "The kernel did not tell the name of the input link");
    return nullptr;
  }
  input_link_ = Take(identifiers_);
  const long long key = IdentifierKey(name);
  IdentifierSymbol* symbol = key ? SymbolFor(key) : NewSymbol(name);
  input_link_->symbol_ = symbol;
  symbol->users_.push_back(input_link_);
  Attach(input_link_, nullptr, "input-link", --data_.kernel_data().next_tag, false);
  return input_link_;
}

bool WorkingMemory::CheckParent(Identifier* parent, char const*& attribute) {
  if (!Owns(parent) || !parent->symbol_) {
    data_.SetError(kInvalidArgument, "The parent is no identifier of this agent, or it has been removed");
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
  StringElement* wme = Take(strings_);
  wme->value_ = value;
  Attach(wme, parent->symbol_, attribute, --data_.kernel_data().next_tag, false);
  SendNew(wme);
  return wme;
}

IntElement* WorkingMemory::CreateInt(Identifier* parent, char const* attribute, long long value) {
  if (!CheckParent(parent, attribute)) return nullptr;
  IntElement* wme = Take(ints_);
  wme->value_ = value;
  Attach(wme, parent->symbol_, attribute, --data_.kernel_data().next_tag, false);
  SendNew(wme);
  return wme;
}

FloatElement* WorkingMemory::CreateFloat(Identifier* parent, char const* attribute, double value) {
  if (!CheckParent(parent, attribute)) return nullptr;
  FloatElement* wme = Take(floats_);
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
  Identifier* wme = Take(identifiers_);
  wme->symbol_ = NewSymbol(NewName(attribute));
  wme->symbol_->users_.push_back(wme);
  Attach(wme, parent->symbol_, attribute, --data_.kernel_data().next_tag, false);
  SendNew(wme);
  return wme;
}

Identifier* WorkingMemory::CreateSharedId(Identifier* parent, char const* attribute, Identifier* shared) {
  if (!CheckParent(parent, attribute)) return nullptr;
  if (!Owns(shared) || !shared->symbol_) {
    data_.SetError(kInvalidArgument, "The shared value is no identifier of this agent, or it has been removed");
    return nullptr;
  }
  for (WMElement* child : parent->symbol_->children_) {
    Identifier* identifier = child->ConvertToIdentifier();
    if (identifier && identifier->symbol_ == shared->symbol_ && identifier->attribute_ == attribute) return nullptr;
  }
  Identifier* wme = Take(identifiers_);
  wme->symbol_ = shared->symbol_;
  wme->symbol_->users_.push_back(wme);
  Attach(wme, parent->symbol_, attribute, --data_.kernel_data().next_tag, false);
  SendNew(wme);
  return wme;
}

InputWme WorkingMemory::Describe(const WMElement* element) const {
  auto* wme = const_cast<WMElement*>(element);
  InputWme described;
  described.tag = wme->time_tag_;
  described.id = wme->parent_->name_;
  described.id_hint = wme->parent_->hint_;
  described.attribute = wme->attribute_;
  if (auto* number = wme->ConvertToFloatElement()) {
    described.type = InputWme::Type::kDouble;
    described.real = number->value_;
  } else if (auto* whole = wme->ConvertToIntElement()) {
    described.type = InputWme::Type::kInt;
    described.integer = whole->value_;
  } else if (auto* text = wme->ConvertToStringElement()) {
    described.text = text->value_;
  } else {
    described.type = InputWme::Type::kId;
    described.text = wme->ConvertToIdentifier()->symbol_->name_;
  }
  return described;
}

void WorkingMemory::SendNew(WMElement* wme) {
  if (!data_.kernel_data().auto_commit) {
    pending_.changes_.push_back({false, wme->time_tag_, wme});
    return;
  }
  data_.link->AddInput(Describe(wme));
  data_.link->FlushInput();
}

void WorkingMemory::SendUpdated(WMElement* wme, long long old_tag) {
  if (data_.kernel_data().auto_commit) {
    data_.link->UpdateInput(old_tag, Describe(wme));
    data_.link->FlushInput();
    return;
  }
  if (!Cancel(old_tag)) pending_.changes_.push_back({true, old_tag, nullptr});
  pending_.changes_.push_back({false, wme->time_tag_, wme});
}

bool WorkingMemory::CheckUpdate(WMElement* wme) {
  if (!Owns(wme)) {
    data_.SetError(kInvalidArgument, "The element to update is none of this agent, or it has been removed");
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
  if (!data_.blink && wme->value_ == value) return;
  wme->value_ = value;
  const long long old_tag = wme->time_tag_;
  wme->time_tag_ = --data_.kernel_data().next_tag;
  SendUpdated(wme, old_tag);
}

void WorkingMemory::Update(IntElement* wme, long long value) {
  if (!CheckUpdate(wme)) return;
  if (!data_.blink && wme->value_ == value) return;
  wme->value_ = value;
  const long long old_tag = wme->time_tag_;
  wme->time_tag_ = --data_.kernel_data().next_tag;
  SendUpdated(wme, old_tag);
}

void WorkingMemory::Update(FloatElement* wme, double value) {
  if (!CheckUpdate(wme)) return;
  if (!data_.blink && wme->value_ == value) return;
  wme->value_ = value;
  const long long old_tag = wme->time_tag_;
  wme->time_tag_ = --data_.kernel_data().next_tag;
  SendUpdated(wme, old_tag);
}

bool WorkingMemory::Destroy(WMElement* wme) {
  if (!Owns(wme)) {
    data_.SetError(kInvalidArgument, "The element to destroy is none of this agent, or it has been removed already");
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
    if (data_.kernel_data().auto_commit) {
      data_.link->RemoveInput(wme->time_tag_);
      data_.link->FlushInput();
    } else {
      pending_.changes_.push_back({true, wme->time_tag_, nullptr});
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
      link->RemoveInput(change.time_tag);
    } else {
      link->AddInput(Describe(change.wme));
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
  if (!name.empty() && name != input_link_->symbol_->name_) {
    symbols_by_key_.Take(IdentifierKey(input_link_->symbol_->name_));
    input_link_->symbol_->name_ = name;
    symbols_by_key_.Set(IdentifierKey(name), input_link_->symbol_);
  }
  std::vector<IdentifierSymbol*> seen{input_link_->symbol_};
  std::vector<WMElement*> open(input_link_->symbol_->children_.rbegin(), input_link_->symbol_->children_.rend());
  while (!open.empty()) {
    WMElement* wme = open.back();
    open.pop_back();
    link->AddInput(Describe(wme));
    Identifier* identifier = wme->ConvertToIdentifier();
    if (!identifier || std::find(seen.begin(), seen.end(), identifier->symbol_) != seen.end()) continue;
    seen.push_back(identifier->symbol_);
    open.insert(open.end(), identifier->symbol_->children_.rbegin(), identifier->symbol_->children_.rend());
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
