#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <optional>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// A pole s of the pencil J + s S, as its operator C sees it (film_impedance.hpp): with w = S X of its motion X,
///
///     w = (s - shift) C w
struct FilmPole {
  std::complex<double> excess;  ///< s - shift
  Eigen::VectorXcd stored;      ///< w
  double covered{};             ///< no pole lies further right up to this imaginary part, within the search
};

/// The rightmost pole, from eigenvalues 1 / (s - shift) of the real operator C in its Krylov space on a vector with
/// components in all directions. Poles close to the shift converge first. All poles inside a circle about the shift are
/// known once all Ritz values there have converged. The space grows until this circle covers all imaginary parts up to
/// `frequency` to the right of the rightmost pole.
/// | Poles of a film on foils with imaginary parts beyond a few rotation speeds are heavily damped: shorter waves,
/// carried along by the speed, diffuse faster (docs/theory/gas_film.md).
/// | @param stored     C: storage in response to storage rates
/// @param size       of its vectors
/// @param frequency  imaginary part to be covered
/// @return nothing if the space cannot resolve it; of a pair of poles, the one above the real axis
std::optional<FilmPole> rightmost_pole(const std::function<Vector(const Vector&)>& stored, Eigen::Index size,
                                       double frequency);

}  // namespace bumpfoil
