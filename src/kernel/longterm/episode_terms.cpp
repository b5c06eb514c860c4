// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/episode_terms.h"

namespace soarbox::kernel {

EpisodeTerm EpisodeTerms::NumberOf(StoreTerm term) {
  const EpisodeTerm number = terms_.Order(term);
  if (number == by_number_.size()) by_number_.push_back(term);
  return number;
}

EpisodeTerm EpisodeTerms::Intern(const SymbolTable& symbols, Symbol constant) {
  Known& known = known_[constant.bits() % known_.size()];
  if (known.symbol != constant.bits()) known = {constant.bits(), NumberOf(AddTerm(terms_, symbols, constant))};
  return known.term;
}

std::string EpisodeTerms::Show(EpisodeTerm term) const {
  if (kind(term) == TermKind::kString) return std::string(Text(term));
  std::string text;
  terms_.Append(text, by_number_[term]);
  return text;
}

void EpisodeTerms::Clear() {
  terms_ = Terms();
  by_number_.clear();
  ForgetSymbols();
}

}  // namespace soarbox::kernel
