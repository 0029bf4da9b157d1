#include "bumpfoil/structure/top_foil_on_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/structure/forming.hpp"
#include "bumpfoil/structure/membrane.hpp"
#include "bumpfoil/structure/section.hpp"
#include "bumpfoil/structure/top_foil.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// The film's default. Eight times as many change w_2 at held crests by 0.003 um of 2.8.
constexpr int columns_of_pitch = 6;

/// The foil by columns: equations of each in its own unknowns and, as they are symmetric, in those of the next, and
/// their right-hand sides. Unused unknowns are uncoupled.
struct Columns {
  std::vector<Matrix> own, after;
  std::vector<Vector> load;
};

/// Adds bending, one beam per line. @param rotations  by its forming @param pitch  unit of lengths, m
void add_beams(const TopFoilMoments& form, const Vector& rotations, double bending_stiffness, double pitch,
               const WidthLines& lines, Columns& columns) {
  const auto end = static_cast<std::size_t>(form.size());
  for (Eigen::Index s = 0; s < lines.count(); ++s) {
    const Eigen::Index u = s;
    const Eigen::Index M = lines.count() + s;
    const double flexibility = bending_stiffness / pitch / lines.weight[s];
    for (std::size_t k = 0; k <= end; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      Matrix& own = columns.own[k];
      if (k == 0) own(u, u) = 1.0;
      if (k == end) {
        own(M, M) = -1.0;
        break;
      }
      if (k > 0) own(u, M) = own(M, u) = pitch * form.load_diagonal(i);
      own(M, M) = -flexibility * form.compliance_diagonal[i];
      columns.load[k][M] = pitch * rotations[i];
      Matrix& after = columns.after[k];
      after(M, u) = pitch * form.inverse_sine[i];
      if (k + 1 == end) continue;
      if (k > 0) after(u, M) = pitch * form.inverse_sine[i];
      after(M, M) = -flexibility * form.compliance_off[i];
    }
  }
}

/// Adds the membrane. Its rows are symmetric in F and m = A g + nu B F.
void add_membrane(const Membrane& membrane, const Vector& intervals, const WidthLines& lines, Columns& columns) {
  const Eigen::Index modes = membrane.modes();
  if (modes == 0) return;
  const auto u = Eigen::seqN(0, lines.count());
  const auto F = Eigen::seqN(2 * lines.count(), modes);
  const auto m = Eigen::seqN(2 * lines.count() + modes, modes);
  const Matrix per_bow = solve(membrane.by_bow, Matrix(Matrix::Identity(modes, modes)));
  const Matrix of_load = membrane.poisson_ratio * product(per_bow, membrane.by_slope);  // g = per_bow m - of_load F
  const auto load = Eigen::seqN(0, modes);
  const auto bow = Eigen::seqN(modes, modes);
  const auto put = [&](const Matrix& rows, Matrix& to) {
    to(F, F) -= rows(load, load) - product(rows(load, bow), of_load);
    to(F, m) -= product(rows(load, bow), per_bow);
    to(m, F) += rows(bow, load) - product(rows(bow, bow), of_load);
    to(m, m) += product(rows(bow, bow), per_bow);
  };
  const Matrix stretching = lines.to_stretching_modes();
  const std::vector<MembraneRows> rows = membrane_rows(membrane, intervals);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    put(rows[k].own, columns.own[k]);
    if (k + 1 < rows.size()) put(rows[k].after, columns.after[k]);
    if (k == 0) {
      columns.own[k](F, m).setZero();  // m = 0 at the weld
      columns.own[k](m, F).setZero();
      continue;
    }
    columns.own[k](F, u) += rows[k].length * stretching;
    columns.own[k](u, F) += rows[k].length * stretching.transpose();
  }
  columns.own.back()(F, F) = -Matrix::Identity(modes, modes);
  columns.own.back()(m, m) = -Matrix::Identity(modes, modes);
}

/// Symmetric equations A x = load.
struct Equations {
  Matrix A;
  Vector load;
  double energy{};  ///< of eliminated unknowns, at x = 0
};

/// Consecutive columns with their couplings, and the equations of all but the first; also of the first if it is the
/// weld.
Equations joined(const Columns& columns, int first, int last) {
  const Eigen::Index size = columns.own.front().rows();
  const Eigen::Index all = size * (last - first + 1);
  Equations joint{.A = Matrix::Zero(all, all), .load = Vector::Zero(all)};
  for (int k = first; k <= last; ++k) {
    const Eigen::Index at = size * (k - first);
    if (k == 0 || k > first) {
      joint.A.block(at, at, size, size) = columns.own[static_cast<std::size_t>(k)];
      joint.load.segment(at, size) = columns.load[static_cast<std::size_t>(k)];
    }
    if (k == last) continue;
    const Matrix& after = columns.after[static_cast<std::size_t>(k)];
    joint.A.block(at, at + size, size, size) = after;
    joint.A.block(at + size, at, size, size) = after.transpose();
  }
  return joint;
}

/// The equations with some unknowns eliminated.
Equations condensed(const Equations& all, const std::vector<Eigen::Index>& kept) {
  std::vector<Eigen::Index> other;
  for (Eigen::Index i = 0; i < all.A.rows(); ++i) {
    if (!std::binary_search(kept.begin(), kept.end(), i)) other.push_back(i);
  }
  const Matrix across = all.A(other, kept);
  const Vector load = all.load(other);
  Matrix right(load.size(), across.cols() + 1);
  right << across, load;
  const Matrix solved = solve(all.A(other, other), right);
  const Vector answer = solved.rightCols<1>();
  return {.A = all.A(kept, kept) - transposed_product(across, solved.leftCols(across.cols())),
          .load = all.load(kept) - across.transpose() * answer,
          .energy = -0.5 * load.dot(answer)};
}

}  // namespace

Vector top_foil_intervals(const FoilDesign& foils, int columns_per_pitch, double pitch) {
  const int half = columns_per_pitch / 2;
  const double last = foils.bumps.back().pitch;
  const double overhang = foils.top_foil->overhang / (0.5 * last);
  const int beyond = std::max(2, static_cast<int>(std::lround(half * overhang)));
  const auto further = std::lround(columns_per_pitch * foils.top_foil->stagger / last);
  const auto bumps = static_cast<Eigen::Index>(foils.bumps.size());
  Vector intervals((2 * bumps - 1) * half + further + beyond);
  for (Eigen::Index i = 0; i < bumps; ++i) {
    const Eigen::Index count = i + 1 < bumps ? Eigen::Index{2} * half : half + further;
    intervals.segment(2 * i * half, count).setConstant(foils.bumps[static_cast<std::size_t>(i)].pitch / pitch);
  }
  intervals.tail(beyond).setConstant(overhang * half / beyond * last / pitch);
  return intervals;
}

TopFoilOnLines top_foil_on_lines(const FoilDesign& foils, const WidthLines& lines, const std::vector<int>& stations) {
  const double pitch = foils.reference_length();
  const double R = foils.radius.value();
  const double EI = make_top_foil_section(foils).bending_stiffness;
  const double stiffness = EI / (pitch * pitch * pitch);
  const Vector intervals = top_foil_intervals(foils, columns_of_pitch, pitch) / columns_of_pitch;
  TopFoilBeam beam{.radius = R, .bending_stiffness = EI, .theta = intervals * pitch / R};
  std::partial_sum(beam.theta.begin(), beam.theta.end(), beam.theta.begin());
  const Membrane membrane = make_membrane(lines.stretching_orders(), 0.5 * foils.axial_length / pitch, R / pitch,
                                          foils.top_foil->youngs_modulus * foils.top_foil->thickness / stiffness,
                                          foils.top_foil->poisson_ratio);
  const Eigen::Index size = 2 * (lines.count() + membrane.modes());
  const auto count = static_cast<std::size_t>(intervals.size());
  Columns columns{.own = std::vector<Matrix>(count + 1, Matrix::Zero(size, size)),
                  .after = std::vector<Matrix>(count, Matrix::Zero(size, size)),
                  .load = std::vector<Vector>(count + 1, Vector::Zero(size))};
  add_beams(make_top_foil_moments(beam), forming_rotations(beam, make_forming(foils)), EI, pitch, lines, columns);
  add_membrane(membrane, intervals, lines, columns);

  const auto bumps = static_cast<int>(foils.bumps.size());
  const auto of_block = static_cast<int>(stations.size());
  const auto is_moment = [&](Eigen::Index i) { return i >= lines.count() && i < 2 * lines.count(); };
  BlockTridiagonal K(bumps, of_block * static_cast<int>(size));
  Vector forming = Vector::Zero(K.rows());
  double forming_energy = 0.0;
  std::vector<Eigen::Index> all(static_cast<std::size_t>(size));
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  const int held = bumps * of_block;  // column of a crest
  int before = 0;                     // the previous crest, or the weld
  for (int k = 0; k < held; ++k) {
    const bool last = k + 1 == held;
    const int column =
        columns_of_pitch / 2 + columns_of_pitch * (k / of_block) + stations[static_cast<std::size_t>(k % of_block)];
    std::vector<Eigen::Index> kept;
    if (k > 0) kept = all;
    std::vector<Eigen::Index> own;  // unknowns of this column
    for (const Eigen::Index i : all) {
      if (last && is_moment(i)) continue;
      own.push_back(i);
      kept.push_back(size * (column - before) + i);
    }
    const Equations part = condensed(joined(columns, before, last ? static_cast<int>(count) : column), kept);
    const Matrix A = stiffness * part.A;
    const Vector load = stiffness * part.load;
    forming_energy += stiffness * part.energy;
    const auto n = std::ssize(own);
    const auto place = [&](int of) { return size * (of % of_block); };  // index in its block
    for (Eigen::Index& i : own) i += place(k);
    const auto block = static_cast<std::size_t>(k / of_block);
    K.diagonal[block](own, own) += A.bottomRightCorner(n, n);
    forming.segment(Eigen::Index{K.block_size()} * (k / of_block), K.block_size())(own) += load.tail(n);
    before = column;
    if (k == 0) continue;
    const auto first = Eigen::seqN(place(k - 1), size);
    const auto other = static_cast<std::size_t>((k - 1) / of_block);
    K.diagonal[other](first, first) += A.topLeftCorner(size, size);
    forming.segment(Eigen::Index{K.block_size()} * ((k - 1) / of_block), K.block_size())(first) += load.head(size);
    if (other == block) {
      K.diagonal[block](first, own) += A.topRightCorner(size, n);
      K.diagonal[block](own, first) += A.topRightCorner(size, n).transpose();
    } else {
      K.upper[other](first, own) = A.topRightCorner(size, n);
    }
  }
  K.diagonal.back().diagonal().segment(K.block_size() - size + lines.count(), lines.count()).setConstant(-stiffness);
  return {.K = std::move(K), .forming = std::move(forming), .forming_energy = forming_energy};
}

}  // namespace bumpfoil
