#include "bumpfoil/core/vector_instructions.hpp"

namespace bumpfoil {
namespace {

std::vector<VectorInstructions> find_vector_instructions() {
  std::vector<VectorInstructions> found{VectorInstructions::baseline};
#ifdef BUMPFOIL_WIDE_VECTORS
  // These also check the operating system, which must save the wider registers.
  const auto has = [](int answer) { return answer != 0; };
  if (!has(__builtin_cpu_supports("avx2")) || !has(__builtin_cpu_supports("fma"))) return found;
  found.push_back(VectorInstructions::avx2);
  if (has(__builtin_cpu_supports("avx512f")) && has(__builtin_cpu_supports("avx512dq")) &&
      has(__builtin_cpu_supports("avx512vl")) && has(__builtin_cpu_supports("avx512bw"))) {
    found.push_back(VectorInstructions::avx512);
  }
#endif
  return found;
}

}  // namespace

const std::vector<VectorInstructions>& vector_instructions() {
  static const std::vector<VectorInstructions> found = find_vector_instructions();
  return found;
}

VectorInstructions widest_vector_instructions() {
  return vector_instructions().back();
}

}  // namespace bumpfoil
