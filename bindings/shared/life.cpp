// SPDX-License-Identifier: BSD-2-Clause
#include "life.h"

#include <thread>

namespace soarbox::bindings {

namespace {

struct Registry {
  std::mutex mutex;
  std::map<sml::Kernel*, std::shared_ptr<KernelEntry>> entries;
};

/// Never destroyed, because kernels that a program does not shut down still use it while the process ends.
Registry& TheRegistry() {
  static auto* registry = new Registry;
  return *registry;
}

}  // namespace

std::shared_ptr<KernelEntry> KernelEntry::Of(sml::Kernel* kernel) {
  std::shared_ptr<KernelEntry> made;
  {
    const std::lock_guard lock(TheRegistry().mutex);
    auto& entry = TheRegistry().entries[kernel];
    if (entry) return entry;
    entry.reset(new KernelEntry(kernel));
    made = entry;
  }
  // Registered as the first handler, so that calls from the other handlers already get an answer.
  kernel->RegisterForAgentEvent(sml::smlEVENT_BEFORE_AGENT_DESTROYED, &KernelEntry::OnAgentLeaves, made.get());
  return made;
}

std::vector<std::shared_ptr<KernelEntry>> KernelEntry::All() {
  const std::lock_guard lock(TheRegistry().mutex);
  std::vector<std::shared_ptr<KernelEntry>> all;
  for (const auto& [kernel, entry] : TheRegistry().entries) all.push_back(entry);
  return all;
}

void KernelEntry::OnAgentLeaves(sml::smlAgentEventId, void* data, sml::Agent* agent) {
  auto& entry = *static_cast<KernelEntry*>(data);
  const std::lock_guard lock(entry.mutex_);
  entry.leavers_.insert(agent->GetLife());
  entry.has_leavers_ = true;
}

bool KernelEntry::Enter(bool is_new_call) {
  const std::lock_guard lock(mutex_);
  if (closed_ || (is_new_call && let_go_ && !deleting_)) return false;
  ++users_;
  return true;
}

void KernelEntry::Leave(bool own_thread) {
  {
    const std::lock_guard lock(mutex_);
    --users_;
    left_.notify_all();
    if (users_ > 0 || !let_go_ || closed_) return;
    // Handlers that the shutdown calls also enter and leave. They must not delete the kernel.
    ++users_;
  }
  if (own_thread) {
    Delete();
  } else {
    std::thread([self = shared_from_this()] { self->Delete(); }).detach();
  }
}

void KernelEntry::LetGo() {
  {
    const std::lock_guard lock(mutex_);
    if (let_go_) return;
    let_go_ = true;
    if (users_ > 0) {
      kernel_->StopAllAgents();
      return;
    }
    ++users_;
  }
  Delete();
}

void KernelEntry::Delete() {
  {
    const std::lock_guard lock(mutex_);
    deleting_ = true;
  }
  kernel_->Shutdown();
  {
    std::unique_lock lock(mutex_);
    closed_ = true;
    left_.wait(lock, [this] { return users_ == 1; });
  }
  {
    const std::lock_guard lock(TheRegistry().mutex);
    TheRegistry().entries.erase(kernel_);
  }
  delete kernel_;
  DropAll();
}

bool KernelEntry::StopAgent(sml::Agent* agent, unsigned long long agent_life) {
  const std::lock_guard lock(mutex_);
  if (leavers_.count(agent_life) != 0) return false;
  agent->StopSelf();
  return true;
}

void KernelEntry::Keep(unsigned long long agent_life, int id, std::shared_ptr<void> callback) {
  const std::lock_guard lock(mutex_);
  callbacks_[{agent_life, id}].swap(callback);
}

void KernelEntry::Drop(unsigned long long agent_life, int id) {
  std::shared_ptr<void> dropped;
  const std::lock_guard lock(mutex_);
  const auto found = callbacks_.find({agent_life, id});
  if (found == callbacks_.end()) return;
  dropped.swap(found->second);
  callbacks_.erase(found);
}

void KernelEntry::DropAll() {
  Callbacks dropped;
  const std::lock_guard lock(mutex_);
  dropped.swap(callbacks_);
}

void KernelEntry::DropLeavers() {
  std::vector<std::shared_ptr<void>> dropped;
  const std::lock_guard lock(mutex_);
  if (!has_leavers_) return;
  has_leavers_ = false;
  for (auto callback = callbacks_.begin(); callback != callbacks_.end();) {
    if (leavers_.count(callback->first.first) == 0) {
      ++callback;
      continue;
    }
    dropped.push_back(std::move(callback->second));
    callback = callbacks_.erase(callback);
  }
}

Life Life::Of(sml::Kernel* kernel) {
  Life life;
  life.kind = Kind::kKernel;
  life.entry = KernelEntry::Of(kernel);
  return life;
}

Life Life::Of(sml::Agent* agent) {
  Life life = Of(agent->GetKernel());
  life.kind = Kind::kAgent;
  life.agent = agent;
  life.agent_life = agent->GetLife();
  return life;
}

Life Life::Of(sml::WMElement* element) {
  Life life = Of(element->GetAgent());
  life.kind = Kind::kElement;
  life.object = element;
  life.life = element->GetLife();
  return life;
}

Life Life::Of(sml::IdentifierSymbol* symbol, const Life& near) {
  Life life = near;
  life.kind = Kind::kSymbol;
  life.object = symbol;
  life.life = symbol->GetLife();
  return life;
}

std::string Life::WhatIsGone() const {
  if (kind == Kind::kKernel) return {};
  sml::Kernel* kernel = entry->kernel();
  if (!kernel->IsAgentValid(agent) || agent->GetLife() != agent_life) {
    return kind == Kind::kAgent ? "This agent has been destroyed."
                                : "This element of working memory is gone: its agent has been destroyed.";
  }
  if (kind == Kind::kElement && static_cast<const sml::WMElement*>(object)->GetLife() != life) {
    return "This element of working memory is gone: it was destroyed, or the agent removed it from its output.";
  }
  if (kind == Kind::kSymbol && static_cast<const sml::IdentifierSymbol*>(object)->GetLife() != life) {
    return "This identifier is gone: nothing has it as its value any more.";
  }
  return {};
}

}  // namespace soarbox::bindings
