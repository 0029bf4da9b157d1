#include "bearing/film_newton.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bearing/film_impedance.hpp"
#include "bearing/rightmost_pole.hpp"
#include "bumpfoil/bearing/backward_difference.hpp"
#include "bumpfoil/contact/coulomb_contact.hpp"

namespace bumpfoil {
namespace {

/// Largest change of the clearance in one step, in units of c, and residual weight of the remaining change, per c. Both
/// dimensionless and equal to those of a journal at a given position, see journal_law.cpp.
constexpr double longest_clearance_step = 0.00625;
constexpr double weight_of_clearance = 30.0;

/// Rounds of mode changes in the contact problem of a step, before fallback to path following and interior point, which
/// cost 10 to 30 factorisations.
constexpr int rounds_of_modes = 6;

/// Search for poles with the journal held: the shift, to the right of all poles, and the largest imaginary part, both
/// in units of the rotation speed. Faster film poles are damped at several times the speed.
constexpr double shift_in_speeds = 2.0;
constexpr double frequency_in_speeds = 3.0;
/// Lower bound of the speed there, in units of 1 / T0, so that a journal at rest also has a shift.
constexpr double least_rate = 1e-2;
/// Largest accepted residual of all equations for a pole, relative to the storage of its motion.
constexpr double largest_residual = 1e-8;

/// Square of the norm of the residuals of a film per cell area.
double film_square(const FilmMesh& mesh, const Matrix& residual) {
  return mesh.unknown(residual).squaredNorm() / (mesh.dtheta * mesh.dtheta * mesh.dzeta * mesh.dzeta);
}

/// Sets the residuals of a foil in equilibrium.
void set_zero(const FoilFilm& foil, FoilFilmResidual& residual) {
  residual.balance.setZero(foil.lines.count(), foil.mesh.nodes());
  residual.compatibility.setZero(foil.lines.count(), foil.mesh.nodes());
  residual.membrane.setZero(2 * foil.stretching.rows(), foil.mesh.nodes());
}

Eigen::Index unknown_pressures_of(const FilmMesh& mesh) {
  return Eigen::Index{mesh.unknown_rows()} * mesh.unknown_columns();
}

}  // namespace

FilmNewton::Part::Part(const FilmPad& of_pad) : pad(of_pad), system(of_pad.foil), residuals(1), changes(1) {}

FilmNewton::FilmNewton(SharedBearing bearing, const FilmSolverOptions& options)
    : shared_(std::move(bearing)),
      options_(options),
      parts_(film_.pads.begin(), film_.pads.end()),
      modes_(make_mode_system(bearing_.problem)),
      contacts_(SharedProblem({shared_, &bearing_.problem}), modes_, {.max_mode_updates = rounds_of_modes}),
      K_(bearing_.problem.K),
      loading_(ContactLoading::none(bearing_.problem)),
      begin_(ContactState::unstressed(bearing_.problem)),
      rates_(static_cast<std::size_t>(film_.motions())) {
  for (const Matrix& block : K_.upper) K_.lower.push_back(block.transpose());
  bump_K_ = K_;
}

template <typename Visitor>
void FilmNewton::for_each_place(const FilmPad& pad, int support, Visitor&& visit) const {
  const int n = pad.foil.mesh.unknown_rows();
  const int station = pad.station_of(support);
  const int first_pressure = bearing_.first_pressure(station);
  const auto lines = static_cast<int>(pad.foil.lines.count());
  if (support == std::ssize(pad.foil.supports)) {
    for (int s = 0; s < lines; ++s) visit(first_pressure + s, n + s);  // the free end
    return;
  }
  for (int j = 0; j < n; ++j) visit(first_pressure + j, j);
  for (int s = 0; s < lines; ++s) {
    const Eigen::Index line = pad.line_over(support, s);
    visit(BearingModel::place(bearing_.lines, line, bearing_.structure.dofs.top_u), n + s);
    visit(BearingModel::place(bearing_.lines, line, bearing_.structure.dofs.top_moment), n + lines + s);
  }
  const int of_membrane = 2 * static_cast<int>(pad.foil.stretching.rows());
  for (int i = 0; i < of_membrane; ++i) visit(bearing_.first_of_membrane(station) + i, n + 2 * lines + i);
}

/// Restoring forces of the bump foils at their displacements, N; fixed unknowns of the last blocks contribute none.
Vector& FilmNewton::find_bump_forces(const ContactState& state) {
  const Eigen::Index size = bump_K_.block_size();
  bump_forces_ = bump_K_.multiply(state.x);
  for (const FilmPad& pad : film_.pads) {
    bump_forces_.segment((pad.first_block + pad.bumps()) * size, size).setZero();
  }
  return bump_forces_;
}

/// Transfers the crest forces on the top foil, N, to the balances of its columns.
void FilmNewton::add_supports(const FilmPad& pad, Vector& forces, Matrix& balance) const {
  const double unit = pad.foil.stiffness * film_.scales.thickness;
  for (int i = 0; i < std::ssize(pad.foil.supports); ++i) {
    const Eigen::Index block = Eigen::Index{pad.block_of(i)} * bump_K_.block_size();
    for (Eigen::Index s = 0; s < balance.rows(); ++s) {
      double& support =
          forces[block + BearingModel::place(bearing_.lines, pad.line_over(i, s), bearing_.structure.dofs.top_u)];
      balance(s, pad.foil.supports[static_cast<std::size_t>(i)]) += support / unit;
      support = 0.0;
    }
  }
}

/// Residuals of film and foil without contact forces. The norm includes them; its units are: film per cell area, forces
/// EI' c / p^3, compatibility c / p, clearance offset c / weight_of_clearance.
double FilmNewton::find_residual() {
  const BearingState& state = trial_;
  const ContactState& contact = state.contacts;
  set_sides(1);
  Vector& forces = find_bump_forces(contact);
  forces -= contact_forces(bearing_.problem, contact.normal_force, contact.friction_force);
  const Eigen::Index size = bump_K_.block_size();
  double square = 0.0;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    Part& part = parts_[k];
    const FilmPad& pad = part.pad;
    const FilmMesh& mesh = pad.foil.mesh;
    FoilFilmResidual& residual = part.residuals.front();
    read_part(pad, state.film, part.state);
    foil_film_residual(pad.foil, equations_[k], part.state, residual);
    square += film_square(mesh, residual.film);
    const double unit = pad.foil.stiffness * film_.scales.thickness;
    Matrix balance = residual.balance;
    add_supports(pad, forces, balance);
    square += balance.squaredNorm() + residual.compatibility.squaredNorm() + residual.membrane.squaredNorm() +
              forces.segment(pad.first_block * size, (pad.bumps() + 1) * size).squaredNorm() / (unit * unit);
  }
  force_ = journal_force(film_, state.film, state.speed);
  const double clearance_offset =
      weight_of_clearance * (clearance_offset_ - state.clearance_offset) / film_.scales.thickness;
  return square + clearance_offset * clearance_offset;
}

/// Combines the condensed films and the bump foils in one matrix. Unknowns in m, rows in N.
void FilmNewton::assemble() {
  K_ = bump_K_;
  for (const Part& part : parts_) {
    const double scale = part.pad.foil.stiffness;
    const int blocks = part.system.blocks();
    // Column by column, in storage order.
    const auto add = [&](Matrix& to, int row_block, int column_block, const Matrix& film) {
      for_each_place(part.pad, column_block, [&](int place, int film_place) {
        double* column = to.col(place).data();
        const double* film_column = film.col(film_place).data();
        for_each_place(part.pad, row_block,
                       [&](int row, int film_row) { column[row] += scale * film_column[film_row]; });
      });
    };
    for (int b = 0; b < blocks; ++b) {
      const auto i = static_cast<std::size_t>(part.pad.block_of(b));
      add(K_.diagonal[i], b, b, part.system.diagonal(b));
      if (b == 0) continue;
      const auto before = static_cast<std::size_t>(part.pad.block_of(b - 1));
      add(before == i ? K_.diagonal[i] : K_.lower[before], b, b - 1, part.system.lower(b));
      add(before == i ? K_.diagonal[i] : K_.upper[before], b - 1, b, part.system.upper(b - 1));
    }
  }
}

/// Sets the number of residuals that are solved for together.
void FilmNewton::set_sides(std::size_t count) {
  for (Part& part : parts_) {
    part.residuals.resize(count);
    part.changes.resize(count);
  }
}

void FilmNewton::condense() {
  for (Part& part : parts_) part.system.condense(part.residuals);
}

/// Adds condensed residuals to the loads of the contact problem.
void FilmNewton::load_condensed(std::size_t side) {
  for (const Part& part : parts_) {
    const double unit = part.pad.foil.stiffness * film_.scales.thickness;
    const int blocks = part.system.blocks();
    const Matrix& condensed = part.system.condensed();
    for (int b = 0; b < blocks; ++b) {
      const Eigen::Index first = Eigen::Index{part.pad.block_of(b)} * K_.block_size();
      const Eigen::Index column = static_cast<Eigen::Index>(side) * blocks + b;
      for_each_place(part.pad, b, [&](int place, int film_place) {
        loading_.load[first + place] -= unit * condensed(film_place, column);
      });
    }
  }
}

/// Changes of the blocks from the contact problem, and of the columns in between.
void FilmNewton::expand(std::span<Step> changes) {
  const FoilFilm& foil = film_.pads.front().foil;
  for (Step& change : changes) {
    change.film.pressure.resize(foil.mesh.rows + 1, film_.columns());
    change.film.thickness.resize(foil.mesh.rows + 1, film_.columns());
    change.film.deflection.resize(foil.lines.count(), film_.columns());
    change.film.moment.resize(foil.lines.count(), film_.columns());
    change.film.membrane.resize(2 * foil.stretching.rows(), film_.columns());
  }
  for (Part& part : parts_) {
    const int blocks = part.system.blocks();
    part.support_steps.setZero(part.system.block_size(), std::ssize(changes) * blocks);
    for (std::size_t side = 0; side < changes.size(); ++side) {
      const Vector& x = changes[side].contact.x;
      for (int b = 0; b < blocks; ++b) {
        const Eigen::Index first = Eigen::Index{part.pad.block_of(b)} * K_.block_size();
        const Eigen::Index column = static_cast<Eigen::Index>(side) * blocks + b;
        for_each_place(part.pad, b, [&](int place, int film_place) {
          part.support_steps(film_place, column) = x[first + place] / film_.scales.thickness;
        });
      }
    }
    part.system.expand(part.support_steps, part.changes);
    for (std::size_t side = 0; side < changes.size(); ++side) {
      write_part(part.pad, part.changes[side], changes[side].film);
    }
  }
}

/// Changes of all unknowns that cancel the given residuals of films and foils, one set for each: at the last
/// linearisation, in the modes set last.
void FilmNewton::answer(std::span<Step> changes) {
  condense();
  loading_.initial_gap.setZero();
  const Vector none = Vector::Zero(K_.rows());
  for (std::size_t side = 0; side < changes.size(); ++side) {
    loading_.load.setZero();
    load_condensed(side);
    modes_->solve(loading_, none, changes[side].contact);
  }
  expand(changes);
}

/// Change of the force on the journal due to pressure and asperities, at the last linearisation.
JournalVector FilmNewton::force_of(const FoilFilmState& change) const {
  JournalVector force = film_force(film_, film_.field(1.0) + change.pressure);
  if (film_.surroundings.asperities) force += asperity_force_of(change);
  return force;
}

/// Contribution of asperities.
JournalVector FilmNewton::asperity_force_of(const FoilFilmState& change) const {
  Matrix pressures(change.thickness.rows(), film_.columns());
  for (const Part& part : parts_) {
    pressures(Eigen::all, part.pad.columns()) =
        part.system.asperity_slopes().cwiseProduct(part_of(part.pad, change.thickness));
  }
  return asperity_force(film_, pressures, friction_);
}

/// Rates of all unknowns for each `rigid`, a rate of H with rigid foils, 1/m: at the last linearisation, in the modes
/// set last.
void FilmNewton::find_rates(std::span<const Matrix> rigid, std::span<Step> rates) {
  set_sides(rigid.size());
  for (Part& part : parts_) {
    const FoilFilm& foil = part.pad.foil;
    for (std::size_t side = 0; side < rigid.size(); ++side) {
      FoilFilmResidual& residual = part.residuals[side];
      const Matrix change = part_of(part.pad, rigid[side]);
      residual.film = stencil_product(foil.mesh, part.system.film_jacobian().by_thickness, change);
      set_zero(foil, residual);
      residual.balance = asperity_change(part, change);
    }
  }
  answer(rates);
  for (std::size_t side = 0; side < rigid.size(); ++side) rates[side].film.thickness += rigid[side];
}

JournalMatrix FilmNewton::find_rates() {
  if (factors_of_rates_ == modes_->factorisations()) return K_film_;
  const Eigen::Index motions = film_.motions();
  std::vector<Matrix> rigid;
  rigid.reserve(rates_.size());
  for (Eigen::Index i = 0; i < motions; ++i) rigid.push_back(film_.thickness_change(JournalVector::Unit(motions, i)));
  find_rates(rigid, rates_);
  K_film_.resize(motions, motions);
  for (Eigen::Index i = 0; i < motions; ++i) K_film_.col(i) = force_of(rates_[static_cast<std::size_t>(i)].film);
  factors_of_rates_ = modes_->factorisations();
  return K_film_;
}

/// @return whether all films are regular
bool FilmNewton::linearise_films(const FilmEquations& equations, const BearingState& state) {
  friction_ = sliding_friction(film_, state.speed);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    Part& part = parts_[k];
    read_part(part.pad, state.film, part.state);
    if (!part.system.linearise(equations[k], part.state)) return false;
  }
  return true;
}

/// Linearises about a state, with contacts in its modes, or with all closed ones sticking.
/// @return whether the system is regular
bool FilmNewton::linearise(const FilmEquations& equations, const BearingState& state, bool stuck) {
  if (!linearise_films(equations, state)) return false;
  assemble();
  modes_->set_elasticity(K_);
  std::vector<ContactMode> held = state.contacts.mode;
  for (ContactMode& mode : held) {
    if (stuck && mode != ContactMode::open) mode = ContactMode::stick;
  }
  return modes_->set_modes(held);
}

std::optional<SlowMotion> FilmNewton::slow_motion(const BearingState& state, bool stuck) {
  if (!linearise(film_equations(film_, state.speed), state, stuck)) return std::nullopt;
  SlowMotion motion{.stiffness = find_rates()};
  for (const Step& rate : rates_) {
    motion.foil_response =
        std::max(motion.foil_response, film_.scales.thickness * rate.film.deflection.cwiseAbs().maxCoeff());
  }
  return motion;
}

/// Linearises about a state with storage proportional to P H as in a step of implicit Euler, at a rate s = shift / T0,
/// with contacts in its modes, or with all closed ones sticking.
/// @return whether the system is regular
bool FilmNewton::linearise_at(double shift, const BearingState& state, bool stuck) {
  FilmEquations equations = film_equations(film_, state.speed);
  squeeze(film_, shift, film_content(state.film), equations);
  return linearise(equations, state, stuck);
}

Eigen::Index FilmNewton::unknown_pressures() const {
  Eigen::Index unknown = 0;
  for (const Part& part : parts_) unknown += unknown_pressures_of(part.pad.foil.mesh);
  return unknown;
}

/// Change of P H at the nodes of unknown pressure, pad after pad.
Vector FilmNewton::content_of(const FoilFilmState& change, const FilmState& state) const {
  const Matrix content = change.pressure.cwiseProduct(state.thickness) + state.pressure.cwiseProduct(change.thickness);
  Vector inside(unknown_pressures());
  Eigen::Index first = 0;
  for (const Part& part : parts_) {
    const FilmMesh& mesh = part.pad.foil.mesh;
    const Eigen::Index size = unknown_pressures_of(mesh);
    inside.segment(first, size) = mesh.unknown(content, part.pad.first_column).reshaped();
    first += size;
  }
  return inside;
}

/// Change of the foil balances with asperity pressures for a change of H, at the last linearisation.
Matrix FilmNewton::asperity_change(const Part& part, const Matrix& thickness) {
  return asperity_balance(part.pad.foil, part.system.asperity_slopes().cwiseProduct(thickness));
}

/// Adds storage rates of the node volumes to the film residuals.
void FilmNewton::store(std::span<const Vector> rates) {
  set_sides(rates.size());
  Eigen::Index first = 0;
  for (Part& part : parts_) {
    const FilmMesh& mesh = part.pad.foil.mesh;
    const Eigen::Index size = unknown_pressures_of(mesh);
    for (std::size_t side = 0; side < rates.size(); ++side) {
      part.residuals[side].film = storage_residual(mesh, rates[side].segment(first, size));
      set_zero(part.pad.foil, part.residuals[side]);
    }
    first += size;
  }
}

std::optional<FilmImpedance> FilmNewton::impedance(const BearingState& state,
                                                   const std::vector<std::complex<double>>& rates, bool stuck) {
  const double T0 = film_.scales.squeeze_time();
  const ShiftedRates shifted(rates, T0);
  FilmImpedance found{.shift = shifted.shift, .squeeze_time = T0, .along = {}};
  if (!linearise_at(found.shift, state, stuck)) return std::nullopt;
  const auto answer_of = [&](const FoilFilmState& change) {
    return FilmAnswer{content_of(change, state.film), force_of(change)};
  };
  std::vector<Step> changes(rates_.size());
  const auto stored = [&](const std::vector<Vector>& contents) {
    const std::span<Step> of_each = std::span(changes).first(contents.size());
    store(contents);
    answer(of_each);
    std::vector<FilmAnswer> answers;
    answers.reserve(of_each.size());
    for (const Step& change : of_each) answers.push_back(answer_of(change.film));
    return answers;
  };
  find_rates();
  std::vector<FilmAnswer> moved;
  moved.reserve(rates_.size());
  for (const Step& rate : rates_) moved.push_back(answer_of(rate.film));
  auto reduced = reduce_forces(moved, stored, shifted.excess);
  if (!reduced) return std::nullopt;
  found.along = std::move(*reduced);
  return found;
}

/// Square of the norm of the opening of closed contacts and the slip of sticking ones, in units of c.
double FilmNewton::contact_square(const ContactState& change) const {
  double square = 0.0;
  for_each_contact(bearing_.problem, [&](const CoulombContact& contact) {
    const ContactMode mode = change.mode[static_cast<std::size_t>(contact.index)];
    if (mode == ContactMode::open) return;
    const double gap = contact.gap(change.x);
    square += gap * gap;
    if (mode != ContactMode::stick || is_frictionless(contact.site)) return;
    const double slip = change.x[contact.row + contact.site.tangential];
    square += slip * slip;
  });
  return square / (film_.scales.thickness * film_.scales.thickness);
}

/// Square of the norm of the residuals of all linearised equations for a change of all unknowns, in the units of
/// find_residual(), at the last linearisation. Storage in excess of that at the shift is already in the film residuals,
/// see store().
double FilmNewton::equation_square(const Step& change) {
  Vector& forces = find_bump_forces(change.contact);
  forces -= contact_forces(bearing_.problem, change.contact.normal_force, change.contact.friction_force);
  const Eigen::Index size = bump_K_.block_size();
  double square = contact_square(change.contact);
  for (Part& part : parts_) {
    const FilmMesh& mesh = part.pad.foil.mesh;
    const FilmJacobian& jacobian = part.system.film_jacobian();
    FoilFilmResidual& residual = part.residuals.front();
    FoilFilmState& own = part.changes.front();
    read_part(part.pad, change.film, own);
    residual.film += stencil_product(mesh, jacobian.by_pressure, own.pressure) +
                     stencil_product(mesh, jacobian.by_thickness, own.thickness);
    own.pressure.array() += 1.0;  // foils are loaded by P - 1
    foil_residual(part.pad.foil, own, residual);
    residual.balance += asperity_change(part, own.thickness);
    add_supports(part.pad, forces, residual.balance);
    const double unit = part.pad.foil.stiffness * film_.scales.thickness;
    square += film_square(mesh, residual.film) + residual.balance.squaredNorm() + residual.compatibility.squaredNorm() +
              residual.membrane.squaredNorm() +
              forces.segment(part.pad.first_block * size, part.pad.bumps() * size).squaredNorm() / (unit * unit);
  }
  return square;
}

std::optional<HeldMotion> FilmNewton::held_motion(const BearingState& state, bool stuck) {
  const double T0 = film_.scales.squeeze_time();
  const double unit = std::max(std::abs(state.speed) * T0, least_rate);
  const double shift = shift_in_speeds * unit;
  if (!linearise_at(shift, state, stuck)) return std::nullopt;
  Step change;
  const auto stored = [&](const Vector& rates) {
    store({&rates, 1});
    answer({&change, 1});
    return content_of(change.film, state.film);
  };
  const std::optional<FilmPole> pole = rightmost_pole(stored, unknown_pressures(), frequency_in_speeds * unit);
  if (!pole) return std::nullopt;

  // The motion, and its residuals in all equations.
  std::array<Step, 2> motion;  // real and imaginary part
  Eigen::MatrixX2d content(unknown_pressures(), 2);
  store(std::array<Vector, 2>{pole->stored.real(), pole->stored.imag()});
  answer(motion);
  for (const Eigen::Index i : {0, 1}) {
    content.col(i) = content_of(motion[static_cast<std::size_t>(i)].film, state.film);
  }
  const Eigen::Matrix2d times_excess{{pole->excess.real(), pole->excess.imag()},
                                     {-pole->excess.imag(), pole->excess.real()}};
  const Eigen::MatrixX2d more = content * times_excess;
  double square = 0.0;
  double whole = 0.0;
  for (const Eigen::Index i : {0, 1}) {
    const Vector of_part = more.col(i);
    store({&of_part, 1});
    for (const Part& part : parts_) whole += film_square(part.pad.foil.mesh, part.residuals.front().film);
    square += equation_square(motion[static_cast<std::size_t>(i)]);
  }
  HeldMotion found{.rate = (shift + pole->excess) / T0, .residual = std::sqrt(square / whole)};
  if (!(found.residual <= largest_residual)) return std::nullopt;
  (motion[0].film.deflection.cwiseAbs2() + motion[1].film.deflection.cwiseAbs2())
      .colwise()
      .sum()
      .maxCoeff(&found.column);
  return found;
}

bool FilmNewton::find_step(bool keeps_factors, FilmReport& report) {
  if (!keeps_factors) {
    if (!linearise_films(equations_, iterate_)) return false;
    assemble();
    contacts_.set_elasticity(K_);
  }
  if (!find_step_at_rest(report)) return false;
  move_foils();
  return true;
}

/// The step at the journal position of the iterate with exact contacts: unknowns of the contact problem are the steps
/// of the blocks.
bool FilmNewton::find_step_at_rest(FilmReport& report) {
  const BearingState& state = iterate_;
  const Vector& x = state.contacts.x;
  // Contact forces are unknowns of the step, so they are not on its right-hand side.
  loading_.load = -find_bump_forces(state.contacts);
  condense();
  load_condensed(0);
  loading_.initial_gap = contact_gaps(bearing_.problem, bearing_.assembled_gap, x);
  begin_ = state.contacts;
  begin_.x.setZero();
  for_each_contact(bearing_.problem, [&](const CoulombContact& contact) {
    if (contact.site.tangential < 0) return;
    const Eigen::Index place = contact.row + contact.site.tangential;
    begin_.x[place] = state.slip_origin[place] - x[place];
  });
  const SolveReport solved = contacts_.solve(loading_, begin_, step_.contact);
  report.factorisations += solved.cost.factorisations;
  if (!solved.converged()) return false;
  expand({&step_, 1});
  step_.displacement.setZero(film_.motions());
  step_.clearance_offset = 0.0;
  return true;
}

JournalVector FilmNewton::stepped_force() const {
  return force_ + force_of(step_.film);
}

void FilmNewton::move_journal(const JournalVector& displacement) {
  step_.displacement = displacement;
  for (Eigen::Index i = 0; i < displacement.size(); ++i)
    add_to_step(displacement[i], rates_[static_cast<std::size_t>(i)]);
}

/// Moves the foils radially by the change of the clearance, limited to the longest step.
void FilmNewton::move_foils() {
  if (clearance_offset_ == iterate_.clearance_offset) return;
  const double longest = longest_clearance_step * film_.scales.thickness;
  step_.clearance_offset = std::clamp(clearance_offset_ - iterate_.clearance_offset, -longest, longest);
  const Matrix clearance_offset = film_.field(1.0 / film_.scales.thickness);
  find_rates({&clearance_offset, 1}, {&clearance_rate_, 1});
  add_to_step(step_.clearance_offset, clearance_rate_);
}

/// Adds the change of all unknowns for a displacement (m) of the journal or the foils, from their rates per m.
void FilmNewton::add_to_step(double displacement, const Step& rate) {
  step_.film.pressure += displacement * rate.film.pressure;
  step_.film.thickness += displacement * rate.film.thickness;
  step_.film.deflection += displacement * rate.film.deflection;
  step_.film.moment += displacement * rate.film.moment;
  step_.film.membrane += displacement * rate.film.membrane;
  step_.contact.x += displacement * rate.contact.x;
  step_.contact.gap += displacement * rate.contact.gap;
  step_.contact.normal_force += displacement * rate.contact.normal_force;
  step_.contact.friction_force += displacement * rate.contact.friction_force;
}

void FilmNewton::take_step(double fraction, const BearingState& from, BearingState& to) const {
  const FoilFilmState& step = step_.film;
  FilmModel::place_journal(film_.journal_of(from) + fraction * step_.displacement, to);
  to.speed = from.speed;
  to.clearance_offset = from.clearance_offset + fraction * step_.clearance_offset;
  to.film.pressure = from.film.pressure + fraction * step.pressure;
  to.film.thickness = from.film.thickness + fraction * step.thickness;
  to.film.deflection = from.film.deflection + fraction * step.deflection;
  to.film.moment = from.film.moment + fraction * step.moment;
  to.film.membrane = from.film.membrane + fraction * step.membrane;
  to.contacts.x = from.contacts.x + fraction * step_.contact.x;
  const auto mix = [fraction](const Vector& a, const Vector& b) -> Vector { return a + fraction * (b - a); };
  to.contacts.gap = mix(from.contacts.gap, step_.contact.gap);
  to.contacts.normal_force = mix(from.contacts.normal_force, step_.contact.normal_force);
  to.contacts.friction_force = mix(from.contacts.friction_force, step_.contact.friction_force);
  to.contacts.mode = step_.contact.mode;
}

double FilmNewton::distance(const BearingState& a, const BearingState& b) const {
  return std::max({(a.film.pressure - b.film.pressure).cwiseAbs().maxCoeff(),
                   (a.film.deflection - b.film.deflection).cwiseAbs().maxCoeff(),
                   (film_.journal_of(a) - film_.journal_of(b)).norm() / film_.scales.thickness});
}

double FilmNewton::largest_change() const {
  return std::max({step_.film.pressure.cwiseAbs().maxCoeff(), step_.film.deflection.cwiseAbs().maxCoeff(),
                   std::max(step_.displacement.norm(), std::abs(step_.clearance_offset)) / film_.scales.thickness});
}

bool FilmNewton::set_out(const JointMove& to, const BearingState& from, const BearingState& guess) {
  equations_ = film_equations(film_, to.speed);
  clearance_offset_ = to.clearance_offset;
  taken_ = {};
  if (to.dt > 0.0) {
    const bool second_order = to.scheme == TimeScheme::bdf2;
    const BackwardDifference rate = second_order ? bdf2(to.dt, from.last_step.dt) : implicit_euler(to.dt);
    const Matrix content = film_content(from.film);
    squeeze(film_, film_.scales.squeeze_time() / rate.span, rate.reference(content, from.last_step.content),
            equations_);
    if (second_order) taken_ = {to.dt, content};
  }
  iterate_ = guess;
  iterate_.slip_origin = from.slip_origin;
  iterate_.speed = to.speed;
  iterate_.film.thickness = undeformed_thickness(bearing_, film_.journal_of(iterate_), iterate_.clearance_offset);
  iterate_.film.thickness += film_.over_the_width(iterate_.film.deflection);
  trial_ = instead_ = iterate_;
  return iterate_.film.thickness.minCoeff() > 0.0;
}

void FilmNewton::finish(const JournalVector& journal, BearingState& state, FilmReport& report) {
  FilmModel::place_journal(journal, trial_);
  trial_.clearance_offset = clearance_offset_;
  report.predicted_change = std::max(report.predicted_change, distance(predicted_, state));
  report.departure = std::max(report.departure, distance(trial_, predicted_));
  trial_.last_step = std::move(taken_);
  std::swap(state, trial_);
}

}  // namespace bumpfoil
