#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "bumpfoil/core/block_tridiagonal.hpp"

namespace bumpfoil {

/// State of one contact. With gap g, normal force p, friction force t on the node, slip du since the last converged
/// increment and friction coefficient f:
enum class ContactMode : std::uint8_t {
  open,           ///< g > 0,  p = 0,  t = 0
  stick,          ///< g = 0,  p >= 0, du = 0, |t| <= f p
  slip_forward,   ///< g = 0,  p >= 0, du > 0, t = -f p
  slip_backward,  ///< g = 0,  p >= 0, du < 0, t = +f p
};

/// One contact. Its unknowns are given by their places in its block; -1 is none.
///
///     g = g0 + x[plus] - x[minus] >= 0
///
/// A compression p >= 0 acts as +p on `plus` and -p on `minus`; friction t acts on `tangential`. A contact without a
/// `tangential` unknown is frictionless, and its closed mode is `stick`.
struct ContactSite {
  int block{};
  int plus{-1};
  int minus{-1};
  int tangential{-1};
  double friction_coefficient{};

  bool operator==(const ContactSite&) const = default;
};

/// The same contacts in each of some blocks. @param pattern  those of a block
std::vector<ContactSite> in_every_block(const std::vector<ContactSite>& pattern, int blocks);

/// Elastic forces that are not linear in the unknowns.
struct ElasticLaw {
  std::function<Vector(const Vector& x)> forces;             ///< e(x), N
  std::function<BlockTridiagonal(const Vector& x)> tangent;  ///< their derivative, N/m, of the form of K
  /// Replaces the tangent where that gives no solution: positive semidefinite on the displacements. It affects
  /// convergence, not the result.
  std::function<BlockTridiagonal(const Vector& x)> stable_tangent;
};

/// Quasi-static contact problem with Coulomb friction: given the state x0 at the last increment and the initial gaps
/// g0, find x, p, t such that
///
///     K x = load + sum of contact forces,   0 <= g _|_ p >= 0,   |t| <= f p,   t = -f p sign(du) where du != 0
///
/// with du = x[tangential] - x0[tangential] [Arghir2019, Eqs. 10, 16]. All displacements in m, forces in N. K may have
/// unknowns that are not displacements (moments of a mixed form); no contact acts on them. With a law, its e(x) takes
/// the place of K x, and K is its tangent at x = 0; the normals and the tangential directions of the contacts stay.
struct ContactProblem {
  BlockTridiagonal K;
  /// At least one, block after block; blocks may differ in theirs. Contact c is `sites[c]` in every contact array.
  std::vector<ContactSite> sites;
  std::optional<ElasticLaw> law{};  ///< absent where elastic forces are linear
  double force_scale{10.0};         ///< scale of the forces of the problem, N: below 1e-12 of it counts as zero

  [[nodiscard]] int contacts() const { return static_cast<int>(sites.size()); }

  /// The force that tolerances relative to the largest refer to where the largest is less, N: without loads they would
  /// be relative to round-off. 1 N as in ContactResiduals, less for problems with a force scale below 10 N.
  [[nodiscard]] double least_reference_force() const { return std::min(1.0, 0.1 * force_scale); }
};

/// Where the sites of each block begin among those of a problem, and at last their number.
std::vector<std::size_t> first_sites(const ContactProblem& problem);

/// Whether two problems are the same to the last bit. With elastic laws they never are: these cannot be compared.
bool is_same(const ContactProblem& a, const ContactProblem& b);

/// A contact problem shared by several solvers: created once, immutable, and alive as long as one of them is.
class SharedProblem {
 public:
  /// Shares a copy of `problem`.
  SharedProblem(const ContactProblem& problem) : problem_(std::make_shared<const ContactProblem>(problem)) {}
  /// Shares an existing problem.
  explicit SharedProblem(std::shared_ptr<const ContactProblem> problem) : problem_(std::move(problem)) {}

  const ContactProblem& operator*() const { return *problem_; }
  const ContactProblem* operator->() const { return problem_.get(); }

 private:
  std::shared_ptr<const ContactProblem> problem_;
};

/// What drives the problem at one increment. A plain value; between two increments it may be interpolated.
struct ContactLoading {
  Vector initial_gap;  ///< g0 of each contact, m
  Vector load;         ///< loads on the unknowns, N

  /// All contacts just touching, no load.
  static ContactLoading none(const ContactProblem& problem);
};

/// State of the foils at one increment: a plain copyable value with all that a warm start and the friction history
/// need.
struct ContactState {
  Vector x;                       ///< unknowns of K
  Vector gap;                     ///< g of each contact, m
  Vector normal_force;            ///< p >= 0 of each contact, N
  Vector friction_force;          ///< t of each contact on its node, N
  std::vector<ContactMode> mode;  ///< of each contact

  /// Unstressed foils before assembly: nothing displaced, all contacts just touching without force.
  static ContactState unstressed(const ContactProblem& problem);

  [[nodiscard]] bool any_slips() const;
};

/// Gaps g = g0 + x[plus] - x[minus] of all contacts, m.
Vector contact_gaps(const ContactProblem& problem, const Vector& initial_gap, const Vector& x);

/// Forces of the contacts on the unknowns, N; rows() entries.
Vector contact_forces(const ContactProblem& problem, const Vector& normal_force, const Vector& friction_force);

/// x[tangential] of all contacts, m; zero for frictionless ones.
Vector tangential_displacements(const ContactProblem& problem, const Vector& x);

}  // namespace bumpfoil
