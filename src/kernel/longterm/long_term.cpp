// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/long_term.h"

#include <utility>

#include "kernel/decide/modules.h"

namespace soarbox::kernel {

void LongTerm::Attach(ModuleKind kind, std::unique_ptr<Module> module) {
  parts_.modules.Attach(*module, static_cast<int>(kind));
  modules_[static_cast<std::size_t>(kind)] = std::move(module);
  SetHooks(kind, 0);
}

void LongTerm::SetHooks(ModuleKind kind, ModuleHooks hooks) {
  parts_.modules.SetHooks(*module(kind), hooks | ModuleHook::kIdentifiers);
}

void LongTerm::LinkChanged(Symbol id) {
  parts_.modules.LinkChanged(id);
}

}  // namespace soarbox::kernel
