#include "bearing/film_bump_foils.hpp"

#include <algorithm>
#include <numeric>

#include "bumpfoil/structure/held_crests.hpp"

namespace bumpfoil {
namespace {

/// Springs against what higher modes do not displace, over the stiffest of the bump foils: what such a sheet is against
/// shear and stretch in its own surface counts as rigid.
constexpr double rigidity_of_sheet = 1e2;

bool is_of_top_foil(const BumpDofs& dofs, int place) {
  return place == dofs.top_u || place == dofs.top_moment;
}

/// Unknowns of a block.
int block_size_of(const FilmBearing& bearing) {
  const FoilFilm& foil = bearing.pads.front().foil;
  int largest = bearing.first_pressure() + foil.mesh.unknown_rows() - 1;
  for (const FoilLine& line : bearing.lines) {
    largest = std::max(largest, *std::max_element(line.places.begin(), line.places.end()));
  }
  return largest + 1 + 2 * static_cast<int>(foil.stretching.rows());
}

/// The largest entry of the bump foils, N/m.
double stiffest_of(const FoilStructure& structure) {
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

/// Adds a block of K of one mode to that of the lines.
/// @param alike  of the mode on two lines: the part of the block that joins them
template <typename Alike>
void add_block(const FilmBearing& bearing, const Matrix& block, const Alike& alike, Matrix& sum) {
  const BumpDofs& dofs = bearing.dofs();
  for (int s = 0; s < bearing.crest_contacts(); ++s) {
    for (int r = 0; r < bearing.crest_contacts(); ++r) {
      const double part = alike(s, r);
      for (int i = 0; i < dofs.size; ++i) {
        if (is_of_top_foil(dofs, i)) continue;
        for (int j = 0; j < dofs.size; ++j) {
          if (is_of_top_foil(dofs, j)) continue;
          sum(bearing.place(s, i), bearing.place(r, j)) += part * block(i, j);
        }
      }
    }
  }
}

}  // namespace

std::vector<FoilLine> foil_lines_of(const WidthLines& lines, const BumpDofs& dofs, int further) {
  std::vector<FoilLine> placed(static_cast<std::size_t>(lines.count()));
  const bool all_vary = lines.orders.size() > 1 && lines.orders[1] == 1;
  const auto varies = [&](int i) {
    return all_vary || is_of_top_foil(dofs, i) || i == dofs.crest_u || i == dofs.crest_v;
  };
  for (std::size_t s = 0; s < placed.size(); ++s) {
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

BlockTridiagonal bump_foils_alone(const FilmBearing& bearing) {
  const FoilStructure& structure = bearing.structure;
  const WidthLines& lines = bearing.pads.front().foil.lines;
  const BumpDofs& dofs = structure.dofs;
  BlockTridiagonal K(structure.K.blocks() + bearing.pad_count(), block_size_of(bearing));
  const double largest = stiffest_of(structure);
  for (Eigen::Index mode = 0; mode < lines.count(); ++mode) {
    const int order = lines.orders[static_cast<std::size_t>(mode)];
    const double square = 1.0 / (2 * order + 1);  // of P_k over the width
    const auto alike = [&](Eigen::Index s, Eigen::Index r) {
      return square * lines.to_modes(mode, s) * lines.to_modes(mode, r);
    };
    Matrix rigid = Matrix::Zero(dofs.size, dofs.size);
    for (int i = 0; i < dofs.size; ++i) {
      if (i != dofs.crest_v && !bearing.is_uniform(i)) rigid(i, i) = rigidity_of_sheet * largest;
    }
    for (std::size_t k = 0; k < bearing.pads.size(); ++k) {
      const PadBlocks blocks = structure.blocks_of(static_cast<int>(k));
      const Matrix held = order >= 2 ? held_crest_stiffness(structure, static_cast<int>(k)) : Matrix();
      for (int b = 0; b < blocks.count; ++b) {
        const auto from = static_cast<std::size_t>(blocks.first) + static_cast<std::size_t>(b);
        const auto to = static_cast<std::size_t>(bearing.pads[k].first_block) + static_cast<std::size_t>(b);
        const bool last = b + 1 == blocks.count;
        if (order < 2) {
          add_block(bearing, structure.K.diagonal[from], alike, K.diagonal[to]);
          if (!last) add_block(bearing, structure.K.upper[from], alike, K.upper[to]);
          continue;
        }
        rigid(dofs.crest_v, dofs.crest_v) = held(b, b);
        add_block(bearing, rigid, alike, K.diagonal[to]);
        if (last) continue;
        Matrix next = Matrix::Zero(dofs.size, dofs.size);
        next(dofs.crest_v, dofs.crest_v) = held(b, b + 1);
        add_block(bearing, next, alike, K.upper[to]);
      }
    }
  }
  // What means nothing at the free ends is held, the displacement there is not.
  for (const FilmPad& pad : bearing.pads) {
    Matrix& last = K.diagonal[static_cast<std::size_t>(pad.first_block) + pad.foil.supports.size()];
    last.diagonal().setConstant(largest);
    last.diagonal().segment(bearing.first_pressure(), lines.count()).setZero();
  }
  return K;
}

}  // namespace bumpfoil
