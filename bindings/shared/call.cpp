// SPDX-License-Identifier: BSD-2-Clause
#include "call.h"

namespace soarbox::bindings {

namespace {

thread_local Argument* newest_argument = nullptr;
thread_local Call* innermost_call = nullptr;

}  // namespace

Argument::Argument() : next_(newest_argument) {
  newest_argument = this;
}
Argument::~Argument() {
  newest_argument = next_;
}

Returned& LastReturned() {
  thread_local Returned returned;
  return returned;
}

Call::Call()
    : arguments_(newest_argument),
      border_(innermost_call ? innermost_call->arguments_ : nullptr),
      outer_(innermost_call) {
  innermost_call = this;
  for (const Argument* argument = arguments_; argument != border_; argument = argument->next_) {
    if (argument->life_) entry_ = argument->life_->entry;
  }
}

Call::~Call() {
  innermost_call = outer_;
}

const Life* Call::first() const {
  const Life* life = nullptr;
  for (const Argument* argument = arguments_; argument != border_; argument = argument->next_) {
    if (argument->life_) life = &*argument->life_;
  }
  return life;
}

bool Call::IsInside() {
  return innermost_call != nullptr;
}

const Life* Call::Near() {
  return innermost_call ? innermost_call->first() : nullptr;
}

void Call::CheckArguments() const {
  for (const Argument* argument = arguments_; argument != border_; argument = argument->next_) {
    if (!argument->life_) continue;
    if (argument->life_->entry != entry_) throw std::invalid_argument("An argument belongs to another kernel.");
    const std::string gone = argument->life_->WhatIsGone();
    if (!gone.empty()) throw Gone(gone);
  }
}

void Call::Now(Hold hold, const std::function<void()>& call) {
  if (!entry_) {
    call();
    return;
  }
  if (!entry_->Enter(outermost())) throw Gone("The kernel of this object has been deleted.");
  struct Leaving {
    KernelEntry& entry;
    ~Leaving() { entry.Leave(true); }
  } leaving{*entry_};
  if (hold == Hold::kNothing) {
    call();
    return;
  }
  entry_->kernel()->Together([&] {
    CheckArguments();
    call();
  });
}

}  // namespace soarbox::bindings
