// SPDX-License-Identifier: BSD-2-Clause
#include "diagnostics/counted_allocations.h"

#include <cstdlib>
#include <new>

// GCC 12 sees the inlined std::free, but not that this program's own operator new used std::malloc.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

namespace soarbox::allocations {
namespace {

constexpr std::int64_t kNever = -1;
std::int64_t left = kNever, count = 0, live = 0;
Refusal refusal = Refusal::kOnce;

void* Allocate(std::size_t size) {
  if (left == 0) {
    if (refusal == Refusal::kOnce) left = kNever;
    throw std::bad_alloc();
  }
  if (left > 0) --left;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  ++count;
  ++live;
  return memory;
}

void Free(void* memory) {
  if (memory != nullptr) --live;
  std::free(memory);
}

}  // namespace

std::int64_t Count() {
  return count;
}

std::int64_t Live() {
  return live;
}

void RefuseAfter(std::int64_t allocations, Refusal how) {
  left = allocations;
  refusal = how;
}

void Allow() {
  left = kNever;
}

}  // namespace soarbox::allocations

void* operator new(std::size_t size) {
  return soarbox::allocations::Allocate(size);
}
void operator delete(void* memory) noexcept {
  soarbox::allocations::Free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  soarbox::allocations::Free(memory);
}
