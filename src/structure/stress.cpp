#include "bumpfoil/structure/stress.hpp"

#include <cmath>

namespace bumpfoil {
namespace {

/// Weld moment from the moment and displacement at the first crest: the first row of T M + r = D' u.
double weld_moment(const StressModel& model, double first_displacement, double first_moment) {
  const TopFoilMoments& form = *model.top_foil;
  const double coupling = form.size() > 1 ? form.compliance_off[0] * first_moment : 0.0;
  return (form.inverse_sine[0] * first_displacement - coupling - model.weld_rotation) / form.compliance_diagonal[0];
}

}  // namespace

StressModel make_stress_model(const FoilDesign& foils) {
  StressModel model;
  model.dofs = make_bump_dofs(foils);
  model.first_bump = block_of_bump_1(foils);
  if (foils.model == BumpFoilModel::frame) model.bump_foil = make_frame_model(foils);
  if (foils.top_foil) {
    model.top_foil = make_top_foil_moments(foils);
    model.moment_scale = top_moment_scale(foils);
    model.top_section_modulus = make_top_foil_section(foils).modulus;
    if (foils.radius) model.weld_rotation = forming_rotations(make_top_foil_beam(foils), make_forming(foils))[0];
  }
  return model;
}

FoilStress foil_stress(const StressModel& model, const Vector& x) {
  FoilStress stress;
  const Eigen::Index size = model.dofs.size;
  const Eigen::Index first = model.first_bump * size;
  const Eigen::Index bumps = (x.size() - first) / size;
  if (model.top_foil) {
    const double factor = model.moment_scale / model.top_section_modulus;
    const Vector moments = x(Eigen::seqN(first + model.dofs.top_moment, bumps, size));
    stress.top_crest = factor * moments.cwiseAbs();
    if (model.top_foil->welded) {
      const double weld = weld_moment(model, x[model.dofs.top_u], model.moment_scale * moments[0]);
      stress.top_weld = std::abs(weld) / model.top_section_modulus;
    }
  }
  if (model.bump_foil) {
    const FrameStress frame = frame_stress(*model.bump_foil, x);
    stress.bump_crest = frame.crest;
    stress.bump_foot.resize(2 * bumps);
    stress.bump_foot(Eigen::seqN(0, bumps, 2)) = frame.arc_start;
    stress.bump_foot(Eigen::seqN(1, bumps, 2)) = frame.arc_end;
    stress.bump_largest = frame.largest;
    if (model.bump_foil->welded) stress.bump_weld = frame.weld;
  }
  return stress;
}

}  // namespace bumpfoil
