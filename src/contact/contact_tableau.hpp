#pragma once

#include <memory>
#include <vector>

#include "bumpfoil/contact/mode_system.hpp"
#include "bumpfoil/contact/path_follower.hpp"
#include "bumpfoil/core/dense_kernels.hpp"
#include "contact/straight_piece.hpp"

namespace bumpfoil {

/// The mutual compliance of the contacts of a problem, as one dense matrix. A contact that changes its mode costs one
/// rank-one exchange in it, and the rates along a path are read from it without a solve: for short foils much cheaper
/// than a factorisation and a solve.
///
/// A contact has a normal coordinate and, with friction, a tangential one: a force (p, t) and a displacement (the gap
/// g, x[tangential]). In each mode one of the two is given, z, and the other, w, follows from all that are given:
///
///     w = T z + w' path,   open: z = (p, t),   sticking: z = (g, x_t),   slipping: z = (g, t - s f p), s = -+1
///
/// A contact that opens, closes, begins or ceases to slip exchanges its w_i and z_i: a principal pivot [Cottle1992],
///
///     T <- T - (u + a e_i) (v - a e_i)^T / T_ii,   column u, row v, a = |T_ii|,
///
/// after which w_i is in units of 1 / a and z_i of a: in this form no digits cancel. Several are carried out at once.
class ContactTableau {
 public:
  /// Whether rates are cheaper here than with solves: for short foils, on a processor with wide vectors.
  [[nodiscard]] static bool pays(const ContactProblem& problem);

  /// @param problem  with linear elastic forces; outlives the tableau
  /// @param modes    its linear system
  ContactTableau(const ContactProblem& problem, std::shared_ptr<ModeSystem> modes);
  ContactTableau(const ContactTableau&) = delete;
  ContactTableau& operator=(const ContactTableau&) = delete;

  /// Forgets all modes: subsequent results are bit-identical to those after construction.
  void forget() { valid_ = false; }

  /// Sets the path to which subsequent rates refer.
  void set_path(const LoadingPath& path);

  /// Sets the modes.
  /// @return false if they leave a mechanism; then it must be called again before the next rates()
  [[nodiscard]] bool set_modes(const std::vector<ContactMode>& mode);

  /// Rates along the path in the current modes.
  [[nodiscard]] const ContactRates& rates();

 private:
  /// Rows of whole vectors that never straddle two cache lines.
  using LineMatrix = Eigen::Map<RowMajorMatrix, Eigen::Aligned64>;

  /// Position of a contact among the unknowns and the coordinates; -1: none.
  struct Place {
    Eigen::Index plus, minus, tangential;
    double f;
    Eigen::Index z_normal, z_tangential;
  };

  bool restart(const std::vector<ContactMode>& mode);
  bool find_rates();
  bool change(std::size_t contact, ContactMode to);
  bool exchange(Eigen::Index i);
  void add_row(Eigen::Index to, Eigen::Index from, double factor);
  void add_column(Eigen::Index to, Eigen::Index from, double factor);
  void carry_out();

  const ContactProblem& problem_;
  std::shared_ptr<ModeSystem> modes_;
  std::vector<Place> places_;  ///< of all contacts
  Eigen::Index coordinates_;
  Eigen::Index size_;  ///< of rows and columns, padded to whole vectors

  std::vector<ContactMode> mode_;
  std::vector<std::size_t> changed_;  ///< contacts changed by the last call
  bool valid_{};                      ///< whether the matrix belongs to mode_
  bool has_rates_{};                  ///< whether the rates do
  int exchanges_{};                   ///< since the last comparison with the rates of the linear system
  LineVector numbers_;                ///< of the three matrices below
  LineMatrix T_;                      ///< scaled: T_ij = s_i s_j times this
  Vector scale_;                      ///< s
  Vector rate_;                       ///< w' of the whole path, not scaled
  Eigen::Index pending_{};            ///< exchanges not yet applied: T - left^T right
  LineMatrix left_, right_;
  RowMajorMatrix unit_x_, unit_force_;
  ContactLoading path_rate_;
  ContactRates rates_;
  ContactState answer_;
};

}  // namespace bumpfoil
