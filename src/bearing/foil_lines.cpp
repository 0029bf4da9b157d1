#include "bearing/foil_lines.hpp"

#include <algorithm>
#include <numeric>

#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/held_crests.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Stiffness of springs against higher modes that displace nothing, over the stiffest of the bump foils: a sheet that
/// is held is treated as rigid in shear and stretch in its own surface.
constexpr double rigidity_of_sheet = 1e2;

bool is_of_top_foil(const BumpDofs& dofs, int place) {
  return place == dofs.top_u || place == dofs.top_moment;
}

/// Adds a block of K of one mode to that of the lines.
/// @param alike  product of the mode's values on two lines, which multiplies the block that couples them
template <typename Alike>
void add_block(const BearingModel& foils, const Matrix& block, const Alike& alike, Matrix& sum) {
  const BumpDofs& dofs = foils.structure.dofs;
  for (int s = 0; s < foils.crest_contacts(); ++s) {
    for (int r = 0; r < foils.crest_contacts(); ++r) {
      const double part = alike(s, r);
      for (int i = 0; i < dofs.size; ++i) {
        if (is_of_top_foil(dofs, i)) continue;
        for (int j = 0; j < dofs.size; ++j) {
          if (is_of_top_foil(dofs, j)) continue;
          sum(foils.place(s, i), foils.place(r, j)) += part * block(i, j);
        }
      }
    }
  }
}

/// Adds the sheets of the bump foils, which couple their slices in the modes that stretch them.
void add_sheets(const BearingModel& foils, const WidthLines& width, BlockTridiagonal& K) {
  const BumpDofs& dofs = foils.structure.dofs;
  const Matrix to_modes = width.to_stretching_modes();
  const Eigen::Index of_slices = to_modes.rows() * dofs.size;
  const Eigen::Index of_sheet = to_modes.rows() * sheet_nodes(dofs);
  // Maps the unknowns of a block to those of a sheet.
  Matrix known = Matrix::Zero(of_slices + of_sheet, K.block_size());
  known.block(of_slices, unknowns_on_lines(foils), of_sheet, of_sheet).setIdentity();
  for (Eigen::Index mode = 0; mode < to_modes.rows(); ++mode) {
    for (Eigen::Index s = 0; s < width.count(); ++s) {
      for (int i = 0; i < dofs.size; ++i) {
        if (!is_of_top_foil(dofs, i)) known(mode * dofs.size + i, foils.place(s, i)) = to_modes(mode, s);
      }
    }
  }
  for (int pad = 0; pad < foils.pad_count(); ++pad) {
    const FoilDesign design = make_bearing_design(foils.placed[static_cast<std::size_t>(pad)].alone);
    const BlockTridiagonal sheet = bump_sheet_stiffness(design, width.stretching_orders());
    const auto first = static_cast<std::size_t>(foils.block(foils.structure.blocks_of(pad).first));
    for (std::size_t b = 0; b < sheet.diagonal.size(); ++b) {
      K.diagonal[first + b] += congruent(sheet.diagonal[b], known);
      if (b < sheet.upper.size()) K.upper[first + b] += congruent(sheet.upper[b], known);
    }
  }
}

}  // namespace

std::vector<FoilLine> foil_lines_of(const WidthLines& lines, SheetModel sheet, const BumpDofs& dofs, int further) {
  std::vector<FoilLine> placed(static_cast<std::size_t>(lines.count()));
  const bool all_vary = lines.orders.size() > 1 && (lines.orders[1] == 1 || sheet == SheetModel::elastic);
  const auto varies = [&](int i) {
    return all_vary || is_of_top_foil(dofs, i) || i == dofs.crest_u || i == dofs.crest_v;
  };
  for (std::size_t s = 0; s < placed.size(); ++s) {
    placed[s].zeta = lines.zeta[static_cast<Eigen::Index>(s)];
    placed[s].weight = lines.weight[static_cast<Eigen::Index>(s)];
    placed[s].places.resize(static_cast<std::size_t>(dofs.size));
    std::iota(placed[s].places.begin(), placed[s].places.end(), 0);
    if (s == 0) continue;
    for (int i = 0; i < dofs.size; ++i) {
      if (varies(i)) placed[s].places[static_cast<std::size_t>(i)] = further++;
    }
  }
  return placed;
}

int unknowns_on_lines(const BearingModel& foils) {
  int largest = 0;
  for (const std::vector<FoilLine>* all : {&foils.lines, &foils.points}) {
    for (const FoilLine& line : *all) {
      largest = std::max(largest, *std::max_element(line.places.begin(), line.places.end()));
    }
  }
  return largest + 1;
}

int unknowns_of_sheet(const BearingModel& foils, const WidthLines& width) {
  if (foils.sheet == SheetModel::held) return 0;
  return static_cast<int>(width.stretching_orders().size()) * sheet_nodes(foils.structure.dofs);
}

double stiffest_of_bump_foils(const FoilStructure& structure) {
  double largest = 0.0;
  for (Matrix block : structure.K.diagonal) {
    for (const int place : {structure.dofs.top_u, structure.dofs.top_moment}) {
      block.row(place).setZero();
      block.col(place).setZero();
    }
    largest = std::max(largest, block.maxCoeff());
  }
  return largest;
}

void add_bump_foils(const BearingModel& foils, const WidthLines& width, BlockTridiagonal& K) {
  const FoilStructure& structure = foils.structure;
  const BumpDofs& dofs = structure.dofs;
  const double largest = stiffest_of_bump_foils(structure);
  for (Eigen::Index mode = 0; mode < width.count(); ++mode) {
    const int order = width.orders[static_cast<std::size_t>(mode)];
    const bool is_held = order >= 2 && foils.sheet == SheetModel::held;
    const double square = 1.0 / (2 * order + 1);  // of P_k over the width
    const auto alike = [&](Eigen::Index s, Eigen::Index r) {
      return square * width.to_modes(mode, s) * width.to_modes(mode, r);
    };
    Matrix rigid = Matrix::Zero(dofs.size, dofs.size);
    for (int i = 0; i < dofs.size; ++i) {
      if (i != dofs.crest_v && !foils.is_uniform(i)) rigid(i, i) = rigidity_of_sheet * largest;
    }
    for (int pad = 0; pad < foils.pad_count(); ++pad) {
      const PadBlocks blocks = structure.blocks_of(pad);
      const Matrix held = is_held ? held_crest_stiffness(structure, pad) : Matrix();
      for (int b = 0; b < blocks.count; ++b) {
        const auto from = static_cast<std::size_t>(blocks.first) + static_cast<std::size_t>(b);
        const auto to = static_cast<std::size_t>(foils.block(blocks.first + b));
        const bool last = b + 1 == blocks.count;
        if (!is_held) {
          add_block(foils, structure.K.diagonal[from], alike, K.diagonal[to]);
          if (!last) add_block(foils, structure.K.upper[from], alike, K.upper[to]);
          continue;
        }
        rigid(dofs.crest_v, dofs.crest_v) = held(b, b);
        add_block(foils, rigid, alike, K.diagonal[to]);
        if (last) continue;
        Matrix next = Matrix::Zero(dofs.size, dofs.size);
        next(dofs.crest_v, dofs.crest_v) = held(b, b + 1);
        add_block(foils, next, alike, K.upper[to]);
      }
    }
  }
  if (foils.sheet == SheetModel::elastic) add_sheets(foils, width, K);
}

void put_contacts_on_lines(std::span<const BearingModel> strips, double elsewhere, BearingModel& on_lines) {
  const BearingModel& foils = strips.front();
  // Source of each contact in a block of the others: the first of those in a block of the strip.
  struct Source {
    int contact, strip;
  };
  std::vector<Source> like;
  std::vector<ContactSite> pattern;
  const auto add = [&](int first, const std::vector<FoilLine>& lines, int count) {
    for (int s = 0; s < count; ++s) {
      like.push_back({first, lines[static_cast<std::size_t>(s)].strip});
      ContactSite& site = pattern.emplace_back(foils.problem.sites[static_cast<std::size_t>(first)]);
      for (int* place : {&site.plus, &site.minus, &site.tangential}) {
        if (*place >= 0) *place = BearingModel::place(lines, s, *place);
      }
    }
  };
  if (on_lines.top_bump() > 0) add(0, on_lines.lines, on_lines.journal_contacts());
  add(foils.top_bump(), on_lines.crest_lines(), on_lines.crest_contacts());
  for (int foot = 0; foot < foils.feet_per_block(); ++foot) {
    add(foils.first_foot() + foot * foils.foot_contacts(), on_lines.crest_lines(), on_lines.foot_contacts());
  }
  on_lines.problem.sites = in_every_block(pattern, on_lines.problem.K.blocks());
  on_lines.assembled_gap.setConstant(on_lines.problem.contacts(), elsewhere);
  for (int b = 0; b < foils.structure.K.blocks(); ++b) {
    const Eigen::Index from = Eigen::Index{foils.block(b)} * foils.contacts_per_block();
    const Eigen::Index to = Eigen::Index{on_lines.block(b)} * std::ssize(like);
    for (Eigen::Index c = 0; c < std::ssize(like); ++c) {
      const auto [contact, strip] = like[static_cast<std::size_t>(c)];
      on_lines.assembled_gap[to + c] = strips[static_cast<std::size_t>(strip)].assembled_gap[from + contact];
    }
  }
}

}  // namespace bumpfoil
