#pragma once

#include <array>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "bumpfoil/core/enum_names.hpp"

/// For what an inner loop calls, and for the lambda around it: only what is inlined gets the instructions that were
/// chosen.
#define BUMPFOIL_ALWAYS_INLINE __attribute__((always_inline))

/// Before a loop whose passes neither read nor overwrite what others write: g++ then takes them in vectors without a
/// proof. What it reads again and again belongs into local variables. Clang finds its own way, and would warn where it
/// finds none.
#ifdef __clang__
#define BUMPFOIL_INDEPENDENT
#else
#define BUMPFOIL_INDEPENDENT _Pragma("GCC ivdep")
#endif

/// Defined where there are instructions to choose from. Builds that are compared with others, or measured for coverage,
/// define BUMPFOIL_BASELINE_ONLY.
#if defined(__x86_64__) && !defined(BUMPFOIL_BASELINE_ONLY)
#define BUMPFOIL_WIDE_VECTORS
#endif

// Clang has no option for the width that loops are given; vectors that are spelled out need none.
#ifdef __clang__
#define BUMPFOIL_TARGET_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw,avx2,fma")))
#else
#define BUMPFOIL_TARGET_AVX512 \
  __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw,avx2,fma,prefer-vector-width=512")))
#endif

namespace bumpfoil {

/// Vector instructions chosen at run time, each with all before it. The program runs on any processor of its kind:
/// wider ones are for inner loops alone. Each rounds sums differently.
enum class VectorInstructions {
  baseline,  ///< what the program is built for
  avx2,      ///< with fused multiplication and addition
  avx512,    ///< F, DQ, VL and BW
};

template <>
inline constexpr auto enum_names<VectorInstructions> = std::to_array<std::string_view>({"baseline", "avx2", "avx512"});

/// Those of this processor, the widest last.
const std::vector<VectorInstructions>& vector_instructions();

/// The widest of this processor.
VectorInstructions widest_vector_instructions();

/// Numbers of double precision in a vector, as a type.
template <int N>
using Lanes = std::integral_constant<int, N>;

namespace detail {
#ifdef BUMPFOIL_WIDE_VECTORS
template <typename Body>
__attribute__((target("avx2,fma"))) auto call_with_avx2(Body& body) {
  return body(Lanes<4>());
}
template <typename Body>
BUMPFOIL_TARGET_AVX512 auto call_with_avx512(Body& body) {
  return body(Lanes<8>());
}
#endif
}  // namespace detail

/// Calls `body(Lanes<N>())` compiled for instructions that this processor has. The call costs a few nanoseconds and
/// nothing is inlined across it: it belongs around loops, not inside them.
///
///     with_vectors(widest_vector_instructions(), [&](auto lanes) BUMPFOIL_ALWAYS_INLINE { ... });
///
/// @tparam Least  the narrowest to be compiled, where there are any to choose from; `instructions` are none narrower
/// @param body    a lambda that is BUMPFOIL_ALWAYS_INLINE, as must be all that it calls
template <VectorInstructions Least = VectorInstructions::baseline, typename Body>
auto with_vectors([[maybe_unused]] VectorInstructions instructions, Body&& body) {
#ifdef BUMPFOIL_WIDE_VECTORS
  if (instructions == VectorInstructions::avx512) return detail::call_with_avx512(body);
  if constexpr (Least == VectorInstructions::avx2) {
    return detail::call_with_avx2(body);
  } else {
    if (instructions == VectorInstructions::avx2) return detail::call_with_avx2(body);
    return body(Lanes<2>());
  }
#else
  return body(Lanes<2>());
#endif
}

/// The same with the widest of this processor.
template <typename Body>
auto with_widest_vectors(Body&& body) {
  return with_vectors(widest_vector_instructions(), std::forward<Body>(body));
}

}  // namespace bumpfoil
