// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/token_pool.h"

#include <algorithm>

namespace soarbox::kernel {

void TokenPool::Unlink(ElementLinks& elements, std::uint32_t index) {
  UnlinkFromParent(records_[index]);
  UnlinkFromElement(elements, records_.records(), records_[index]);
}

void TokenPool::SortByAge(std::vector<std::uint32_t>& list) const {
  const Records<const Token> all = records_.records();
  const auto newer = [all](std::uint32_t a, std::uint32_t b) { return all[a].serial > all[b].serial; };
  if (!std::ranges::is_sorted(list, newer)) {
    std::ranges::sort(list, newer);
  }
}

void TokenPool::SortChildren(std::uint32_t parent) {
  sorting_.clear();
  for (std::uint32_t token = records_[parent].first_child; token != kNil; token = records_[token].next_sibling) {
    sorting_.push_back(token);
  }
  SortByAge(sorting_);
  std::uint32_t previous = kNil;
  for (const std::uint32_t token : sorting_) {
    records_[token].previous_sibling = previous;
    (previous == kNil ? records_[parent].first_child : records_[previous].next_sibling) = token;
    previous = token;
  }
  records_[previous].next_sibling = kNil;
  records_[parent].node &= ~Token::kUnsortedBit;
}

void TokenPool::SortTokensOf(WmeLinks& element) {
  sorting_.clear();
  for (std::uint32_t token = element.first_token; token != kNil; token = records_[token].next_of_wme) {
    sorting_.push_back(token);
  }
  SortByAge(sorting_);
  std::uint32_t previous = kNil;
  for (const std::uint32_t token : sorting_) {
    records_[token].previous_of_wme = previous;
    (previous == kNil ? element.first_token : records_[previous].next_of_wme) = token;
    previous = token;
  }
  if (previous != kNil) {
    records_[previous].next_of_wme = kNil;
  }
  element.unsorted = false;
}

void TokenPool::SortBucket(std::uint32_t& head) {
  sorting_.clear();
  for (std::uint32_t token = head; token != kNil; token = records_[token].next_in_bucket) {
    sorting_.push_back(token);
  }
  SortByAge(sorting_);
  std::uint32_t* link = &head;
  std::uint32_t previous = kNil;
  for (const std::uint32_t token : sorting_) {
    *link = token;
    records_[token].previous_in_bucket = previous;
    link = &records_[token].next_in_bucket;
    previous = token;
  }
  *link = kNil;
}

std::uint32_t TokenPool::TopOf(std::uint32_t token) const {
  while (records_[token].parent != kNil) {
    token = records_[token].parent;
  }
  return token;
}

bool TokenPool::Holds(std::uint32_t token, std::uint32_t wme) const {
  while (records_[token].parent != kNil && records_[token].wme != wme) {
    token = records_[token].parent;
  }
  return records_[token].parent != kNil;
}

std::size_t TokenPool::CountInUse() const {
  std::size_t count = records_.size();
  ForEachFree([&](std::uint32_t) { --count; });
  return count;
}

void TokenPool::FreeResults(ElementLinks& links, std::uint32_t owner) {
  for (std::uint32_t result = records_[owner].first_child; result != kNil;) {
    const std::uint32_t next = records_[result].next_in_bucket;
    Unlink(links, result);
    Free(result);
    result = next;
  }
  records_[owner].first_child = kNil;
}

}  // namespace soarbox::kernel
