#include "bumpfoil/bearing/bearing_model.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "bearing/foil_lines.hpp"
#include "bumpfoil/bearing/assembly.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/single_bump.hpp"

namespace bumpfoil {
namespace {

/// @param input  gaps and friction of the bumps of `design`
BearingModel make_flat_foils(const PadDesign& pad, const FoilDesign& design) {
  BearingModel foils;
  foils.structure = make_foil_structure(design);
  foils.forming = foils.structure.forming;
  foils.stress = {make_stress_model(design)};

  const BumpDofs& dofs = foils.structure.dofs;
  foils.problem.K = foils.structure.K;
  foils.problem.force_scale = bump_force_scale(design);
  foils.round_off.force = 1e-12 * foils.problem.force_scale;
  foils.rise = std::max_element(design.bumps.begin(), design.bumps.end(), [](const BumpShape& a, const BumpShape& b) {
                 return a.rise < b.rise;
               })->rise;
  foils.round_off.energy = 1e-6 * foils.rise * foils.round_off.force;
  foils.round_off.stress = 1e-12 * pad.bump_foil.youngs_modulus;
  std::vector<ContactSite> pattern;
  if (design.top_foil) pattern.push_back({.plus = dofs.top_u});
  pattern.push_back({.plus = dofs.crest_v,
                     .minus = dofs.top_u,
                     .tangential = dofs.crest_u,
                     .friction_coefficient = pad.friction.top_bump});
  for (std::size_t foot = 0; foot < dofs.foot_u.size(); ++foot) {
    pattern.push_back({.minus = dofs.foot_v[foot],
                       .tangential = dofs.foot_u[foot],
                       .friction_coefficient = pad.friction.bump_sleeve});
  }
  foils.problem.sites = in_every_block(pattern, foils.problem.K.blocks());

  // All gaps of a block before bump 1 stay zero: its foot rests on the base, and the rest of the block is fixed.
  foils.assembled_gap.setZero(foils.problem.contacts());
  const Vector offsets = crest_offsets(pad.bump_foil);
  const Eigen::Index stride = foils.contacts_per_block();
  for (Eigen::Index bump = 0; bump < foils.bumps(); ++bump) {
    const Eigen::Index first = (foils.structure.first_bump + bump) * stride;
    const auto i = static_cast<std::size_t>(bump);
    foils.assembled_gap[first + foils.top_bump()] = 0.0 - offsets[bump];  // avoids negative zero
    if (!pad.bump_foil.sleeve_gaps.empty()) {
      foils.assembled_gap.segment(first + foils.first_foot(), dofs.feet()).setConstant(pad.bump_foil.sleeve_gaps[i]);
    }
  }
  return foils;
}

/// Adds the deviations of journal and sleeve from circles to the gaps. The foils lie stress-free in the sleeve and
/// follow it. The gap between journal and top foil over a crest grows by the increase of the sleeve radius and the
/// decrease of the journal radius there. The gap between a foot and the sleeve grows by the increase of the sleeve
/// radius from the crest of its bump to the foot. All gaps from the journal to the sleeve under a foot thus grow
/// together by the increase of the sleeve radius there.
void add_profiles(const PlacedPad& pad, BearingModel& foils) {
  const Vector crest_phi = pad.polar(pad.crests);
  const Vector under_crests = sleeve_deviations(pad.alone, pad.crests);
  const Vector under_feet = sleeve_deviations(pad.alone, pad.feet);
  for (Eigen::Index bump = 0; bump < foils.bumps(); ++bump) {
    const Eigen::Index first = (foils.structure.first_bump + bump) * foils.contacts_per_block();
    foils.assembled_gap[first] += under_crests[bump] - deviation_at(pad.alone.bearing.journal, crest_phi[bump]);
    for (Eigen::Index k = 0; k < foils.feet_per_block(); ++k) {
      const double under_foot = under_feet[bump * foils.feet_per_block() + k];
      foils.assembled_gap[first + foils.first_foot() + k] += under_foot - under_crests[bump];
    }
  }
}

BearingModel make_pad_foils(const PlacedPad& pad) {
  BearingModel foils = make_flat_foils(pad.alone, make_bearing_design(pad.alone));
  foils.clearance = pad.alone.bearing.radial_clearance;
  foils.normals = outward_normals(pad.polar(pad.crests));
  if (!pad.alone.bearing.is_round()) add_profiles(pad, foils);
  foils.assembled_gap(foils.pressed()) -= journal_gaps(0.0, foils.normals, pad.centre);
  return foils;
}

/// Appends the foils of one more pad.
void append(const BearingModel& pad, BearingModel& foils) {
  for (ContactSite site : pad.problem.sites) {
    site.block += foils.structure.K.blocks();
    foils.problem.sites.push_back(site);
  }
  append(pad.structure, foils.structure);
  foils.stress.push_back(pad.stress.front());
  foils.problem.K = foils.structure.K;
  foils.problem.force_scale = std::max(foils.problem.force_scale, pad.problem.force_scale);
  foils.rise = std::max(foils.rise, pad.rise);
  foils.round_off.force = std::max(foils.round_off.force, pad.round_off.force);
  foils.round_off.energy = std::max(foils.round_off.energy, pad.round_off.energy);
  foils.round_off.stress = std::max(foils.round_off.stress, pad.round_off.stress);
  const Eigen::Index bumps = foils.normals.cols();
  foils.normals.conservativeResize(Eigen::NoChange, bumps + pad.normals.cols());
  foils.normals.rightCols(pad.normals.cols()) = pad.normals;
  foils.forming = foils.structure.forming;
  const Eigen::Index contacts = foils.assembled_gap.size();
  foils.assembled_gap.conservativeResize(contacts + pad.assembled_gap.size());
  foils.assembled_gap.tail(pad.assembled_gap.size()) = pad.assembled_gap;
}

}  // namespace

int BearingModel::block(int of_structure) const {
  if (!film) return of_structure;
  const auto behind = std::upper_bound(structure.pads.begin(), structure.pads.end(), of_structure);
  return of_structure + static_cast<int>(behind - structure.pads.begin()) - 1;  // free ends of the previous pads
}

std::size_t BearingModel::unstaggered_lines() const {
  if (split_top_foil) return lines.size();
  return static_cast<std::size_t>(std::count_if(
      lines.begin(), lines.end(), [&](const FoilLine& line) { return line.strip == lines.front().strip; }));
}

Vector BearingModel::foil_unknowns(const Vector& x, std::optional<int> strip) const {
  if (!film && lines.empty()) return x;
  const Eigen::Index size = structure.dofs.size;
  Vector known(structure.K.rows());
  for (int b = 0; b < structure.K.blocks(); ++b) {
    const auto all = x.segment(Eigen::Index{block(b)} * problem.K.block_size(), problem.K.block_size());
    auto own = known.segment(b * size, size);
    own = all.head(size);
    for (int i = 0; i < size; ++i) {
      if (is_uniform(i)) continue;
      own[i] = 0.0;
      const bool of_top_foil = i == structure.dofs.top_u || i == structure.dofs.top_moment;
      const std::vector<FoilLine>& given = of_top_foil ? lines : crest_lines();
      const std::size_t count = of_top_foil ? unstaggered_lines() : given.size();
      for (std::size_t s = 0; s < count; ++s) {
        double part = i == structure.dofs.top_moment ? 1.0 : given[s].weight;
        if (strip && !of_top_foil) part = given[s].strip == *strip ? 0.5 : 0.0;  // the rule has two points per strip
        own[i] += part * all[place(given, static_cast<Eigen::Index>(s), i)];
      }
    }
  }
  return known;
}

std::optional<ElasticLaw> elastic_law(const FoilStructure& structure) {
  if (!structure.large_displacements) return std::nullopt;
  const auto shared = std::make_shared<const FoilStructure>(structure);
  return ElasticLaw{.forces = [shared](const Vector& x) { return internal_forces(*shared, x); },
                    .tangent = [shared](const Vector& x) { return tangent_stiffness(*shared, x); },
                    .stable_tangent = [shared](const Vector& x) { return stable_tangent_stiffness(*shared, x); }};
}

BearingModel make_uniform_foils(std::vector<PlacedPad> pads) {
  BearingModel foils = make_pad_foils(pads.front());
  for (std::size_t k = 1; k < pads.size(); ++k) append(make_pad_foils(pads[k]), foils);
  foils.placed = std::move(pads);
  foils.problem.law = elastic_law(foils.structure);
  return foils;
}

namespace {

BearingModel make_assembled_foils(std::vector<PlacedPad> pads) {
  BearingModel foils = make_uniform_foils(std::move(pads));
  if ((foils.structure.forming.array() != 0.0).any()) foils.assembly = assemble_without_journal(foils);
  return foils;
}

}  // namespace

BearingModel make_foils(const BearingDesign& design) {
  return make_assembled_foils(place_pads(design));
}

BearingModel make_film_foils(const BearingDesign& design) {
  return make_assembled_foils(place_film_pads(design));
}

BearingModel make_foils(const PadDesign& whole, int bumps, StripWeld weld, bool top_foil) {
  BearingModel foils = make_flat_foils(cut_to(whole, bumps), make_strip_design(whole, bumps, weld, top_foil));
  foils.normals = outward_normals(Vector::Zero(foils.bumps()));
  foils.problem.law = elastic_law(foils.structure);
  return foils;
}

ContactLoading loading_under(const BearingModel& foils, const Excitation& excitation) {
  ContactLoading loading{.initial_gap = foils.assembled_gap, .load = foils.forming};
  for (int line = 0; line < foils.journal_contacts(); ++line) {
    loading.initial_gap(foils.pressed(line)) +=
        journal_gaps(foils.clearance, foils.normals_on(line), excitation.position);
  }
  if (excitation.gap_offset.size() > 0) loading.initial_gap += excitation.gap_offset;
  if (excitation.top_load.size() > 0) {
    BUMPFOIL_ASSERT(foils.has_top_foil());
    if (foils.lines.empty()) loading.load(foils.top_foil()) += excitation.top_load;
    for (std::size_t s = 0; s < foils.unstaggered_lines(); ++s) {
      loading.load(foils.top_foil(static_cast<int>(s))) += foils.lines[s].weight * excitation.top_load;
    }
  }
  return loading;
}

ContactLoading loading_rate(const BearingModel& foils, const Eigen::Vector2d& direction) {
  ContactLoading rate = ContactLoading::none(foils.problem);
  for (int line = 0; line < foils.journal_contacts(); ++line) {
    rate.initial_gap(foils.pressed(line)) = journal_gaps(0.0, foils.normals_on(line), direction);
  }
  return rate;
}

Vector pressing_loads(const BearingModel& foils, const Vector& normal_force) {
  Vector loads = normal_force(foils.pressed());
  for (int line = 1; line < foils.journal_contacts(); ++line) loads += normal_force(foils.pressed(line));
  return loads;
}

namespace {

/// Force of the journal on the staggered strips of successive bumps.
Eigen::Vector2d force_on_strips(const BearingModel& foils, const Vector& normal_force, const PadBlocks& bumps) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (int line = 0; line < foils.journal_contacts(); ++line) {
    const Vector loads = normal_force(foils.pressed(line));
    sum += journal_force(foils.normals_on(line).middleCols(bumps.first, bumps.count),
                         loads.segment(bumps.first, bumps.count));
  }
  return sum;
}

}  // namespace

Eigen::Vector2d holding_force(const BearingModel& foils, const Vector& normal_force) {
  if (!foils.strip_normals.empty()) return force_on_strips(foils, normal_force, {0, foils.bumps()});
  return journal_force(foils.normals, pressing_loads(foils, normal_force));
}

Eigen::Vector2d holding_moment(const BearingModel& foils, const Vector& normal_force) {
  Eigen::Vector2d at_side = Eigen::Vector2d::Zero();
  for (std::size_t s = 0; s < foils.lines.size(); ++s) {
    const auto line = static_cast<int>(s);
    at_side += foils.lines[s].zeta * journal_force(foils.normals_on(line), normal_force(foils.pressed(line)));
  }
  return foils.lines.empty() ? at_side : 0.5 * foils.placed.front().alone.bearing.axial_length * at_side;
}

Eigen::Vector2d journal_slope(const BearingModel& foils, const Vector& x) {
  if (foils.journal_tilt < 0) return foils.over_width.slope;
  return x.segment<2>(foils.journal_tilt) / (0.5 * foils.placed.front().alone.bearing.axial_length);
}

double work_of_moment(const BearingModel& foils, const Vector& x) {
  return foils.over_width.moment ? foils.over_width.moment->dot(journal_slope(foils, x)) : 0.0;
}

ElasticResponse elastic_response(const BearingModel& foils, const Vector& x) {
  if (foils.lines.empty()) return elastic_response(foils.structure, x);
  const Vector balance = foils.problem.K.multiply(x);
  const double load_energy = x.dot(foils.forming) - work_of_moment(foils, x);  // the loads include the moment
  return {.forces = balance - foils.forming,
          .energy = 0.5 * x.dot(balance) - load_energy + foils.structure.forming_energy};
}

Eigen::Matrix2Xd pad_forces(const BearingModel& foils, const Vector& normal_force) {
  Eigen::Matrix2Xd forces(2, foils.pad_count() > 1 ? foils.pad_count() : 0);
  if (forces.cols() == 0) return forces;
  const Vector loads = pressing_loads(foils, normal_force);
  for (Eigen::Index k = 0; k < forces.cols(); ++k) {
    const PadBlocks blocks = foils.structure.blocks_of(static_cast<int>(k));
    const auto bumps = Eigen::seqN(blocks.first, blocks.count);
    forces.col(k) = foils.strip_normals.empty() ? journal_force(foils.normals(Eigen::all, bumps), loads(bumps))
                                                : force_on_strips(foils, normal_force, blocks);
  }
  return forces;
}

}  // namespace bumpfoil
