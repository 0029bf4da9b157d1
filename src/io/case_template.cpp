#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bumpfoil/core/error.hpp"
#include "bumpfoil/io/case_writer.hpp"

namespace bumpfoil {
namespace {

constexpr std::string_view gen1 =
    R"toml(# Case file of Bumpfoil. Quantities are texts with a unit ("31.8 um", "214 GPa", "150 MN/m", "30 deg") or plain numbers
# in SI (m, Pa, N/m, rad). Lines that begin with # are comments; keys that are commented out show their default or an
# example.

title = "First-generation bearing, Arghir & Benchekroun 2019, Table 1"

[bearing]
radius = "19.05 mm"             # inner radius of the sleeve with the foils, R
axial_length = "38.1 mm"        # L
radial_clearance = "31.8 um"    # C_r, journal to undeformed top foil; zero or negative is interference
weld_angle = "180 deg"          # where the foils are welded, from the X axis towards Y
wrap = "clockwise"              # sense of the foils from the weld: "clockwise" or "counterclockwise"

[bump_foil]
model = "truss"                 # springs between crests and feet; or "frame": exact arcs and straight beams
bumps = 26
pitch = "4.572 mm"              # crest to crest along the foil
length = "3.556 mm"             # chord of a bump's arc; the rest of the pitch is flat
height = "0.508 mm"
height_reference = "overall"    # height over the sleeve with the foil's thickness, or "midsurface": rise of the mid-surface
thickness = "0.102 mm"
youngs_modulus = "214 GPa"
poisson_ratio = 0.29
# height_errors = ["5 um", "-3 um", ...]  # one per bump from the weld on, positive is taller
# height_errors_file = "heights.csv"      # instead: a file beside this one with the columns bump,height_error_m
# sleeve_gaps = ["0 um", "2 um", ...]     # one per bump, initial gap between its foot and the sleeve
weld_at = "mid_flat"            # clamped before bump 1 in the middle of a flat; frame only: "arc_start"

# Constants of the truss are identified from the shape of the foil. Any of them can be given instead.
# [bump_foil.truss]
# k1 = "150 MN/m"               # rods between crest and feet
# k2 = "5.43 MN/m"              # between neighbouring feet
# k3 = "1.36 MN/m"              # between neighbouring crests
# k4 = "11.25 MN/m"             # between the weld and the first crest
# theta_d = "15.83 deg"         # inclination of the rods

[top_foil]
thickness = "0.102 mm"
youngs_modulus = "214 GPa"      # default: that of the bump foil
poisson_ratio = 0.29            # default: that of the bump foil

[friction]
coefficient = 0.1               # for both interfaces of the bump foil; 0 for none
# top_bump = 0.1                # or one for each: with the top foil,
# bump_sleeve = 0.1             # and with the sleeve

# [solver]
# name = "newton"               # exact contact and friction; "events" follows the path from one change of contact to the
#                               # next; "uzawa" is the method of the 2019 paper, with the penalties below
# eps_alm = "100 MN/m"          # of the normal contacts
# eps_f = "10 GN/m"             # of sticking contacts
# eps_r = "1 TN/m"              # of the journal's contact
# tau_f = "0.1 nm"              # slip over which the friction force turns round

[cycle]                         # the journal is pushed from the centre and pulled back
directions = ["+X", "-X", "+Y", "-Y"]  # also angles, "37.5 deg"
amplitude = "79.5 um"           # 2.5 C_r
steps = 100                     # equal increments each way
)toml";

}  // namespace

std::vector<std::string> preset_names() {
  return {"gen1"};
}

std::string case_template(std::string_view preset) {
  if (preset == "gen1") return std::string(gen1);
  throw Error(ErrorKind::input, {{"", 0, "preset", std::string(preset), "is not known",
                                  fmt::format("use one of {}", fmt::join(preset_names(), ", "))}});
}

}  // namespace bumpfoil
