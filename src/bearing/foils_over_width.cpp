#include <cstddef>
#include <utility>
#include <vector>

#include "bearing/foil_lines.hpp"
#include "bearing/strip_points.hpp"
#include "bumpfoil/bearing/assembly.hpp"
#include "bumpfoil/bearing/foils.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/top_foil_on_lines.hpp"

namespace bumpfoil {
namespace {

/// Half the axial length, m.
double half_width_of(const Foils& foils) {
  return 0.5 * foils.placed.front().alone.bearing.axial_length;
}

/// Of each station of the top foil.
int unknowns_of_membrane(const WidthLines& width) {
  return 2 * static_cast<int>(width.stretching_orders().size());
}

/// Adds the top foil of a pad to K of the problem.
/// @param stations  of top_foil_on_lines()
void add_top_foil(const Foils& foils, int pad, const WidthLines& width, const std::vector<int>& stations,
                  BlockTridiagonal& K) {
  const FoilDesign design = make_bearing_design(foils.placed[static_cast<std::size_t>(pad)].alone);
  const BlockTridiagonal top = top_foil_on_lines(design, width, stations);
  std::vector<int> places;
  places.reserve(static_cast<std::size_t>(top.block_size()));
  const int of_membrane = unknowns_of_membrane(width);
  int membrane = K.block_size() - of_membrane * static_cast<int>(stations.size());  // the last of the block
  for (std::size_t station = 0; station < stations.size(); ++station) {
    const Eigen::Index first = static_cast<Eigen::Index>(station) * width.count();
    for (const int unknown : {foils.structure.dofs.top_u, foils.structure.dofs.top_moment}) {
      for (Eigen::Index s = 0; s < width.count(); ++s) places.push_back(Foils::place(foils.lines, first + s, unknown));
    }
    for (int i = 0; i < of_membrane; ++i) places.push_back(membrane++);
  }
  const auto first = static_cast<std::size_t>(foils.structure.blocks_of(pad).first);
  for (std::size_t b = 0; b < top.diagonal.size(); ++b) K.diagonal[first + b](places, places) += top.diagonal[b];
  for (std::size_t b = 0; b < top.upper.size(); ++b) K.upper[first + b](places, places) += top.upper[b];
}

/// FoilStructure::forming of top foils that are one under each line, as stiff as its part of the width.
Vector forming_on_lines(const Foils& foils) {
  const BumpDofs& dofs = foils.structure.dofs;
  Vector forming = Vector::Zero(foils.problem.K.rows());
  for (std::size_t s = 0; s < foils.unstaggered_lines(); ++s) {
    const auto put = [&](int unknown, double part) {
      const Eigen::Index blocks = foils.structure.K.blocks();
      forming(Eigen::seqN(Eigen::Index{Foils::place(foils.lines, static_cast<Eigen::Index>(s), unknown)}, blocks,
                          Eigen::Index{foils.problem.K.block_size()})) =
          part * foils.structure.forming(Eigen::seqN(Eigen::Index{unknown}, blocks, Eigen::Index{dofs.size}));
    };
    put(dofs.top_u, foils.lines[s].weight);
    put(dofs.top_moment, 1.0);
  }
  return forming;
}

/// Adds to the gaps of the journal on each line how much nearer it stands there where it is tilted.
void add_tilt(const Eigen::Vector2d& slope, Foils& foils) {
  for (int s = 0; s < foils.journal_contacts(); ++s) {
    foils.assembled_gap(foils.pressed(s)) += foils.lines[static_cast<std::size_t>(s)].zeta *
                                             journal_gaps(0.0, foils.normals_on(s), half_width_of(foils) * slope);
  }
}

}  // namespace

Foils under_tilted_journal(const Foils& foils, int modes, const Eigen::Vector2d& slope, SheetModel sheet) {
  BUMPFOIL_ASSERT(foils.lines.empty() && foils.has_top_foil() && !foils.problem.law);
  const WidthLines width = make_width_lines(modes, WidthPart::whole);
  Foils tilted = foils;
  tilted.sheet = sheet;
  tilted.lines = foil_lines_of(width, sheet, foils.structure.dofs, foils.structure.dofs.size);
  BlockTridiagonal K(foils.structure.K.blocks(),
                     unknowns_on_lines(tilted) + unknowns_of_sheet(tilted, width) + unknowns_of_membrane(width));
  add_bump_foils(tilted, width, K);
  for (int pad = 0; pad < foils.pad_count(); ++pad) add_top_foil(tilted, pad, width, {0}, K);
  tilted.problem.K = std::move(K);
  tilted.forming = forming_on_lines(tilted);
  put_contacts_on_lines({&foils, 1}, 0.0, tilted);
  add_tilt(slope, tilted);
  return tilted;
}

Foils on_strips(const Foils& foils, int modes, const Eigen::Vector2d& slope) {
  BUMPFOIL_ASSERT(foils.lines.empty() && foils.has_top_foil() && !foils.problem.law);
  const WidthLines width = make_width_lines(modes, WidthPart::whole);
  const PadDesign& pad_design = foils.placed.front().alone;
  const std::vector<int> stations = pad_design.bump_foil.stations();
  const std::vector<Foils> strips = strips_of(foils);
  Foils split = foils;
  if (stations.size() > 1) {
    for (const Foils& strip : strips) split.strip_normals.push_back(strip.normals);
  }
  BlockTridiagonal& K = split.problem.K;
  const int blocks = foils.structure.K.blocks();
  if (pad_design.top_foil.split) {
    lay_out_split_foils(split);
    K = BlockTridiagonal(blocks, unknowns_on_lines(split));
    add_slices(split, strips, K);
  } else {
    lay_out_strips(width, foils.structure.dofs.size, split);
    const int of_membrane = static_cast<int>(stations.size()) * unknowns_of_membrane(width);
    K = BlockTridiagonal(blocks, unknowns_on_lines(split) + of_membrane);
    add_strips(split, strips, width, K);
    for (int pad = 0; pad < split.pad_count(); ++pad) add_top_foil(split, pad, width, stations, K);
  }
  keep_stress(strips, split);
  split.forming = forming_on_lines(split);
  put_contacts_on_lines(strips, 0.0, split);
  if (!foils.assembly.empty()) split.assembly = assemble_without_journal(split);
  add_tilt(slope, split);
  return split;
}

Foils foils_without_journal(const BearingDesign& design) {
  Foils foils = make_foils(design);
  return design.has_own_strips() ? on_strips(foils, 3, Eigen::Vector2d::Zero()) : foils;
}

}  // namespace bumpfoil
