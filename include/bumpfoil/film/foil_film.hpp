#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bumpfoil/film/asperities.hpp"
#include "bumpfoil/film/gas.hpp"
#include "bumpfoil/film/reynolds.hpp"
#include "bumpfoil/structure/forming.hpp"

namespace bumpfoil {

/// A film on a top foil that is welded at column 0 and free at the last one. Every column is a node of the top foil in
/// its moment form, so that the foil sags between its supports exactly as the loads at the columns make it. A plain
/// value.
///
/// Displacements are in units of c, moments in units of EI' c / p^2. With the excess of pressure integrated over the
/// volumes, the balance and the compatibility of node k are, divided by EI' c / p^3 and by c / p,
///
///     p (D M)_k - load_scale omega_k sum_j omega_j (P_jk - 1 + P_c(H_k)) = - forces of what supports the foil there
///     p (D' U)_k - EI'/p (T M)_k - p r_k / c = 0
///
/// with D, T of TopFoilMoments, r of forming_rotations(), M = 0 at the free end and U = 0 at the weld; omega_k and
/// omega_j are the weights of column and row; P_c is the pressure of asperities, where they touch.
struct FoilFilm {
  FilmMesh mesh;                         ///< slotted
  TopFoilMoments top_foil;               ///< its node k is column k + 1
  double stiffness{};                    ///< EI' / p^3, N/m
  double pitch{};                        ///< p, m
  double load_scale{};                   ///< 2 pa R^2 dtheta dzeta / (c stiffness)
  Vector forming;                        ///< p r / c of all columns but the last
  std::optional<Asperities> asperities;  ///< of journal and foil, in units of pa and c; none: smooth surfaces
  std::vector<int> supports;  ///< columns where something may support the foil: increasing, none at or next to the
                              ///< ends, no two neighbours
};

/// @param mesh               slotted, from the weld on
/// @param bending_stiffness  EI' of the top foil, N m^2
/// @param pitch              p, m: any length sets the scale, the distance of supports is the natural one
FoilFilm make_foil_film(const FilmMesh& mesh, const FilmScales& scales, double bending_stiffness, double pitch,
                        std::vector<int> supports, const Forming& forming = {});

/// State of a film and the foil under it: a plain value.
struct FoilFilmState : FilmState {
  Vector lift;    ///< U of all columns, outward; part of H
  Vector moment;  ///< M of all columns
};

/// P_c at all columns; zero on smooth surfaces. H is that of row 0: foils are the same over the width.
Vector asperity_pressures(const FoilFilm& foil, const Matrix& thickness);

/// What such pressures, or their changes, add to the balances of all columns.
Vector asperity_balance(const FoilFilm& foil, Vector pressures);

/// A film at P = 1 on an undeformed foil.
FoilFilmState undeformed(const FoilFilm& foil, const Matrix& thickness);

/// Residuals of the equations, without the forces of supports.
struct FoilFilmResidual {
  Matrix film;           ///< of reynolds_residual
  Vector balance;        ///< of every column; zero at the weld
  Vector compatibility;  ///< of every column; zero at the free end
};

void foil_film_residual(const FoilFilm& foil, const ReynoldsEquation& equation, const FoilFilmState& state,
                        FoilFilmResidual& residual);

/// The same for the foil alone, as if it were smooth and formed to the bearing; does not change the part of the film.
void foil_residual(const FoilFilm& foil, const FoilFilmState& state, FoilFilmResidual& residual);

/// Newton's method for film and foil, condensed to the columns over supports and the free end: their unknowns are the
/// pressures of rows 0 to rows - 1, U and M, in this order; block i is support i, the last one the free end. The
/// columns between two of them are eliminated one by one, with both held. At the free end, U alone is unknown: the
/// other unknowns must be given as zero, and their rows mean nothing.
class FoilFilmSystem {
 public:
  using Block = Matrix;

  explicit FoilFilmSystem(const FoilFilm& foil);
  ~FoilFilmSystem();

  /// Factors the equations at `state` and condenses them.
  /// @return false if they are singular
  [[nodiscard]] bool linearise(const ReynoldsEquation& equation, const FoilFilmState& state);

  /// Derivatives of the film's residuals where it was linearised last.
  [[nodiscard]] const FilmJacobian& film_jacobian() const;
  /// dP_c/dH of asperities at all columns there.
  [[nodiscard]] const Vector& asperity_slopes() const;

  [[nodiscard]] int blocks() const;
  [[nodiscard]] int block_size() const;
  /// Derivatives of block i with respect to the one before it, itself and the one after it.
  [[nodiscard]] const Block& lower(int i) const;
  [[nodiscard]] const Block& diagonal(int i) const;
  [[nodiscard]] const Block& upper(int i) const;
  /// Condensed residuals of `residual`: a column for each block. With the film's per area of a cell.
  [[nodiscard]] const Matrix& condense(const FoilFilmResidual& residual);

  /// The step that takes the residuals that were condensed last to zero wherever nothing supports the foil.
  /// @param support_step  steps of the blocks, a column for each
  /// @param step          result: P, U (also as that of H) and M of all columns
  void expand(const Matrix& support_step, FoilFilmState& step);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace bumpfoil
