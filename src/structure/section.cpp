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

}  // namespace bumpfoil
