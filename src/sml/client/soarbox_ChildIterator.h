// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <iterator>

#include "sml_ClientWMElement.h"

namespace sml {

/// Iterates over the children of an identifier. Valid while its current child is.
class EXPORT ChildIterator {
 public:
  typedef std::bidirectional_iterator_tag iterator_category;
  typedef WMElement* value_type;
  typedef std::ptrdiff_t difference_type;
  typedef WMElement* const* pointer;
  typedef WMElement* reference;

  ChildIterator() = default;
  WMElement* operator*() const { return at_; }
  WMElement* const* operator->() const { return &at_; }
  ChildIterator& operator++() {
    at_ = at_->next_;
    return *this;
  }
  ChildIterator& operator--();
  ChildIterator operator++(int) {
    ChildIterator before = *this;
    ++*this;
    return before;
  }
  ChildIterator operator--(int) {
    ChildIterator before = *this;
    --*this;
    return before;
  }
  friend bool operator==(ChildIterator const& a, ChildIterator const& b) { return a.at_ == b.at_; }
  friend bool operator!=(ChildIterator const& a, ChildIterator const& b) { return a.at_ != b.at_; }

 private:
  friend class IdentifierSymbol;
  friend class Identifier;
  ChildIterator(IdentifierSymbol* parent, WMElement* at) : parent_(parent), at_(at) {}

  IdentifierSymbol* parent_ = nullptr;
  WMElement* at_ = nullptr;  ///< Null after the last child.
};

}  // namespace sml
