#include "property/counted_allocator.hpp"

#ifdef BUMPFOIL_COUNTS_ALLOCATIONS

#include <cerrno>
#include <cstddef>

namespace bumpfoil {

std::atomic<long> allocations{0};
std::atomic<long> held_blocks{0};
std::atomic<long> until_failure{0};

namespace {

bool is_to_fail() {
  ++allocations;
  if (until_failure == 0 || --until_failure != 0) return false;
  errno = ENOMEM;
  return true;
}

void* counted(void* block) {
  if (block != nullptr) ++held_blocks;
  return block;
}

}  // namespace
}  // namespace bumpfoil

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* block);

// These override the C library's.
void* malloc(std::size_t size) noexcept {
  return bumpfoil::is_to_fail() ? nullptr : bumpfoil::counted(__libc_malloc(size));
}
void* realloc(void* old, std::size_t size) noexcept {
  if (bumpfoil::is_to_fail()) return nullptr;
  void* const block = __libc_realloc(old, size);
  if (old == nullptr) return bumpfoil::counted(block);
  if (block == nullptr && size == 0) --bumpfoil::held_blocks;
  return block;
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  return bumpfoil::is_to_fail() ? nullptr : bumpfoil::counted(__libc_calloc(count, size));
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return bumpfoil::is_to_fail() ? nullptr : bumpfoil::counted(__libc_memalign(alignment, size));
}
int posix_memalign(void** block, std::size_t alignment, std::size_t size) noexcept {
  if (bumpfoil::is_to_fail()) return ENOMEM;
  *block = bumpfoil::counted(__libc_memalign(alignment, size));
  return *block == nullptr ? ENOMEM : 0;
}
void free(void* block) noexcept {
  if (block != nullptr) --bumpfoil::held_blocks;
  __libc_free(block);
}
}

#endif
