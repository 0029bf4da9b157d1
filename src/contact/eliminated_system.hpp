#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <vector>

#include "bumpfoil/contact/coulomb_contact.hpp"
#include "bumpfoil/contact/problem.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/core/block_tridiagonal_lu.hpp"
#include "bumpfoil/core/dense_kernels.hpp"
#include "core/block_product.hpp"

namespace bumpfoil {

/// How the normal force of a contact is found from the balance of its block.
struct Elimination {
  std::size_t site{};   ///< of the problem
  int owner{};          ///< unknown whose balance determines the normal force
  double owner_sign{};  ///< of the normal force on the owner
  int other{-1};        ///< the other unknown on which the normal force acts, if any
};

/// Appends an elimination order of the contacts of a block: no later contact acts on an owner.
/// @param first, last  sites of the block
inline void add_elimination_order(const std::vector<ContactSite>& sites, std::size_t first, std::size_t last,
                                  std::vector<Elimination>& order) {
  std::vector<bool> done(last - first, false);
  const auto touched_by_others = [&](int unknown, std::size_t self) {
    for (std::size_t c = first; c < last; ++c) {
      const ContactSite& site = sites[c];
      if (c == self || (done[c - first] && site.tangential != unknown)) continue;
      if (site.plus == unknown || site.minus == unknown || site.tangential == unknown) return true;
    }
    return false;
  };
  while (order.size() < last) {
    const std::size_t before = order.size();
    for (std::size_t c = first; c < last; ++c) {
      if (done[c - first]) continue;
      const ContactSite& site = sites[c];
      if (site.plus >= 0 && !touched_by_others(site.plus, c)) {
        order.push_back({c, site.plus, 1.0, site.minus});
      } else if (site.minus >= 0 && !touched_by_others(site.minus, c)) {
        order.push_back({c, site.minus, -1.0, site.plus});
      } else {
        continue;
      }
      done[c - first] = true;
    }
    BUMPFOIL_ASSERT(order.size() > before);  // contacts that form a ring cannot be eliminated one by one
    if (order.size() == before) break;
  }
}

/// Elimination order of all blocks, in sequence; each has one entry per site.
inline std::vector<Elimination> elimination_order(const ContactProblem& problem) {
  const std::vector<std::size_t> first = first_sites(problem);
  std::vector<Elimination> order;
  order.reserve(problem.sites.size());
  for (std::size_t b = 0; b + 1 < first.size(); ++b) {
    add_elimination_order(problem.sites, first[b], first[b + 1], order);
  }
  return order;
}

/// SiteCoordinates of a contact, in the order of contacts: normal, then tangential if there is friction; -1: none.
struct SiteCoordinates {
  Eigen::Index normal, tangential;
};

inline std::vector<SiteCoordinates> coordinates_of(const std::vector<ContactSite>& sites) {
  std::vector<SiteCoordinates> coordinates;
  coordinates.reserve(sites.size());
  Eigen::Index next = 0;
  for (const ContactSite& site : sites) {
    const Eigen::Index normal = next++;
    coordinates.push_back({normal, is_frictionless(site) ? -1 : next++});
  }
  return coordinates;
}

inline Eigen::Index coordinate_count(const std::vector<ContactSite>& sites) {
  return std::ssize(sites) +
         std::count_if(sites.begin(), sites.end(), [](const ContactSite& site) { return !is_frictionless(site); });
}

/// The size that code for blocks of B rows is compiled for: small blocks gain by a fixed size, larger ones share the
/// dynamic code.
template <int B>
inline constexpr int shared_size = has_wide_rows<B> ? Eigen::Dynamic : B;

/// K in blocks.
/// @tparam B  rows of a block, or Eigen::Dynamic
template <int B>
struct Stiffness {
  using Block = Eigen::Matrix<double, B, B>;
  /// Of one block: three blocks side by side.
  using Rows = Eigen::Matrix<double, B, B == Eigen::Dynamic ? Eigen::Dynamic : 3 * B>;

  explicit Stiffness(const BlockTridiagonal& K) : block_size(K.block_size()) { assign(K); }

  void assign(const BlockTridiagonal& K) {
    BUMPFOIL_ASSERT(K.block_size() == block_size);
    diagonal.assign(K.diagonal.begin(), K.diagonal.end());
    upper.assign(K.upper.begin(), K.upper.end());
    lower.assign(K.lower.begin(), K.lower.end());
  }

  /// Blocks (b, b-1), (b, b), (b, b+1) side by side; zero beyond the ends of the matrix.
  void copy_rows(std::size_t b, Rows& rows) const {
    BUMPFOIL_ASSERT(rows.rows() == block_size && rows.cols() == 3 * Eigen::Index{block_size});
    const Eigen::Index entries = Eigen::Index{block_size} * block_size;
    double* to = rows.data();
    if (b == 0) {
      std::fill_n(to, entries, 0.0);
    } else if (lower.empty()) {
      Eigen::Map<Block>(to, block_size, block_size) = upper[b - 1].transpose();
    } else {
      std::copy_n(lower[b - 1].data(), entries, to);
    }
    std::copy_n(diagonal[b].data(), entries, to + entries);
    if (b + 1 < diagonal.size()) {
      std::copy_n(upper[b].data(), entries, to + 2 * entries);
    } else {
      std::fill_n(to + 2 * entries, entries, 0.0);
    }
  }

  void multiply(const Vector& x, Vector& y) const { multiply_blocks<B>(*this, block_size, x, y); }

  /// Y <- K X - Y for many columns.
  void multiply_panel(const RowMajorMatrix& X, RowMajorMatrix& Y) const {
    const Eigen::Index columns = X.cols();
    const Eigen::Index n = block_size;
    const auto rows_of = [&](std::size_t b) { return static_cast<Eigen::Index>(b) * n * columns; };
    for (std::size_t b = 0; b < diagonal.size(); ++b) {
      for (Eigen::Index r = 0; r < n; ++r) {
        double* row = Y.data() + rows_of(b) + r * columns;
        for (Eigen::Index c = 0; c < columns; ++c) row[c] = -row[c];
        // Rows of blocks, which are stored by columns; those below the diagonal may be columns of the ones above.
        const auto add = [&](const double* factors, Eigen::Index step, std::size_t other) {
          add_rows(1.0, factors, step, n, X.data() + rows_of(other), columns, row);
        };
        add(diagonal[b].data() + r, n, b);
        if (b + 1 < diagonal.size()) add(upper[b].data() + r, n, b + 1);
        if (b > 0 && lower.empty()) add(upper[b - 1].data() + r * n, 1, b - 1);
        if (b > 0 && !lower.empty()) add(lower[b - 1].data() + r, n, b - 1);
      }
    }
  }

  /// The block below the diagonal, in row b + 1.
  [[nodiscard]] Block lower_block(std::size_t b) const {
    return lower.empty() ? Block(upper[b].transpose()) : lower[b];
  }

  int block_size;
  std::vector<Block> diagonal, upper;
  std::vector<Block> lower;  ///< empty where K is symmetric
};

/// Base of systems that eliminate normal forces inside the blocks.
template <int B>
class EliminatedSystem {
 protected:
  explicit EliminatedSystem(const ContactProblem& problem)
      : sites_(problem.sites),
        first_(first_sites(problem)),
        order_(elimination_order(problem)),
        K_(problem.K),
        lu_(problem.K.blocks(), problem.K.block_size()),
        rhs_(problem.K.rows()),
        imbalance_(problem.K.rows()),
        rows_(problem.K.block_size(), 3 * problem.K.block_size()) {}

  void assign_elasticity(const BlockTridiagonal& K) {
    BUMPFOIL_ASSERT(K.blocks() == lu_.blocks());
    K_.assign(K);
  }

  /// Calls visit(elimination, site, first row of the block) in the order of elimination.
  template <typename Visitor>
  void for_each_elimination(Visitor&& visit) const {
    for (const Elimination& e : order_) {
      const ContactSite& site = sites_[e.site];
      visit(e, site, static_cast<Eigen::Index>(site.block) * K_.block_size);
    }
  }

  /// Eliminations of one block.
  [[nodiscard]] std::span<const Elimination> eliminations(std::size_t block) const {
    return std::span(order_).subspan(first_[block], first_[block + 1] - first_[block]);
  }

  /// Determines a normal force from the balance of its owner and subtracts it from that of the other unknown.
  static double carry_normal_force(const Elimination& e, Eigen::Index row, Vector& balance) {
    const double p = e.owner_sign * balance[row + e.owner];
    if (e.other >= 0) balance[row + e.other] += e.owner_sign * p;
    return p;
  }

  /// Copies a block that is stored by columns to one that is stored by rows.
  static void store_transposed(const double* columns, Eigen::Index n, double* rows) {
    for (Eigen::Index r = 0; r < n; ++r) {
      for (Eigen::Index c = 0; c < n; ++c) rows[r * n + c] = columns[c * n + r];
    }
  }

  /// Stores rows_ as those of block b.
  void store_rows(std::size_t b) {
    const Eigen::Index n = B == Eigen::Dynamic ? K_.block_size : B;
    const int i = static_cast<int>(b);
    store_transposed(rows_.data(), n, lu_.lower(i).data());
    store_transposed(rows_.data() + n * n, n, lu_.diagonal(i).data());
    store_transposed(rows_.data() + 2 * n * n, n, lu_.upper(i).data());
  }

  std::vector<ContactSite> sites_;
  std::vector<std::size_t> first_;  ///< of each block
  std::vector<Elimination> order_;
  Stiffness<shared_size<B>> K_;
  BlockTridiagonalLU<B> lu_;
  Vector rhs_, imbalance_;
  typename Stiffness<shared_size<B>>::Rows rows_;
};

/// Fixed-size code for the block sizes of the foil models; other sizes use slower generic code.
template <template <int> class System, typename Interface>
std::unique_ptr<Interface> make_for_block_size(const ContactProblem& problem) {
  switch (problem.K.block_size()) {
    case 6:
      return std::make_unique<System<6>>(problem);
    case 11:
      return std::make_unique<System<11>>(problem);
    case 14:  // truss under a film of eight rows
      return std::make_unique<System<14>>(problem);
    case 22:  // of sixteen
      return std::make_unique<System<22>>(problem);
    case 28:  // with a parabola over the width
      return std::make_unique<System<28>>(problem);
    default:
      return std::make_unique<System<Eigen::Dynamic>>(problem);
  }
}

}  // namespace bumpfoil
