#pragma once

#include <vector>

#include "bumpfoil/structure/corotational.hpp"
#include "bumpfoil/structure/foil_structure.hpp"
#include "bumpfoil/structure/frame_element.hpp"
#include "bumpfoil/structure/section.hpp"

namespace bumpfoil {

/// Bump foil as a plane frame on a straight base: two exact circular-arc elements per bump, one straight element per
/// flat, nothing after the end of the last arc. A flat belongs half to the bump before it, half to the one after it.
struct FrameModel {
  std::vector<BumpArc> arcs;      ///< one per bump
  std::vector<Section> sections;  ///< one per bump: of its arc and of the half flats on both sides
  double rotation_scale{};        ///< m, see frame_dofs()
  WeldPosition weld_at{WeldPosition::mid_flat};
  Geometry geometry{Geometry::linear};
  bool welded{true};  ///< false: free at both ends, the start of the first arc is free
};

/// Frame of a bump foil.
FrameModel make_frame_model(const FoilDesign& foils);

/// Unknowns of a bump: u, v and rotation of arc start, crest and arc end; displacement and moment of the top foil.
/// Feet are the two arc ends. Each rotation (rad, positive from u to v) stands as rotation * reference_length()
/// (m), so that all of K is in N/m.
BumpDofs frame_dofs();

/// Elements of the foil between nodes whose unknowns begin each block, in the order of frame_dofs(): the flat before a
/// bump (none before the first where the weld covers it), then its two arcs, bump after bump.
/// @param block_size  unknowns per bump
ElementChain place_elements(const FrameModel& model, int block_size);

/// Where the weld clamps the start of the first arc, its three unknowns are kept, and no element is coupled to them:
/// this adds springs to the ground of stiffness EA' / rotation_scale. They stay zero, and a sleeve contact there is
/// closed without load for a gap of zero and open for a positive one. Elsewhere it adds nothing.
void hold_covered_node(const FrameModel& model, BlockTridiagonal& K);

/// Adds the undeformed bump foil, hold_covered_node() included, to K, whose blocks are those of frame_dofs().
void assemble_frame(const FrameModel& model, BlockTridiagonal& K);

/// Bending stress at the surfaces of the bump foil, |M| / W, Pa; one entry per bump.
struct FrameStress {
  Vector arc_start;
  Vector crest;
  Vector arc_end;
  Vector largest;  ///< anywhere along the two arcs of the bump
  double weld{};   ///< where the foil is clamped
};

/// Under large displacements the rigid motion of each element is taken off first.
/// @param x unknowns of the foil structure, blocks of frame_dofs()
FrameStress frame_stress(const FrameModel& model, const Vector& x);

}  // namespace bumpfoil
