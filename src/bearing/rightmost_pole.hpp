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
  double covered{};             ///< imaginary part up to which no pole lies further right, as far as the search sees
};

/// The pole that lies farthest to the right, from eigenvalues 1 / (s - shift) of the real operator C in its Krylov
/// space on a vector that holds something of all directions. Poles close to the shift converge first. All those inside
/// a circle about the shift are known when all Ritz values there have converged; the space grows until the circle is so
/// large that right of the rightmost pole it holds all imaginary parts up to `frequency`.
///
/// Poles of a film on foils with larger imaginary parts than a few speeds of rotation are heavily damped: what the
/// speed carries along, a film diffuses the faster the shorter it is (docs/theory/gas_film.md).
///
/// @param stored     C: what is stored in answer to rates of storage
/// @param size       of its vectors
/// @param frequency  to be covered
/// @return nothing if the space does not grow to hold it; where poles are a pair, the one above the real axis
std::optional<FilmPole> rightmost_pole(const std::function<Vector(const Vector&)>& stored, Eigen::Index size,
                                       double frequency);

}  // namespace bumpfoil
