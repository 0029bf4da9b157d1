#pragma once

#include <vector>

#include "bumpfoil/structure/foil_structure.hpp"

namespace bumpfoil {

/// Springs of one bump in the truss model of the bump foil [Arghir2019, Fig. 4].
struct TrussConstants {
  double k1{};       ///< rods between crest and feet, N/m
  double k2{};       ///< between the feet before and after the bump, N/m
  double k3{};       ///< between the crest and the one before it, N/m
  double k4{};       ///< between the weld and the crest of bump 1, N/m
  double theta_d{};  ///< inclination of the rods, rad
};

/// A spring whose elongation is linear in the unknowns.
struct Spring {
  struct Term {
    int bump{};
    int dof{};             ///< place in the block of the bump
    double coefficient{};  ///< of the elongation
  };
  double stiffness{};  ///< N/m
  std::vector<Term> terms;
};

/// Springs of a truss, each bump with its own constants. With c = cos(theta_d), s = sin(theta_d), crest (u_c, v_c) of
/// bump n, foot after it (u_f, v_f), foot before it (u_p, v_p; the weld, zero, for n = 1) and crest before it u_q the
/// elongations are
///
///     k1: (u_c - u_p) c - (v_c - v_p) s     k1: (u_f - u_c) c - (v_c - v_f) s
///     k2: u_f - u_p     k3: u_c - u_q (n > 1)     k4: u_c (n = 1)
///
/// [Arghir2019, Eq. 7]. `dofs` has one foot.
/// @param welded  false: free at both ends. The foot before bump 1 is then the foot of block 0, bump n is block n, and
///                there is no k4.
std::vector<Spring> make_truss_springs(const std::vector<TrussConstants>& bumps, const BumpDofs& dofs,
                                       bool welded = true);

/// Half the sum of stiffness * elongation^2, J; `x` holds blocks of `block_size` unknowns.
double spring_energy(const std::vector<Spring>& springs, int block_size, const Vector& x);

/// Adds the Hessian of the energy to K.
void assemble_springs(const std::vector<Spring>& springs, BlockTridiagonal& K);

}  // namespace bumpfoil
