#include "bumpfoil/model/geometry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace bumpfoil {
namespace {

/// The section of a foil that contains a bump (from 0); null if there is none.
template <typename Section>
const Section* section_of(const std::vector<Section>& sections, std::size_t bump) {
  const auto number = static_cast<int>(bump) + 1;
  const auto found = std::find_if(sections.begin(), sections.end(), [number](const Section& section) {
    return section.from <= number && number <= section.to;
  });
  return found == sections.end() ? nullptr : &*found;
}

/// kappa_0 R^2 of a seated foil over C_r: its bulge on a rigid sleeve is 0.63 C_r over the full circumference.
constexpr double clearances_of_seat = 6.0;

/// 1/R - 1/R_f, 1/m.
double flattening_of(const PadDesign& pad) {
  if (pad.bearing.is_flat() || pad.top_foil.formed_radius.to == FormedTo::bearing) return 0.0;
  return 1.0 / pad.bearing.radius - 1.0 / formed_radius(pad.top_foil.formed_radius, pad.bearing);
}

}  // namespace

double nominal_height(const BumpFoil& foil, std::size_t bump) {
  const double height = foil.height.at(bump, static_cast<std::size_t>(foil.bumps));
  const BumpSection* section = section_of(foil.sections, bump);
  return section != nullptr ? section->height.value_or(height) : height;
}

BumpShape nominal_bump(const BumpFoil& foil, std::size_t bump) {
  const auto bumps = static_cast<std::size_t>(foil.bumps);
  double pitch = foil.pitch.at(bump, bumps);
  double length = foil.length.at(bump, bumps);
  double thickness = foil.thickness.at(bump, bumps);
  if (const BumpSection* section = section_of(foil.sections, bump)) {
    pitch = section->pitch.value_or(pitch);
    length = section->length.value_or(length);
    thickness = section->thickness.value_or(thickness);
  }
  const double height = nominal_height(foil, bump);
  const bool overall = foil.height_reference == HeightReference::overall;
  return {.pitch = pitch,
          .half_length = 0.5 * length,
          .rise = overall ? height - thickness : height,
          .thickness = thickness};
}

std::vector<BumpShape> nominal_bumps(const BumpFoil& foil) {
  const auto bumps = static_cast<std::size_t>(foil.bumps);
  std::vector<BumpShape> shapes;
  shapes.reserve(bumps);
  for (std::size_t n = 0; n < bumps; ++n) shapes.push_back(nominal_bump(foil, n));
  return shapes;
}

Vector crest_offsets(const BumpFoil& foil) {
  const std::vector<BumpShape> bumps = nominal_bumps(foil);
  const auto height = [](const BumpShape& bump) { return bump.rise + bump.thickness; };
  const double tallest = height(*std::max_element(
      bumps.begin(), bumps.end(), [&](const BumpShape& a, const BumpShape& b) { return height(a) < height(b); }));
  Vector offsets(foil.bumps);
  for (std::size_t n = 0; n < bumps.size(); ++n) {
    double& offset = offsets[static_cast<Eigen::Index>(n)];
    offset = height(bumps[n]) - tallest;
    if (!foil.height_errors.empty()) offset += foil.height_errors[n];
    if (const Shim* shim = section_of(foil.shims, n)) offset += shim->thickness;
  }
  return offsets;
}

double deviation_at(const RadiusProfile& profile, double phi) {
  double sum = 0.0;
  for (const Waviness& waves : profile.waves) sum += waves.amplitude * std::cos(waves.harmonic * phi - waves.phase);
  if (profile.deviations.empty()) return sum;
  const std::size_t count = profile.deviations.size();
  const double turns = phi / (2.0 * std::numbers::pi);
  const double place = static_cast<double>(count) * (turns - std::floor(turns));
  const auto before = std::min(static_cast<std::size_t>(place), count - 1);  // round-off may yield a full turn
  const double first = profile.deviations[before];
  return sum + first + (profile.deviations[(before + 1) % count] - first) * (place - static_cast<double>(before));
}

double formed_radius(const FormedRadius& formed, const Bearing& bearing) {
  switch (formed.to) {
    case FormedTo::seated:
      return bearing.radius / (1.0 - clearances_of_seat * bearing.radial_clearance / bearing.radius);
    case FormedTo::radius:
      return formed.radius;
    case FormedTo::bearing:
      break;
  }
  return bearing.radius;
}

FoilDesign make_bearing_design(const PadDesign& pad) {
  const BumpFoil& foil = pad.bump_foil;
  const double gaps = (foil.strips - 1) * foil.strip_gap;
  FoilDesign foils{.model = foil.model,
                   .geometry = foil.geometry,
                   .bumps = nominal_bumps(foil),
                   .youngs_modulus = foil.youngs_modulus,
                   .poisson_ratio = foil.poisson_ratio,
                   .axial_length = pad.bearing.axial_length - (pad.top_foil.split ? gaps : 0.0),
                   .strip_gaps = pad.top_foil.split ? 0.0 : gaps,
                   .radius = pad.bearing.is_flat() ? std::nullopt : std::optional(pad.bearing.radius),
                   .welded = true,
                   .weld_at = foil.weld_at,
                   .truss = foil.truss,
                   .top_foil = {}};
  if (foil.stiffness_follows_height) {
    for (std::size_t n = 0; n < foil.height_errors.size(); ++n) foils.bumps[n].rise += foil.height_errors[n];
  }
  if (foil.model != BumpFoilModel::former) {
    foils.top_foil = {.thickness = pad.top_foil.thickness,
                      .youngs_modulus = pad.top_foil.youngs_modulus,
                      .poisson_ratio = pad.top_foil.poisson_ratio,
                      .overhang = pad.top_foil.overhang.value_or(0.5 * foils.bumps.back().pitch),
                      .stagger = pad.top_foil.split ? 0.0 : foil.most_stagger() * foils.bumps.back().pitch,
                      .flattening = flattening_of(pad),
                      .seat_pressure = pad.top_foil.seat_pressure.value_or(0.0)};
  }
  return foils;
}

bool is_formed(const PadDesign& pad) {
  return pad.bump_foil.model != BumpFoilModel::former &&
         (flattening_of(pad) != 0.0 || pad.top_foil.seat_pressure.value_or(0.0) != 0.0);
}

double strip_width(const PadDesign& pad) {
  const BumpFoil& foil = pad.bump_foil;
  return (pad.bearing.axial_length - (foil.strips - 1) * foil.strip_gap) / foil.strips;
}

double strip_middle(const PadDesign& pad, int strip) {
  return (strip - 0.5 * (pad.bump_foil.strips - 1)) * (strip_width(pad) + pad.bump_foil.strip_gap);
}

PadDesign cut_to(const PadDesign& whole, int bumps) {
  PadDesign cut = whole;
  BumpFoil& foil = cut.bump_foil;
  for (PerBump* dimension : {&foil.pitch, &foil.length, &foil.height, &foil.thickness}) {
    if (dimension->law) *dimension = listed(*dimension, static_cast<std::size_t>(foil.bumps));
  }
  foil.bumps = bumps;
  for (std::vector<double>* list : {&foil.height_errors, &foil.sleeve_gaps}) {
    if (!list->empty()) list->resize(static_cast<std::size_t>(bumps));
  }
  return cut;
}

FoilDesign make_strip_design(const PadDesign& whole, int bumps, StripWeld weld, bool top_foil) {
  FoilDesign foils = make_bearing_design(cut_to(whole, bumps));
  foils.radius.reset();
  foils.welded = weld == StripWeld::one_end;
  if (!top_foil) foils.top_foil.reset();
  return foils;
}

Vector crest_angles(const PadDesign& pad) {
  return crest_positions(make_bearing_design(pad)) / pad.bearing.radius;
}

Vector foot_angles(const PadDesign& pad) {
  return foot_positions(make_bearing_design(pad)) / pad.bearing.radius;
}

double foil_angle(const PadDesign& pad) {
  double length = 0.0;
  double last = 0.0;
  for (const BumpShape& bump : nominal_bumps(pad.bump_foil)) length += last = bump.pitch;
  if (pad.top_foil.overhang) length += *pad.top_foil.overhang - 0.5 * last;
  length += pad.bump_foil.most_stagger() * last;
  return length / pad.bearing.radius;
}

Vector sleeve_deviations(const PadDesign& pad, const Vector& theta) {
  const Bearing& bearing = pad.bearing;
  Vector deviations =
      polar_angles(bearing, theta).unaryExpr([&](double phi) { return deviation_at(bearing.sleeve, phi); });
  return deviations + bearing.taper / foil_angle(pad) * theta;
}

Vector polar_angles(const Bearing& bearing, const Vector& theta) {
  const double sigma = bearing.wrap == Wrap::clockwise ? -1.0 : 1.0;
  return bearing.weld_angle + sigma * theta.array();
}

Eigen::Vector2d unit_vector(double direction) {
  const double quarter_turns = direction / (0.5 * std::numbers::pi);
  const double nearest = std::round(quarter_turns);
  if (std::abs(quarter_turns - nearest) < 1e-14 * (1.0 + std::abs(nearest))) {
    const double quadrant = nearest - 4.0 * std::floor(nearest / 4.0);
    if (quadrant == 0.0) return {1.0, 0.0};
    if (quadrant == 1.0) return {0.0, 1.0};
    if (quadrant == 2.0) return {-1.0, 0.0};
    return {0.0, -1.0};
  }
  return {std::cos(direction), std::sin(direction)};
}

Eigen::Matrix2Xd outward_normals(const Vector& phi) {
  Eigen::Matrix2Xd normals(2, phi.size());
  for (Eigen::Index i = 0; i < phi.size(); ++i) normals.col(i) = unit_vector(phi[i]);
  return normals;
}

Vector journal_gaps(double clearance, const Eigen::Matrix2Xd& normals, const Eigen::Vector2d& position) {
  return clearance - (normals.transpose() * position).array();
}

Eigen::Vector2d journal_force(const Eigen::Matrix2Xd& normals, const Vector& journal_loads) {
  return normals * journal_loads;
}

}  // namespace bumpfoil
