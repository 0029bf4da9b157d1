#include "bumpfoil/structure/frame.hpp"

#include <algorithm>
#include <cmath>

#include "bumpfoil/core/assert.hpp"

namespace bumpfoil {
namespace {

constexpr int unknowns_per_node = 3;
constexpr Eigen::Index clamped = -1;

CorotationalElement make_element(const Section& section, const FrameElement& element) {
  return make_corotational_element(element.chord, frame_element_stiffness(section, element));
}

/// The half flats after bump n - 1 and before bump n.
CorotationalElement flat_before(const FrameModel& model, std::size_t n) {
  const FrameElement first = flat_element(0.5 * model.arcs[n - 1].flat);
  const FrameElement second = flat_element(0.5 * model.arcs[n].flat);
  const FrameElement whole{first.chord + second.chord, 0.0};
  if (model.sections[n - 1] == model.sections[n]) return make_element(model.sections[n], whole);
  return make_corotational_element(whole.chord,
                                   stiffness_in_series(frame_element_stiffness(model.sections[n - 1], first),
                                                       frame_element_stiffness(model.sections[n], second)));
}

/// An element with the forces at its displacements.
class LoadedElement {
 public:
  /// @param unknowns  of its ends, as scaled by frame_dofs()
  LoadedElement(const FrameModel& model, const Section& section, const FrameElement& element, ElementVector unknowns)
      : element_(element), modulus_(section.modulus) {
    unknowns[2] /= model.rotation_scale;
    unknowns[5] /= model.rotation_scale;
    if (model.geometry == Geometry::nonlinear) unknowns = chord_deformations(element.chord, unknowns);
    forces_ = element_forces(section, element, unknowns);
  }

  [[nodiscard]] double stress(double s) const { return std::abs(bending_moment(element_, forces_, s)) / modulus_; }
  [[nodiscard]] double largest_stress() const { return largest_moment(element_, forces_) / modulus_; }

 private:
  FrameElement element_;
  double modulus_;
  ElementForces forces_;
};

}  // namespace

FrameModel make_frame_model(const FoilDesign& foils) {
  FrameModel model{.arcs = {},
                   .sections = {},
                   .rotation_scale = foils.reference_length(),
                   .weld_at = foils.weld_at,
                   .geometry = foils.geometry,
                   .welded = foils.welded};
  for (const BumpShape& bump : foils.bumps) {
    model.arcs.push_back(make_bump_arc(bump));
    model.sections.push_back(make_bump_section(foils, bump));
    BUMPFOIL_ASSERT(model.arcs.back().rise > 0.0);
  }
  return model;
}

BumpDofs frame_dofs() {
  return {.size = 11, .crest_u = 3, .crest_v = 4, .foot_u = {0, 6}, .foot_v = {1, 7}, .top_u = 9, .top_moment = 10};
}

ElementChain place_elements(const FrameModel& model, int block_size) {
  ElementChain chain{.rotation_scale = model.rotation_scale, .elements = {}};
  Eigen::Index node = clamped;
  for (std::size_t n = 0; n < model.arcs.size(); ++n) {
    const BumpArc& arc = model.arcs[n];
    const Section& section = model.sections[n];
    const Eigen::Index start = static_cast<Eigen::Index>(n) * block_size;
    const Eigen::Index crest = start + unknowns_per_node;
    const Eigen::Index end = crest + unknowns_per_node;
    if (n > 0) {
      chain.elements.push_back({flat_before(model, n), node, start});
      node = start;
    } else if (!model.welded) {
      node = start;
    } else if (model.weld_at == WeldPosition::mid_flat) {
      chain.elements.push_back({make_element(section, flat_element(0.5 * arc.flat)), clamped, start});
      node = start;
    }
    chain.elements.push_back({make_element(section, rising_half(arc)), node, crest});
    chain.elements.push_back({make_element(section, falling_half(arc)), crest, end});
    node = end;
  }
  return chain;
}

void hold_covered_node(const FrameModel& model, BlockTridiagonal& K) {
  if (!model.welded || model.weld_at != WeldPosition::arc_start) return;
  const double stiffness = model.sections.front().axial_stiffness / model.rotation_scale;
  for (int k = 0; k < unknowns_per_node; ++k) K.add(0, k, 0, k, stiffness);
}

void assemble_frame(const FrameModel& model, BlockTridiagonal& K) {
  BUMPFOIL_ASSERT(K.block_size() == frame_dofs().size);
  BUMPFOIL_ASSERT(static_cast<std::size_t>(K.blocks()) == model.arcs.size());
  add_corotational_tangent(place_elements(model, K.block_size()), Vector::Zero(K.rows()), K);
  hold_covered_node(model, K);
}

FrameStress frame_stress(const FrameModel& model, const Vector& x) {
  const auto bumps = static_cast<Eigen::Index>(model.arcs.size());
  FrameStress stress{Vector(bumps), Vector(bumps), Vector(bumps), Vector(bumps), 0.0};
  const bool starts_clamped = model.welded && model.weld_at == WeldPosition::arc_start;
  const Eigen::Index block_size = frame_dofs().size;
  for (Eigen::Index n = 0; n < bumps; ++n) {
    const BumpArc& arc = model.arcs[static_cast<std::size_t>(n)];
    const Section& section = model.sections[static_cast<std::size_t>(n)];
    ElementVector ends = x.segment<6>(n * block_size);
    if (n == 0 && starts_clamped) ends.head<3>().setZero();
    const LoadedElement rising(model, section, rising_half(arc), ends);
    const LoadedElement falling(model, section, falling_half(arc), x.segment<6>(n * block_size + unknowns_per_node));
    stress.arc_start[n] = rising.stress(-0.5);
    stress.crest[n] = rising.stress(0.5);
    stress.arc_end[n] = falling.stress(0.5);
    stress.largest[n] = std::max(rising.largest_stress(), falling.largest_stress());
    if (n == 0 && starts_clamped) {
      stress.weld = stress.arc_start[0];
    } else if (n == 0 && model.welded) {
      ElementVector flat_ends = ElementVector::Zero();
      flat_ends.tail<3>() = ends.head<3>();
      // The stress in a flat is largest at its ends, which are the weld or ends of arcs.
      stress.weld = LoadedElement(model, section, flat_element(0.5 * arc.flat), flat_ends).stress(-0.5);
    }
  }
  return stress;
}

}  // namespace bumpfoil
