#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "bumpfoil/film/asperities.hpp"
#include "bumpfoil/film/gas.hpp"
#include "bumpfoil/film/reynolds.hpp"
#include "bumpfoil/structure/forming.hpp"
#include "bumpfoil/structure/membrane.hpp"
#include "bumpfoil/structure/width_lines.hpp"

namespace bumpfoil {

/// A film on a top foil that is welded at column 0 and free at the last one. Every column is a node of the top foil in
/// its moment form, so that the foil sags between its supports exactly as the loads at the columns make it. A plain
/// value.
///
/// Displacements are in units of c, moments in units of EI' c / p^2. With the excess of pressure integrated over the
/// volumes, the balance and the compatibility of node k are, divided by EI' c / p^3 and by c / p,
///
///     p (D M)_k - load_scale omega_k sum_j omega_j (P_jk - 1 + P_c(H_jk)) = - forces of what supports the foil there
///     p (D' U)_k - EI'/p (T M)_k - p r_k / c = 0
///
/// with D, T of TopFoilMoments, r of forming_rotations(), M = 0 at the free end and U = 0 at the weld; omega_k and
/// omega_j are the weights of column and row; P_c is the pressure of asperities, where they touch.
///
/// A foil whose displacement varies over the width has such U and M on each of the lines that give it (WidthLines), by
/// shapes N_s(zeta): its beam there is `weight` times as stiff as the whole width, and is loaded by
/// sum_j omega_j N_s(zeta_j) (P_jk - 1 + P_c(H_jk)). What varies over the width stretches the foil, which the unknowns
/// F and g of its membrane (MembraneRows, F in units of EI' c / p^4, lengths in units of p) add to the balances:
///
///     + w_k sum_k F_k to_modes(k, s)
struct FoilFilm {
  FilmMesh mesh;                         ///< slotted
  TopFoilMoments top_foil;               ///< its node k is column k + 1
  double stiffness{};                    ///< EI' / p^3, N/m
  double pitch{};                        ///< p, m
  double load_scale{};                   ///< pa R^2 dtheta dzeta / (c stiffness), times FilmMesh::copies()
  Vector forming;                        ///< p r / c of all columns but the last
  std::optional<Asperities> asperities;  ///< of journal and foil, in units of pa and c; none: smooth surfaces
  std::vector<int> supports;  ///< columns where something may support the foil: increasing, none at or next to the
                              ///< ends
  WidthLines lines{make_width_lines(1, WidthPart::half)};
  Matrix shapes;                       ///< N_s of each line, in every row of nodes
  Matrix stretching;                   ///< WidthLines::to_stretching_modes()
  std::vector<MembraneRows> membrane;  ///< of all columns but the last; none where nothing stretches the foil

  /// Unknowns of the foil in a column: U, then M of all lines, F, then g of all modes that stretch it.
  [[nodiscard]] Eigen::Index unknowns() const { return 2 * (lines.count() + stretching.rows()); }
};

/// How the displacement of a foil varies over the width, and what the foil is as a membrane.
struct FoilSheet {
  int modes{1};         ///< of make_width_lines(); 1: not at all
  double stretching{};  ///< E t, N/m
  double poisson_ratio{};
};

/// @param mesh               slotted, from the weld on
/// @param bending_stiffness  EI' of the top foil, N m^2
/// @param pitch              p, m: any length sets the scale, the distance of supports is the natural one
FoilFilm make_foil_film(const FilmMesh& mesh, const FilmScales& scales, double bending_stiffness, double pitch,
                        std::vector<int> supports, const Forming& forming = {}, const FoilSheet& sheet = {});

/// State of a film and the foil under it: a plain value.
struct FoilFilmState : FilmState {
  Matrix deflection;  ///< U of all columns, outward, a row for each line; part of H
  Matrix moment;      ///< M of all columns, of each line
  Matrix membrane;    ///< F of all columns and of each mode that stretches the foil, then g
};

/// P_c at all nodes; zero on smooth surfaces.
Matrix asperity_pressures(const FoilFilm& foil, const Matrix& thickness);

/// What such pressures, or their changes, add to the balances of all lines and columns.
Matrix asperity_balance(const FoilFilm& foil, const Matrix& pressures);

/// A film at P = 1 on an undeformed foil.
FoilFilmState undeformed(const FoilFilm& foil, const Matrix& thickness);

/// Residuals of the equations, without the forces of supports.
struct FoilFilmResidual {
  Matrix film;           ///< of reynolds_residual
  Matrix balance;        ///< of every column, a row for each line; zero at the weld
  Matrix compatibility;  ///< the same; zero at the free end
  Matrix membrane;       ///< of the rows of the membrane; zero at the free end
};

void foil_film_residual(const FoilFilm& foil, const ReynoldsEquation& equation, const FoilFilmState& state,
                        FoilFilmResidual& residual);

/// The same for the foil alone, as if it were smooth and formed to the bearing; does not change the part of the film.
void foil_residual(const FoilFilm& foil, const FoilFilmState& state, FoilFilmResidual& residual);

/// Newton's method for film and foil, condensed to the columns over supports and the free end: their unknowns are the
/// pressures of the rows where they are unknown, then those of the foil (FoilFilm::unknowns()); block i is support i,
/// the last one the free end. The columns between two of them are eliminated one by one, with both held. At the free
/// end, U alone is unknown: the other unknowns must be given as zero, and their rows mean nothing.
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
  /// dP_c/dH of asperities at all nodes there; zero on smooth surfaces.
  [[nodiscard]] const Matrix& asperity_slopes() const;

  [[nodiscard]] int blocks() const;
  [[nodiscard]] int block_size() const;
  /// Derivatives of block i with respect to the one before it, itself and the one after it.
  [[nodiscard]] const Block& lower(int i) const;
  [[nodiscard]] const Block& diagonal(int i) const;
  [[nodiscard]] const Block& upper(int i) const;
  /// Condenses residuals, all in one pass through the factors. With the film's per area of a cell.
  void condense(std::span<const FoilFilmResidual> residuals);
  /// What was condensed last: one behind the other, with a column for each block.
  [[nodiscard]] const Matrix& condensed() const;

  /// The steps that take the residuals that were condensed last to zero wherever nothing supports the foil.
  /// @param support_steps  steps of the blocks, in the order of the condensed residuals
  /// @param steps          result: P, U (also as that of H), M and the membrane's unknowns of all columns
  void expand(const Matrix& support_steps, std::span<FoilFilmState> steps);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace bumpfoil
