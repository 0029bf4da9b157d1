#include <gtest/gtest.h>

#include <string>

#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"
#include "support/fe_records.hpp"
#include "support/full_increment.hpp"

/// The frame against strips of solid elements: docs/verification/fe_strip.md.
namespace bumpfoil {
namespace {

Cycle press_frame(const FeStrip& fe) {
  Case input = reference_case();
  input.bump_foil.model = BumpFoilModel::frame;
  input.bump_foil.height_reference = HeightReference::midsurface;
  input.bump_foil.weld_at = WeldPosition::arc_start;
  input.bump_foil.geometry = fe.large_displacements ? Geometry::nonlinear : Geometry::linear;
  input.friction = {.top_bump = fe.friction_coefficient, .bump_sleeve = fe.friction_coefficient};
  input.settings.set(StripSettings{.bumps = fe.bumps,
                                   .top_foil = fe.top_foil,
                                   .amplitude = {.control = Control::displacement, .value = 20e-6},
                                   .steps = 20});
  return run_strip(input).cycles.front();
}

/// Relative deviations stated on the page, rounded up.
struct Bounds {
  double force{}, loads{}, loop{};
};

/// Ten bumps at friction 0.3 lock: the first carries eleven times its load without friction, and the smallest
/// difference in its stiffness is amplified along the strip.
bool locks(const FeStrip& fe) {
  return fe.bumps == 10 && fe.friction_coefficient > 0.2;
}

Bounds bounds_for(const FeStrip& fe) {
  if (locks(fe)) return {.force = 0.045, .loads = 0.1, .loop = 0.08};
  if (fe.large_displacements) return {.force = 0.015, .loads = 0.02, .loop = 0.06};
  return {.force = 0.015, .loads = 0.015, .loop = 0.06};
}

TEST(FeStrip, FrameIsWithinThePagesBounds) {
  int compared = 0;
  for (const FeStrip& fe : fe_strips()) {
    // The plate of CalculiX extends past the first crest towards the weld, where the top foil is bent most.
    if (fe.top_foil && !fe.contact_at_nodes) continue;
    const std::string name = std::to_string(fe.bumps) + " bumps, f = " + std::to_string(fe.friction_coefficient) +
                             (fe.top_foil ? ", top foil" : "") + (fe.large_displacements ? ", large" : ", small") +
                             (fe.contact_at_nodes ? ", at nodes" : "");
    const Cycle frame = press_frame(fe);
    ASSERT_TRUE(frame.converged()) << name;
    const Bounds bounds = bounds_for(fe);
    EXPECT_NEAR(frame.turning_point->max_force, fe.max_force, bounds.force * fe.max_force) << name;
    const FullIncrement pressed = turning_increment(frame);
    const Vector& loads = fe.top_foil ? pressed.journal_top.normal_force : pressed.top_bump.normal_force;
    for (Eigen::Index bump = 0; bump < fe.bumps; ++bump) {
      EXPECT_NEAR(loads[bump], fe.bump_loads[bump], bounds.loads * fe.bump_loads[bump])
          << name << ", bump " << bump + 1;
    }
    // For strips that lock, only exact contact gives a loop: the force of CalculiX jumps during unloading.
    if (fe.friction_coefficient > 0.0 && (fe.contact_at_nodes || !locks(fe))) {
      EXPECT_NEAR(*frame.loop_energy, fe.loop_energy, bounds.loop * fe.loop_energy) << name;
    }
    ++compared;
  }
  EXPECT_EQ(compared, 36);
}

}  // namespace
}  // namespace bumpfoil
