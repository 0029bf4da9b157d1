#include "bumpfoil/structure/frame.hpp"

#include <algorithm>
#include <cmath>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

constexpr int unknowns_per_node = 3;
constexpr Eigen::Index clamped = -1;

}  // namespace

FrameModel make_frame_model(const Case& input) {
  const BumpFoil& foil = input.bump_foil;
  return {.section = make_section(foil.youngs_modulus, foil.poisson_ratio, input.bearing.axial_length, foil.thickness),
          .arcs = foil.stiffness_follows_height
                      ? make_own_arcs(foil)
                      : std::vector<BumpArc>(static_cast<std::size_t>(foil.bumps), make_bump_arc(foil)),
          .pitch = foil.pitch,
          .weld_at = foil.weld_at,
          .geometry = foil.geometry};
}

std::vector<BumpArc> make_own_arcs(const BumpFoil& foil) {
  std::vector<BumpArc> arcs(static_cast<std::size_t>(foil.bumps), make_bump_arc(foil));
  for (std::size_t n = 0; n < foil.height_errors.size(); ++n) {
    BumpFoil own = foil;
    own.height += foil.height_errors[n];
    arcs[n] = make_bump_arc(own);
    BUMPFOIL_ASSERT(arcs[n].rise > 0.0);
  }
  return arcs;
}

BumpDofs frame_dofs() {
  return {.size = 11, .crest_u = 3, .crest_v = 4, .foot_u = {0, 6}, .foot_v = {1, 7}, .top_u = 9, .top_moment = 10};
}

ElementChain place_elements(const FrameModel& model, int block_size) {
  ElementChain chain{.section = model.section, .rotation_scale = model.pitch, .elements = {}};
  Eigen::Index node = clamped;
  for (std::size_t n = 0; n < model.arcs.size(); ++n) {
    const BumpArc& arc = model.arcs[n];
    const Eigen::Index start = static_cast<Eigen::Index>(n) * block_size;
    const Eigen::Index crest = start + unknowns_per_node;
    const Eigen::Index end = crest + unknowns_per_node;
    if (n > 0) {
      chain.elements.push_back({flat_element(arc.flat), node, start});
      node = start;
    } else if (!model.welded) {
      node = start;
    } else if (model.weld_at == WeldPosition::mid_flat) {
      chain.elements.push_back({flat_element(0.5 * arc.flat), clamped, start});
      node = start;
    }
    chain.elements.push_back({rising_half(arc), node, crest});
    chain.elements.push_back({falling_half(arc), crest, end});
    node = end;
  }
  return chain;
}

void hold_covered_node(const FrameModel& model, BlockTridiagonal& K) {
  if (!model.welded || model.weld_at != WeldPosition::arc_start) return;
  for (int k = 0; k < unknowns_per_node; ++k) K.add(0, k, 0, k, model.section.axial_stiffness / model.pitch);
}

void assemble_frame(const FrameModel& model, BlockTridiagonal& K) {
  BUMPFOIL_ASSERT(K.block_size() == frame_dofs().size);
  BUMPFOIL_ASSERT(static_cast<std::size_t>(K.blocks()) == model.arcs.size());
  add_corotational_tangent(place_elements(model, K.block_size()), Vector::Zero(K.rows()), K);
  hold_covered_node(model, K);
}

FrameStress frame_stress(const FrameModel& model, const Vector& x) {
  const auto bumps = static_cast<Eigen::Index>(model.arcs.size());
  FrameStress stress{Vector::Zero(bumps), Vector::Zero(bumps), Vector::Zero(bumps), Vector::Zero(bumps), 0.0};
  const ElementChain chain = place_elements(model, frame_dofs().size);
  for (const PlacedElement& placed : chain.elements) {
    ElementVector ends = end_displacements(chain, placed, x);
    if (model.geometry == Geometry::nonlinear) ends = chord_deformations(placed.element, ends);
    const ElementForces forces = element_forces(model.section, placed.element, ends);
    const auto stress_at = [&](double s) {
      return std::abs(bending_moment(placed.element, forces, s)) / model.section.modulus;
    };
    if (placed.start == clamped) stress.weld = stress_at(-0.5);
    const Eigen::Index bump = placed.end / frame_dofs().size;
    switch (placed.end % frame_dofs().size / unknowns_per_node) {
      case 0:  // a flat: its stress is largest at its ends, and those are ends of arcs or the weld
        continue;
      case 1:
        stress.arc_start[bump] = stress_at(-0.5);
        stress.crest[bump] = stress_at(0.5);
        break;
      default:
        stress.arc_end[bump] = stress_at(0.5);
    }
    stress.largest[bump] =
        std::max(stress.largest[bump], largest_moment(placed.element, forces) / model.section.modulus);
  }
  return stress;
}

}  // namespace bumpfoil
