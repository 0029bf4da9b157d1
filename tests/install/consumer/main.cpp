// A user's project: the library is all that it knows.
#include <bumpfoil/core/version.hpp>
#include <bumpfoil/model/case.hpp>
#include <bumpfoil/model/geometry.hpp>
#include <cmath>
#include <iostream>

int main() {
  const bumpfoil::Case bearing = bumpfoil::reference_case();
  const bumpfoil::Vector theta = bumpfoil::crest_angles(bearing);
  std::cout << "bumpfoil " << bumpfoil::version() << ", " << theta.size() << " bumps\n";
  // The crest of the first bump stands half a pitch from the weld.
  const double expected = 0.5 * bearing.bump_foil.pitch / bearing.bearing.radius;
  return theta.size() == 26 && std::abs(theta[0] - expected) < 1e-15 ? 0 : 1;
}
