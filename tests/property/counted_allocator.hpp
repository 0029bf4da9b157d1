#pragma once

// Sanitizers have their own allocator: nothing is counted there.
#if !defined(BUMPFOIL_SANITIZED)
#define BUMPFOIL_COUNTS_ALLOCATIONS 1

#include <atomic>

/// The allocator of the C library, which operator new and Eigen also use. It counts allocations, and fails on request.
namespace bumpfoil {

extern std::atomic<long> allocations;    ///< total so far
extern std::atomic<long> held_blocks;    ///< that were allocated and not freed
extern std::atomic<long> until_failure;  ///< allocations up to the single one that fails; 0: none fails

}  // namespace bumpfoil

#endif
