#include "bumpfoil/structure/frame.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

constexpr int nodes_per_bump = 3;
constexpr int unknowns_per_node = 3;
constexpr int clamped = -1;

/// Element between two nodes; node 3 n + {0, 1, 2} is start, crest, end of bump n.
struct PlacedElement {
  FrameElement element;
  int start{clamped};
  int end{};
};

/// First the flat before the bump (none where the weld covers it), then its two arcs, bump after bump.
std::vector<PlacedElement> place_elements(const FrameModel& model) {
  std::vector<PlacedElement> elements;
  int node = clamped;
  for (std::size_t n = 0; n < model.arcs.size(); ++n) {
    const BumpArc& arc = model.arcs[n];
    const int start = nodes_per_bump * static_cast<int>(n);
    if (n > 0) {
      elements.push_back({flat_element(arc.flat), node, start});
      node = start;
    } else if (model.weld_at == WeldPosition::mid_flat) {
      elements.push_back({flat_element(0.5 * arc.flat), clamped, start});
      node = start;
    }
    elements.push_back({rising_half(arc), node, start + 1});
    elements.push_back({falling_half(arc), start + 1, start + 2});
    node = start + 2;
  }
  return elements;
}

int bump_of(int node) {
  return node / nodes_per_bump;
}

int first_dof_of(int node) {
  return unknowns_per_node * (node % nodes_per_bump);
}

/// Displacements and rotations of the ends of an element.
ElementVector end_displacements(const FrameModel& model, const PlacedElement& placed, const Vector& x) {
  ElementVector ends = ElementVector::Zero();
  for (const auto& [node, row] : {std::pair{placed.start, 0}, std::pair{placed.end, 3}}) {
    if (node == clamped) continue;
    ends.segment<3>(row) = x.segment<3>(Eigen::Index{bump_of(node)} * frame_dofs().size + first_dof_of(node));
    ends[row + 2] /= model.pitch;
  }
  return ends;
}

}  // namespace

FrameModel make_frame_model(const Case& input) {
  const BumpFoil& foil = input.bump_foil;
  return {.section = make_section(foil.youngs_modulus, foil.poisson_ratio, input.bearing.axial_length, foil.thickness),
          .arcs = std::vector<BumpArc>(static_cast<std::size_t>(foil.bumps), make_bump_arc(foil)),
          .pitch = foil.pitch,
          .weld_at = foil.weld_at};
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

void assemble_frame(const FrameModel& model, BlockTridiagonal& K) {
  BUMPFOIL_ASSERT(K.block_size() == frame_dofs().size);
  BUMPFOIL_ASSERT(static_cast<std::size_t>(K.blocks()) == model.arcs.size());
  const ElementVector scale{{1.0, 1.0, 1.0 / model.pitch, 1.0, 1.0, 1.0 / model.pitch}};
  for (const PlacedElement& placed : place_elements(model)) {
    const ElementMatrix stiffness =
        scale.asDiagonal() * frame_element_stiffness(model.section, placed.element) * scale.asDiagonal();
    for (int i = placed.start == clamped ? 3 : 0; i < 6; ++i) {
      for (int j = i; j < 6; ++j) {
        const int node_i = i < 3 ? placed.start : placed.end;
        const int node_j = j < 3 ? placed.start : placed.end;
        K.add(bump_of(node_i), first_dof_of(node_i) + i % 3, bump_of(node_j), first_dof_of(node_j) + j % 3,
              stiffness(i, j));
      }
    }
  }
  if (model.weld_at == WeldPosition::arc_start) {
    for (int k = 0; k < unknowns_per_node; ++k) K.add(0, k, 0, k, model.section.axial_stiffness / model.pitch);
  }
}

FrameStress frame_stress(const FrameModel& model, const Vector& x) {
  const auto bumps = static_cast<Eigen::Index>(model.arcs.size());
  FrameStress stress{Vector::Zero(bumps), Vector::Zero(bumps), Vector::Zero(bumps), Vector::Zero(bumps), 0.0};
  for (const PlacedElement& placed : place_elements(model)) {
    const ElementForces forces = element_forces(model.section, placed.element, end_displacements(model, placed, x));
    const auto stress_at = [&](double s) {
      return std::abs(bending_moment(placed.element, forces, s)) / model.section.modulus;
    };
    if (placed.start == clamped) stress.weld = stress_at(-0.5);
    const int bump = bump_of(placed.end);
    switch (placed.end % nodes_per_bump) {
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
