#pragma once

#include <cstdint>
#include <memory>

#include "bumpfoil/core/status.hpp"
#include "bumpfoil/film/reynolds.hpp"

namespace bumpfoil {

/// The bearing surface of the film: its deflection under pressure. H = H_rigid + compliance * yield, where the yield at
/// a node is
enum class FoundationKind : std::uint8_t {
  rigid,       ///< 0
  pointwise,   ///< P - 1 at the node itself
  axial_mean,  ///< the mean of P - 1 over the column
};

/// A rigid bearing surface or an elastic (Winkler) foundation.
struct Foundation {
  FoundationKind kind{FoundationKind::rigid};
  double compliance{};  ///< alpha = pa / (c k) with k in Pa/m, >= 0
};

/// Adds the deflection of the foundation under the gauge pressure P - 1 to `thickness`. Linear: given a step of P it
/// adds that of H.
void add_yield(const Foundation& foundation, const FilmMesh& mesh, const Matrix& excess, Matrix& thickness);

struct FilmSolverOptions {
  double step_tolerance{1e-9};   ///< largest change of P and H in a full step of a film that has converged
  double thickness_floor{0.0};   ///< H below which surfaces count as touching
  double kept_fraction{0.3};     ///< no step reduces any P or H by more than 1 - this
  double largest_approach{1.0};  ///< no step changes H by more than this
  int max_iterations{100};
};

/// Largest fraction of a Newton step, at most 1, that reduces P and H by no more than the options allow.
double longest_step(const FilmSolverOptions& options, const FilmState& film, const FilmState& step);

/// How a solve ended and what it cost.
struct FilmReport {
  Status status{Status::not_converged};
  int iterations{};      ///< Newton steps; but for the last ones a factorisation of the film each
  int factorisations{};  ///< of contact systems, where there are contacts
  double residual{};     ///< norm of the residuals at the last step, the film's per area of a cell
  int jumps{};           ///< of a path: jumps off branches that end, to the state that the film settles to in time
  /// Of a solve with foils that started at a state: the largest change of P, U and position over c that the tangent
  /// there predicts, and the largest difference between the state that was found and the predicted one.
  double predicted_change{}, departure{};

  /// Adds what comes after it, whose status and residual count.
  FilmReport& operator+=(const FilmReport& next);
};

/// Newton's method for the pressure over a rigid bearing surface or an elastic (Winkler) foundation. Steps are cut so
/// that P and H stay positive, and halved while the residual does not fall, eight times at most. Keeps its storage
/// between solves.
class FilmSolver {
 public:
  FilmSolver(const FilmMesh& mesh, const Foundation& foundation,
             const FilmSolverOptions& options = FilmSolverOptions());
  ~FilmSolver();

  /// Finds the film.
  /// @param equation         on the mesh of this solver
  /// @param rigid_thickness  H without any yield of the foundation, at all nodes
  /// @param film             its pressure is the first guess and gives P at the edges; receives the film, unless the
  ///                         status is not_converged or no_room: then it stays as it was
  [[nodiscard]] FilmReport solve(const ReynoldsEquation& equation, const Matrix& rigid_thickness, FilmState& film);

  /// Finds the films from the rigid thickness `from` to `to` in steps of adaptive length, for when Newton's method
  /// needs a nearby start. `film` must be the film at `from`; it receives the one at the end, or the last that
  /// converged.
  [[nodiscard]] FilmReport follow(const ReynoldsEquation& equation, const Matrix& from, const Matrix& to,
                                  FilmState& film);

 private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

}  // namespace bumpfoil
