#include "bearing/film_bump_foils.hpp"

#include <algorithm>

#include "bumpfoil/structure/held_crests.hpp"

namespace bumpfoil {
namespace {

/// Springs that keep a crest from sliding differently on its lines, over the stiffest of the bump foils: what such a
/// sheet is against shear and stretch in its own surface counts as rigid.
constexpr double rigidity_of_sheet = 1e2;

/// Unknowns of a block.
int block_size_of(const BumpDofs& dofs, const FoilFilm& foil) {
  const auto lines = static_cast<int>(foil.lines.count());
  const auto of_membrane = 2 * static_cast<int>(foil.varying.rows());
  return dofs.size + foil.mesh.rows + 4 * (lines - 1) + of_membrane;
}

/// Adds what a crest has against displacements that vary over the width.
/// @param rigid  of springs against sliding that varies, N/m
void add_varying_modes(const FilmBearing& bearing, double rigid, BlockTridiagonal& K) {
  const WidthLines& lines = bearing.pads.front().foil.lines;
  for (Eigen::Index mode = 1; mode < lines.to_modes.rows(); ++mode) {
    const double square = 1.0 / (2 * lines.orders[static_cast<std::size_t>(mode)] + 1);  // of P_k over the width
    for (std::size_t k = 0; k < bearing.pads.size(); ++k) {
      const Matrix held = held_crest_stiffness(bearing.structure, static_cast<int>(k));
      for (int i = 0; i < held.rows(); ++i) {
        const int block = bearing.pads[k].first_block + i;
        for (std::size_t s = 0; s < bearing.crest_lines.size(); ++s) {
          for (std::size_t r = 0; r < bearing.crest_lines.size(); ++r) {
            const CrestLine& row = bearing.crest_lines[s];
            const CrestLine& column = bearing.crest_lines[r];
            const double part = square * lines.to_modes(mode, static_cast<Eigen::Index>(s)) *
                                lines.to_modes(mode, static_cast<Eigen::Index>(r));
            const auto at = static_cast<std::size_t>(block);
            K.diagonal[at](row.crest_v, column.crest_v) += part * held(i, i);
            K.diagonal[at](row.crest_u, column.crest_u) += part * rigid;
            if (i + 1 < held.rows()) K.upper[at](row.crest_v, column.crest_v) += part * held(i, i + 1);
          }
        }
      }
    }
  }
}

}  // namespace

std::vector<CrestLine> crest_lines_of(const WidthLines& lines, const BumpDofs& dofs, int further) {
  std::vector<CrestLine> crest_lines{{.weight = lines.weight[0],
                                      .top_u = dofs.top_u,
                                      .top_moment = dofs.top_moment,
                                      .crest_u = dofs.crest_u,
                                      .crest_v = dofs.crest_v}};
  for (Eigen::Index s = 1; s < lines.count(); ++s, further += 4) {
    crest_lines.push_back({.weight = lines.weight[s],
                           .top_u = further,
                           .top_moment = further + 1,
                           .crest_u = further + 2,
                           .crest_v = further + 3});
  }
  return crest_lines;
}

BlockTridiagonal bump_foils_alone(const FilmBearing& bearing) {
  const FoilStructure& structure = bearing.structure;
  const FoilFilm& first_foil = bearing.pads.front().foil;
  const BumpDofs& dofs = structure.dofs;
  BlockTridiagonal K(structure.K.blocks() + bearing.pad_count(), block_size_of(dofs, first_foil));
  // Where an unknown of the structure is among those of the problem: it is the mean of those of all lines.
  const auto for_places = [&](int i, const auto& visit) {
    if (i == dofs.top_u || i == dofs.top_moment) return;
    if (i != dofs.crest_u && i != dofs.crest_v) return visit(i, 1.0);
    for (const CrestLine& line : bearing.crest_lines)
      visit(i == dofs.crest_u ? line.crest_u : line.crest_v, line.weight);
  };
  double largest = 0.0;
  for (std::size_t k = 0; k < bearing.pads.size(); ++k) {
    const PadBlocks blocks = structure.blocks_of(static_cast<int>(k));
    auto from = static_cast<std::size_t>(blocks.first);
    auto to = static_cast<std::size_t>(bearing.pads[k].first_block);
    for (int b = 0; b < blocks.count; ++b, ++from, ++to) {
      for (int i = 0; i < dofs.size; ++i) {
        for (int j = 0; j < dofs.size; ++j) {
          for_places(i, [&](int row, double part_of_row) {
            for_places(j, [&](int column, double part_of_column) {
              const double part = part_of_row * part_of_column;
              K.diagonal[to](row, column) = part * structure.K.diagonal[from](i, j);
              if (b + 1 < blocks.count) K.upper[to](row, column) = part * structure.K.upper[from](i, j);
              largest = std::max(largest, structure.K.diagonal[from](i, j));
            });
          });
        }
      }
    }
  }
  add_varying_modes(bearing, rigidity_of_sheet * largest, K);
  // What means nothing at the free ends is held, the displacement there is not.
  for (const FilmPad& pad : bearing.pads) {
    Matrix& last = K.diagonal[static_cast<std::size_t>(pad.first_block) + pad.foil.supports.size()];
    last.diagonal().setConstant(largest);
    last.diagonal().segment(bearing.first_pressure(), pad.foil.lines.count()).setZero();
  }
  return K;
}

}  // namespace bumpfoil
