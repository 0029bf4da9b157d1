#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <optional>
#include <vector>

#include "bearing/krylov_space.hpp"
#include "bearing/schur_form.hpp"

namespace bumpfoil {

/// A pole s of the pencil J + s S, as its operator C sees it (film_impedance.hpp): with w = S X of its motion X,
///
///     w = (s - shift) C w
struct FilmPole {
  std::complex<double> excess;  ///< s - shift
  Eigen::VectorXcd stored;      ///< w
  double covered{};             ///< imaginary part up to which no pole lies further right, as far as the search sees
};

/// Directions of a space that is given up: 20 to 40 serve 6 x 8 and 12 x 16 at 1,000 to 200,000 rpm.
inline constexpr Eigen::Index most_pole_directions = 200;

/// C: what is stored in answer to rates of storage, to as many at once as the space has next directions.
using StoredContents = std::function<std::vector<Vector>(const std::vector<Vector>& rates)>;

/// A vector that holds something of all directions, the same on all machines.
Vector random_start(Eigen::Index size);

/// The pole that lies farthest to the right, from eigenvalues 1 / (s - shift) of the real operator C in a Krylov space
/// of it on vectors that hold something of its motion. Poles close to the shift converge first. All those inside a
/// circle about the shift are known when all Ritz values there have converged; the space grows until the circle is so
/// large that right of the rightmost pole it holds all imaginary parts up to `frequency`.
///
/// Poles of a film on foils with larger imaginary parts than a few speeds of rotation are heavily damped: what the
/// speed carries along, a film diffuses the faster the shorter it is (docs/theory/gas_film.md).
///
/// @param stored     C
/// @param space      of C; may hold directions already
/// @param form       of its H, where that is known
/// @param frequency  to be covered
/// @return nothing if the space does not grow to hold it; where poles are a pair, the one above the real axis
std::optional<FilmPole> rightmost_pole(const StoredContents& stored, KrylovSpace space, std::optional<SchurForm> form,
                                       double frequency);

}  // namespace bumpfoil
