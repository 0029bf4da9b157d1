#pragma once

#include <string>
#include <vector>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/rotor/rotor.hpp"

namespace bumpfoil {

/// A place on a rotor that is given by its matrices.
struct MatrixPlace {
  std::string name;
  double z{};  ///< along the axis, m
  int x{};     ///< number of the unknown that is the displacement along X there, from 0
  int y{};     ///< and along Y

  bool operator==(const MatrixPlace&) const = default;
};

/// Matrices of M y'' + (Omega G + C) y' + K y = f, see Rotor, of a rotor that nothing holds, row by row. Unknowns are
/// displacements (m) at the places, and whatever else the maker of the matrices chose. SI units.
struct RotorMatrices {
  std::vector<double> mass;        ///< M, n x n
  std::vector<double> damping;     ///< C
  std::vector<double> gyroscopic;  ///< G
  std::vector<double> stiffness;   ///< K
  std::vector<MatrixPlace> bearings;
  std::vector<MatrixPlace> stations{};

  bool operator==(const RotorMatrices&) const = default;
};

/// Unknowns of a rotor that is given by its matrices.
inline constexpr int most_rotor_unknowns = 300;

/// Reasons why matrices are not those of a rotor: sizes, numbers that are not finite, M, C or K not symmetric, M not
/// positive definite, K not positive semidefinite, G not antisymmetric, unknowns that are not there, a stiffness that
/// holds the rotor or lets go of a part of it, places that do not lie where a tilt of the rotor has them, gyroscopic
/// terms of the other sense of rotation. Their keys are "M", "bearing[1].x"; matrices that are wrong in themselves are
/// not checked further.
std::vector<InputError> find_matrix_errors(const RotorMatrices& matrices);

/// Rigid motions are those that follow the bearings without a force.
/// @pre find_matrix_errors() finds none
Rotor make_rotor(const RotorMatrices& matrices);

}  // namespace bumpfoil
