#pragma once

// Under a sanitizer the allocator is its own: nothing is counted there.
#if !defined(__SANITIZE_ADDRESS__)
#define BUMPFOIL_COUNTS_ALLOCATIONS 1

#include <atomic>

/// The allocator of the C library, where operator new and Eigen end, too. It is counted, and fails where it is told to.
namespace bumpfoil {

extern std::atomic<long> allocations;    ///< until now
extern std::atomic<long> held_blocks;    ///< that were allocated and not freed
extern std::atomic<long> until_failure;  ///< allocations up to the one that fails, and no other; 0: none does

}  // namespace bumpfoil

#endif
