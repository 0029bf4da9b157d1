#include <cstddef>
#include <utility>
#include <vector>

#include "bearing/foil_lines.hpp"
#include "bearing/strip_points.hpp"
#include "bumpfoil/bearing/assembly.hpp"
#include "bumpfoil/bearing/bearing_model.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/top_foil_on_lines.hpp"

namespace bumpfoil {
namespace {

/// Spring against otherwise unresisted tilt, over the stiffest of the bump foils: negligibly soft.
constexpr double spring_of_journal = 1e-10;

/// Half the axial length, m.
double half_width_of(const BearingModel& foils) {
  return 0.5 * foils.placed.front().alone.bearing.axial_length;
}

/// Number of membrane unknowns per station of the top foil.
int unknowns_of_membrane(const WidthLines& width) {
  return 2 * static_cast<int>(width.stretching_orders().size());
}

/// Adds the top foil of a pad to K of the problem, with its forming.
/// @param stations  of top_foil_on_lines()
void add_top_foil(int pad, const WidthLines& width, const std::vector<int>& stations, BearingModel& foils) {
  BlockTridiagonal& K = foils.problem.K;
  const FoilDesign design = make_bearing_design(foils.placed[static_cast<std::size_t>(pad)].alone);
  const TopFoilOnLines foil = top_foil_on_lines(design, width, stations);
  const BlockTridiagonal& top = foil.K;
  std::vector<int> places;
  places.reserve(static_cast<std::size_t>(top.block_size()));
  const int of_membrane = unknowns_of_membrane(width);
  int membrane = K.block_size() - of_membrane * static_cast<int>(stations.size());  // the last unknowns of the block
  for (std::size_t station = 0; station < stations.size(); ++station) {
    const Eigen::Index first = static_cast<Eigen::Index>(station) * width.count();
    for (const int unknown : {foils.structure.dofs.top_u, foils.structure.dofs.top_moment}) {
      for (Eigen::Index s = 0; s < width.count(); ++s)
        places.push_back(BearingModel::place(foils.lines, first + s, unknown));
    }
    for (int i = 0; i < of_membrane; ++i) places.push_back(membrane++);
  }
  const auto first = static_cast<std::size_t>(foils.structure.blocks_of(pad).first);
  for (std::size_t b = 0; b < top.diagonal.size(); ++b) K.diagonal[first + b](places, places) += top.diagonal[b];
  for (std::size_t b = 0; b < top.upper.size(); ++b) K.upper[first + b](places, places) += top.upper[b];
  for (int b = 0; b < top.blocks(); ++b) {
    const Eigen::Index to = Eigen::Index{foils.structure.blocks_of(pad).first + b} * K.block_size();
    Eigen::Index from = Eigen::Index{b} * top.block_size();
    for (const int place : places) foils.forming[to + place] += foil.forming[from++];
  }
  foils.structure.forming_energy += foil.forming_energy;
}

/// Adds the top foils of all pads to K of the problem, with their forming.
void add_top_foils(const WidthLines& width, const std::vector<int>& stations, BearingModel& foils) {
  foils.forming.setZero(foils.problem.K.rows());
  foils.structure.forming_energy = 0.0;
  for (int pad = 0; pad < foils.pad_count(); ++pad) add_top_foil(pad, width, stations, foils);
}

/// FoilStructure::forming of split top foils, one slice per point, with the stiffness of its part of the width.
Vector forming_of_slices(const BearingModel& foils) {
  const BumpDofs& dofs = foils.structure.dofs;
  const Eigen::Index blocks = foils.structure.K.blocks();
  Vector forming = Vector::Zero(foils.problem.K.rows());
  for (const FoilLine& point : foils.points) {
    const auto put = [&](int unknown, double part) {
      forming(Eigen::seqN(Eigen::Index{point.places[static_cast<std::size_t>(unknown)]}, blocks,
                          Eigen::Index{foils.problem.K.block_size()})) =
          part * foils.structure.forming(Eigen::seqN(Eigen::Index{unknown}, blocks, Eigen::Index{dofs.size}));
    };
    put(dofs.top_u, point.weight);
    put(dofs.top_moment, 1.0);
  }
  return forming;
}

/// Number of unknowns of a block for a journal that tilts under a moment.
int unknowns_of_journal(const BearingModel& foils, const JournalOverWidth& journal) {
  return journal.moment ? 4 + 2 * foils.journal_contacts() : 0;
}

/// Lets the journal tilt under its moment. Its tilt is an unknown of every block, tied to that of the next; so is its
/// outward displacement on each line, tied to the tilt. Each tie has a force. Contacts of the journal act on these
/// displacements.
/// @param first  index of its unknowns in each block
void free_tilt(int first, BearingModel& foils) {
  BlockTridiagonal& K = foils.problem.K;
  const double tie = stiffest_of_bump_foils(foils.structure);  // scales its rows to the others
  foils.journal_tilt = first;
  for (int b = 0; b < K.blocks(); ++b) {
    const bool last = b + 1 == K.blocks();
    for (int axis = 0; axis < 2; ++axis) {
      const int tilt = first + axis;
      const int force = first + 2 + axis;
      if (last) {
        K.add(b, tilt, b, tilt, spring_of_journal * tie);
        K.add(b, force, b, force, tie);  // no force
      } else {
        K.add(b, tilt, b, force, tie);
        K.add(b, force, b + 1, tilt, -tie);
      }
    }
    const int bump = b - foils.structure.first_bump;
    for (int s = 0; s < foils.journal_contacts(); ++s) {
      const int outward = first + 4 + 2 * s;
      const int force = outward + 1;
      K.add(b, outward, b, force, -tie);
      const double zeta = foils.lines[static_cast<std::size_t>(s)].zeta;
      for (int axis = 0; bump >= 0 && axis < 2; ++axis) {
        K.add(b, first + axis, b, force, tie * zeta * foils.normals_on(s)(axis, bump));
      }
      const int contact = b * foils.contacts_per_block() + s;
      foils.problem.sites[static_cast<std::size_t>(contact)].minus = outward;
    }
  }
  const Eigen::Index end = K.rows() - K.block_size();
  foils.forming.segment<2>(end + first) += *foils.over_width.moment / half_width_of(foils);
}

/// Adds the offset of the journal on each line from its mid-plane position to its gaps, for a given tilt.
void add_distances(BearingModel& foils) {
  for (int s = 0; s < foils.journal_contacts(); ++s) {
    const double zeta = foils.lines[static_cast<std::size_t>(s)].zeta;
    const Vector by_tilt = journal_gaps(0.0, foils.normals_on(s), half_width_of(foils) * foils.over_width.slope);
    foils.assembled_gap(foils.pressed(s)).array() += foils.over_width.profile.widening(zeta) + zeta * by_tilt.array();
  }
}

/// Adds the journal to foils that are on lines or strips.
/// @param first  index in a block of unknowns_of_journal()
void put_journal(const JournalOverWidth& journal, int first, BearingModel& foils) {
  foils.over_width = journal;
  add_distances(foils);
  if (journal.moment) free_tilt(first, foils);
}

}  // namespace

BearingModel on_lines(const BearingModel& foils, int modes, const JournalOverWidth& journal, SheetModel sheet) {
  BUMPFOIL_ASSERT(foils.lines.empty() && foils.has_top_foil() && !foils.problem.law);
  const WidthLines width = make_width_lines(modes, WidthPart::whole);
  BearingModel varied = foils;
  varied.sheet = sheet;
  varied.lines = foil_lines_of(width, sheet, foils.structure.dofs, foils.structure.dofs.size);
  const int of_foils = unknowns_on_lines(varied) + unknowns_of_sheet(varied, width);
  BlockTridiagonal K(foils.structure.K.blocks(),
                     of_foils + unknowns_of_journal(varied, journal) + unknowns_of_membrane(width));
  add_bump_foils(varied, width, K);
  varied.problem.K = std::move(K);
  add_top_foils(width, {0}, varied);
  put_contacts_on_lines({&foils, 1}, 0.0, varied);
  put_journal(journal, of_foils, varied);
  return varied;
}

BearingModel on_strips(const BearingModel& foils, int modes, const JournalOverWidth& journal) {
  BUMPFOIL_ASSERT(foils.lines.empty() && foils.has_top_foil() && !foils.problem.law);
  const WidthLines width = make_width_lines(modes, WidthPart::whole);
  const PadDesign& pad_design = foils.placed.front().alone;
  const std::vector<int> stations = pad_design.bump_foil.stations();
  const std::vector<BearingModel> strips = strips_of(foils);
  BearingModel split = foils;
  if (stations.size() > 1) {
    for (const BearingModel& strip : strips) split.strip_normals.push_back(strip.normals);
  }
  BlockTridiagonal& K = split.problem.K;
  const int blocks = foils.structure.K.blocks();
  if (pad_design.top_foil.split) {
    lay_out_split_foils(split);
    K = BlockTridiagonal(blocks, unknowns_on_lines(split) + unknowns_of_journal(split, journal));
    add_slices(split, strips, K);
    split.forming = forming_of_slices(split);
  } else {
    lay_out_strips(width, foils.structure.dofs.size, split);
    const int of_membrane = static_cast<int>(stations.size()) * unknowns_of_membrane(width);
    K = BlockTridiagonal(blocks, unknowns_on_lines(split) + unknowns_of_journal(split, journal) + of_membrane);
    add_strips(split, strips, width, K);
    add_top_foils(width, stations, split);
  }
  keep_stress(strips, split);
  put_contacts_on_lines(strips, 0.0, split);
  if (!foils.assembly.empty()) split.assembly = assemble_without_journal(split);
  put_journal(journal, unknowns_on_lines(split), split);
  return split;
}

BearingModel foils_without_journal(const BearingDesign& design) {
  BearingModel foils = make_foils(design);
  return design.has_own_strips() ? on_strips(foils, 3, {}) : foils;
}

}  // namespace bumpfoil
