#include "bumpfoil/structure/section.hpp"

namespace bumpfoil {

Section make_section(double youngs_modulus, double poisson_ratio, double axial_length, double thickness) {
  const double plate_modulus = youngs_modulus / (1.0 - poisson_ratio * poisson_ratio);
  Section section;
  section.bending_stiffness = plate_modulus * axial_length * thickness * thickness * thickness / 12.0;
  section.axial_stiffness = plate_modulus * axial_length * thickness;
  section.modulus = axial_length * thickness * thickness / 6.0;
  return section;
}

Section make_bump_section(const FoilDesign& foils, const BumpShape& bump) {
  return make_section(foils.youngs_modulus, foils.poisson_ratio, foils.bump_foil_width(), bump.thickness);
}

Section make_top_foil_section(const FoilDesign& foils) {
  const TopFoilDesign& top = foils.top_foil.value();
  return make_section(top.youngs_modulus, top.poisson_ratio, foils.axial_length, top.thickness);
}

}  // namespace bumpfoil
