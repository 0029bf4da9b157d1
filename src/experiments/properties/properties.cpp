#include "bumpfoil/experiments/properties/properties.hpp"

#include <cstddef>
#include <vector>

#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/pads.hpp"
#include "bumpfoil/model/validation.hpp"
#include "bumpfoil/structure/foil_structure.hpp"
#include "bumpfoil/structure/single_bump.hpp"
#include "bumpfoil/structure/top_foil.hpp"
#include "core/linear_algebra.hpp"

namespace bumpfoil {
namespace {

/// Dense eigenvalues of more unknowns take too long.
constexpr Eigen::Index most_unknowns = 2000;

/// The soft end from the compliance, the stiff end from the stiffness, where each is accurate.
std::optional<StiffnessRange> top_foil_range(const FoilDesign& foils) {
  if (!foils.top_foil || !foils.radius || std::ssize(foils.bumps) > most_unknowns) return std::nullopt;
  const TopFoilBeam beam = make_top_foil_beam(foils);
  const TopFoilMoments form = make_top_foil_moments(beam);
  Matrix stiffness(form.size(), form.size());
  for (Eigen::Index j = 0; j < form.size(); ++j) stiffness.col(j) = top_foil_loads(form, Vector::Unit(form.size(), j));
  return StiffnessRange{.softest = 1.0 / symmetric_eigenvalues(top_foil_compliance(beam)).maxCoeff(),
                        .stiffest = symmetric_eigenvalues(stiffness).maxCoeff()};
}

std::optional<StiffnessRange> bump_foil_range(const PadDesign& pad, const FoilDesign& foils) {
  if (pad.bump_foil.model != BumpFoilModel::frame && !find_truss_errors(foils).empty()) return std::nullopt;
  const FoilStructure structure = make_foil_structure(foils);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index row = 0; row < structure.K.rows(); ++row) {
    const auto place = static_cast<int>(row % structure.dofs.size);
    if (place != structure.dofs.top_u && place != structure.dofs.top_moment) kept.push_back(row);
  }
  if (std::ssize(kept) > most_unknowns) return std::nullopt;
  const Vector values = symmetric_eigenvalues(structure.K.dense()(kept, kept));
  return StiffnessRange{.softest = values.minCoeff(), .stiffest = values.maxCoeff()};
}

BearingDesign bearing_of(const PadDesign& pad) {
  BearingDesign alone;
  static_cast<PadDesign&>(alone) = pad;
  return alone;
}

std::optional<PadAssembly> assembly_of(const PadDesign& pad, const FoilDesign& foils) {
  if (!is_formed(pad) || (pad.bump_foil.model != BumpFoilModel::frame && !find_truss_errors(foils).empty())) return {};
  const std::vector<PadAssembly> assembly = foils_without_journal(bearing_of(pad)).assembly;
  return assembly.empty() ? std::nullopt : std::optional(assembly.front());
}

BumpProperties properties_of(const FoilDesign& foils, const BumpShape& bump, double friction) {
  const BumpArc arc = make_bump_arc(bump);
  const Section section = make_bump_section(foils, bump);
  BumpProperties properties;
  properties.shape = bump;
  properties.arc = arc;
  properties.cell = make_bump_cell(arc, section);
  properties.identified = identify_truss_constants(arc, section);
  properties.shallow_bump = shallow_bump_stiffness(arc, section);
  properties.sliding_bump = sliding_bump_stiffness(arc, section, 0.0);
  properties.guided_bump = guided_bump_stiffness(arc, section);
  properties.loading_bump = sliding_bump_stiffness(arc, section, friction);
  properties.unloading_bump = sliding_bump_stiffness(arc, section, -friction);
  return properties;
}

std::vector<BumpProperties> shapes_of(const PadDesign& pad, const FoilDesign& foils) {
  std::vector<BumpProperties> shapes;
  int number = 0;
  for (const BumpShape& bump : nominal_bumps(pad.bump_foil)) {
    ++number;
    if (shapes.empty() || shapes.back().shape != bump) {
      shapes.push_back(properties_of(foils, bump, pad.friction.bump_sleeve));
      shapes.back().from = number;
    }
    shapes.back().to = number;
  }
  return shapes;
}

std::vector<StripProperties> strips_of(const PadDesign& pad) {
  std::vector<StripProperties> strips;
  const PlacedPad placed = place_pads(bearing_of(pad)).front();
  for (std::size_t k = 0; k < pad.bump_foil.strip.size(); ++k) {
    if (!pad.bump_foil.strip[k].has_own_bumps()) continue;
    const auto strip = static_cast<int>(k);
    const PadDesign alone = cut_out(placed, strip).alone;
    const FoilDesign foils = make_bearing_design(alone);
    strips.push_back({.strip = strip + 1,
                      .width = strip_width(pad),
                      .bumps = shapes_of(alone, foils),
                      .bump_foil = bump_foil_range(alone, foils)});
  }
  return strips;
}

}  // namespace

Properties compute_properties(const PadDesign& pad) {
  const FoilDesign foils = make_bearing_design(pad);
  return {.bumps = shapes_of(pad, foils),
          .top_foil = top_foil_range(foils),
          .assembly = assembly_of(pad, foils),
          .bump_foil = bump_foil_range(pad, foils),
          .strips = strips_of(pad)};
}

Properties compute_properties(const Case& input) {
  require_valid(input);
  return compute_properties(static_cast<const PadDesign&>(input));
}

}  // namespace bumpfoil
