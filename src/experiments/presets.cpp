#include "case/presets.hpp"

#include <numbers>

#include "bumpfoil/experiments/cycle/cycle_settings.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium_settings.hpp"
#include "bumpfoil/experiments/reference_case.hpp"
#include "bumpfoil/experiments/strip/strip_settings.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view assumed = "assumed";
constexpr std::string_view as_reference = "assumed, as in gen1";
constexpr double pi = std::numbers::pi;

constexpr std::string_view rubio_head =
    R"(# Foil bearing of Rubio & San Andres, J. Eng. Gas Turbines Power 128 (2006) 653-660: size, foils and modulus.
# Other values are marked as assumed.
#
)";

constexpr std::string_view larsen_head =
    R"(# Strip of foils between plates of Larsen, Varela & Santos, Tribology International 74 (2014) 46-56, for the command
# strip: foils, modulus and width. Other values are marked as assumed.
#
)";

/// [Rubio2006], completed with assumed values.
Preset rubio() {
  Preset preset{.name = "gen1-rubio",
                .head = rubio_head,
                .input = reference_case(),
                .remarks = {{"bearing.radial_clearance", assumed},
                            {"bearing.weld_angle", assumed},
                            {"bearing.wrap", assumed},
                            {"bump_foil.height_reference", assumed},
                            {"bump_foil.poisson_ratio", assumed},
                            {"bump_foil.weld_at", assumed},
                            {"top_foil.thickness", "assumed, as that of the bump foil"},
                            {"top_foil.youngs_modulus", assumed},
                            {"top_foil.poisson_ratio", assumed},
                            {"friction.coefficient", assumed},
                            {"cycle.directions", assumed},
                            {"cycle.amplitude", assumed}}};
  preset.input.title = "First-generation bearing, Rubio & San Andres 2006";
  BumpFoil& foil = preset.input.bump_foil;
  foil.bumps = 25;
  foil.pitch = 4.581e-3;
  foil.length = 4.064e-3;
  foil.height = 0.381e-3;
  foil.youngs_modulus = 213e9;
  preset.input.top_foil.youngs_modulus = 213e9;
  preset.input.settings.get<CycleSettings>().amplitude.value = 63.6e-6;
  return preset;
}

/// [Larsen2014], completed with assumed values.
Preset larsen() {
  Preset preset{.name = "larsen-strip",
                .head = larsen_head,
                .input = reference_case(),
                .remarks = {{"bump_foil.model", "no truss can be identified for these bumps, its k2 would be negative"},
                            {"bump_foil.bumps", "assumed"},
                            {"bump_foil.poisson_ratio", assumed},
                            {"bump_foil.weld_at", assumed},
                            {"top_foil.youngs_modulus", assumed},
                            {"top_foil.poisson_ratio", assumed},
                            {"friction.coefficient", assumed},
                            {"strip.bumps", assumed},
                            {"strip.weld", assumed},
                            {"strip.displacement", assumed},
                            {"strip.cycles", assumed}}};
  Case& input = preset.input;
  input.title = "Strip of bump foil between plates, Larsen, Varela & Santos 2014";
  input.bearing = {.axial_length = 53e-3};
  BumpFoil& foil = input.bump_foil;
  foil.model = BumpFoilModel::frame;
  foil.bumps = 10;
  foil.pitch = 7e-3;
  foil.length = 6.6e-3;
  foil.height = 0.9e-3;
  foil.height_reference = HeightReference::midsurface;
  foil.thickness = 0.127e-3;
  foil.youngs_modulus = 207e9;
  foil.poisson_ratio = 0.3;
  input.top_foil = {.thickness = 0.254e-3, .youngs_modulus = 207e9, .poisson_ratio = 0.3};
  input.settings.remove<CycleSettings>();
  input.settings.set(StripSettings{.bumps = 10, .amplitude = {.value = 20e-6}, .cycles = 2});
  return preset;
}

constexpr std::string_view three_pads_head =
    R"(# Illustration of a third-generation foil bearing: three pads, each with its own top foil and bump foil, welded at one
# edge and free at the other, and offset towards the journal. This is not a published bearing: its sizes are those of
# the first-generation reference bearing, and what makes it a bearing of three pads is assumed, as marked.
#
)";

/// Not from a paper: the reference bearing divided into three pads.
Preset three_pads() {
  Preset preset{.name = "gen3-three-pad",
                .head = three_pads_head,
                .input = reference_case(),
                .remarks = {{"bearing.radius", as_reference},
                            {"bearing.axial_length", as_reference},
                            {"bearing.radial_clearance", as_reference},
                            {"bearing.weld_angle", "assumed; pad 1 starts here"},
                            {"bearing.wrap", assumed},
                            {"bearing.pad_gap", assumed},
                            {"bump_foil.bumps", "assumed; of each pad"},
                            {"bump_foil.pitch", as_reference},
                            {"bump_foil.length", as_reference},
                            {"bump_foil.height", as_reference},
                            {"bump_foil.thickness", as_reference},
                            {"bump_foil.youngs_modulus", as_reference},
                            {"bump_foil.poisson_ratio", as_reference},
                            {"bump_foil.weld_at", assumed},
                            {"top_foil.thickness", as_reference},
                            {"top_foil.youngs_modulus", as_reference},
                            {"top_foil.poisson_ratio", as_reference},
                            {"friction.coefficient", assumed},
                            {"cycle.directions", assumed},
                            {"cycle.amplitude", assumed}}};
  Case& input = preset.input;
  input.title = "Illustration of a third-generation bearing: three pads";
  input.bearing.pad_gap = pi / 18.0;
  input.bump_foil.bumps = 8;
  input.pads.resize(3);
  for (Pad& pad : input.pads) pad.lobe = 10e-6;
  input.settings.get<CycleSettings>().amplitude.value = 60e-6;
  preset.remarks.insert(preset.remarks.end(), {{"pad[1].weld_edge", assumed},
                                               {"pad[1].lobe", assumed},
                                               {"pad[2].weld_edge", assumed},
                                               {"pad[2].lobe", assumed},
                                               {"pad[3].weld_edge", assumed},
                                               {"pad[3].lobe", assumed}});
  return preset;
}

constexpr std::string_view three_strips_head =
    R"(# Illustration of a second-generation foil bearing: a bump foil that is split over the width into three strips, of which
# the middle one is staggered by half a pitch, under a whole top foil. This is not a published bearing: its sizes are
# those of the first-generation reference bearing with one bump less, and what makes it one of strips is assumed, as
# marked.
#
)";

/// Not from a paper: the reference bearing with its bump foil split into three strips.
Preset three_strips() {
  Preset preset{.name = "gen2-three-strips",
                .head = three_strips_head,
                .input = reference_case(),
                .remarks = {{"bearing.radius", as_reference},
                            {"bearing.axial_length", as_reference},
                            {"bearing.radial_clearance", as_reference},
                            {"bearing.weld_angle", as_reference},
                            {"bearing.wrap", as_reference},
                            {"bump_foil.bumps", "assumed; of each strip, with room for the stagger"},
                            {"bump_foil.pitch", as_reference},
                            {"bump_foil.length", as_reference},
                            {"bump_foil.height", as_reference},
                            {"bump_foil.thickness", as_reference},
                            {"bump_foil.youngs_modulus", as_reference},
                            {"bump_foil.poisson_ratio", as_reference},
                            {"bump_foil.strips", assumed},
                            {"bump_foil.strip_gap", assumed},
                            {"bump_foil.weld_at", assumed},
                            {"top_foil.thickness", as_reference},
                            {"top_foil.youngs_modulus", as_reference},
                            {"top_foil.poisson_ratio", as_reference},
                            {"friction.coefficient", assumed},
                            {"cycle.directions", assumed},
                            {"cycle.amplitude", assumed}}};
  Case& input = preset.input;
  input.title = "Illustration of a second-generation bearing: three strips";
  input.bump_foil.bumps = 25;
  input.bump_foil.strips = 3;
  input.bump_foil.strip_gap = 2e-3;
  input.bump_foil.strip.resize(3);
  input.bump_foil.strip[1].stagger = 0.5;
  input.width.modes = 3;
  preset.remarks.insert(preset.remarks.end(), {{"bump_foil.strip[1].stagger", assumed},
                                               {"bump_foil.strip[2].stagger", assumed},
                                               {"bump_foil.strip[3].stagger", assumed}});
  return preset;
}

constexpr std::string_view running_head =
    R"(# The bearing of Arghir & Benchekroun 2019 running in air, loaded towards +X by its rotor, for the command equilibrium.
# The paper has no film: speed and loads are assumed.
#
)";

/// The reference bearing in operation.
Preset running() {
  Preset preset{.name = "running",
                .head = running_head,
                .input = reference_case(),
                .remarks = {{"bearing.weld_angle", "the loads point away from the weld"},
                            {"top_foil.formed_radius", "a foil formed exactly to the bearing flutters at its free end"},
                            {"equilibrium.speeds", "here against the foil direction"}}};
  Case& input = preset.input;
  input.title = "First-generation bearing, running in air";
  input.top_foil.formed_radius = {FormedTo::seated};
  input.settings.remove<CycleSettings>();
  input.settings.set(EquilibriumSettings{.speeds = {45000.0 * (2.0 * pi / 60.0)},
                                         .loads = {{10.0, 0.0}, {20.0, 0.0}, {50.0, 0.0}, {100.0, 0.0}}});
  return preset;
}

}  // namespace

Case reference_case() {
  Case reference;
  reference.title = "First-generation bearing, Arghir & Benchekroun 2019, Table 1";
  reference.bearing.radius = 19.05e-3;
  reference.bearing.axial_length = 38.1e-3;
  reference.bearing.radial_clearance = 31.8e-6;
  BumpFoil& foil = reference.bump_foil;
  foil.bumps = 26;
  foil.pitch = 4.572e-3;
  foil.length = 3.556e-3;
  foil.height = 0.508e-3;
  foil.thickness = 0.102e-3;
  foil.youngs_modulus = 214e9;
  foil.poisson_ratio = 0.29;
  reference.top_foil = {.thickness = 0.102e-3, .youngs_modulus = 214e9, .poisson_ratio = 0.29};
  reference.friction = {.top_bump = 0.1, .bump_sleeve = 0.1};
  reference.settings.set(CycleSettings{.directions = {0.0, pi, 0.5 * pi, 1.5 * pi}, .amplitude = {.value = 79.5e-6}});
  return reference;
}

const std::vector<Preset>& presets() {
  static const std::vector<Preset> all{{.name = "gen1", .head = {}, .input = reference_case(), .remarks = {}},
                                       rubio(),
                                       three_strips(),
                                       three_pads(),
                                       larsen(),
                                       running()};
  return all;
}

}  // namespace bumpfoil
