#include "readers/foil_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

namespace bumpfoil {
namespace {

/// Number of points of an arc on either side of its crest, and of the journal over a pad.
constexpr int half_arc_points = 4;
constexpr std::size_t journal_arc_points = 73;
/// Number of lines over the width of foils that vary without a film.
constexpr int dry_lines = 9;

/// Fields from which shapes are built, and the last dimension of each.
constexpr std::array<std::pair<std::string_view, std::string_view>, 29> used_fields{{
    {"film_thickness", "column"},
    {"pressure", "column"},
    {"film_top_displacement", "column"},
    {"film_top_slope", "column"},
    {"film_top_parabola", "column"},
    {"top_displacement", "bump"},
    {"top_slope", "bump"},
    {"top_parabola", "bump"},
    {"crest_u", "bump"},
    {"crest_v", "bump"},
    {"crest_u_slope", "bump"},
    {"crest_v_slope", "bump"},
    {"crest_u_parabola", "bump"},
    {"crest_v_parabola", "bump"},
    {"foot_u", "foot"},
    {"foot_v", "foot"},
    {"foot_u_slope", "foot"},
    {"foot_v_slope", "foot"},
    {"foot_u_parabola", "foot"},
    {"foot_v_parabola", "foot"},
    {"gap_journal_top", "bump"},
    {"gap_top_bump", "bump"},
    {"normal_force_journal_top", "bump"},
    {"normal_force_top_bump", "bump"},
    {"normal_force_bump_sleeve", "foot"},
    {"friction_force_top_bump", "bump"},
    {"friction_force_bump_sleeve", "foot"},
    {"state_top_bump", "bump"},
    {"state_bump_sleeve", "foot"},
}};

}  // namespace

FoilShapes::FoilShapes(const NetcdfImage& image) : image_(image) {
  const auto found = image.variables().find("x");
  if (found == image.variables().end()) image.refuse("x", "is missing: there is no journal to draw");
  const std::vector<std::string>& states = found->second.dims;
  for (const auto& [name, variable] : image.variables()) {
    const bool of_states =
        variable.dims.size() >= states.size() && std::equal(states.begin(), states.end(), variable.dims.begin());
    if (!of_states) continue;
    std::vector<double> values = image.numbers(variable);
    // Variables over the width exist only if the foils vary there.
    const bool over_width = name.ends_with("_slope") || name.ends_with("_parabola");
    if (over_width && std::none_of(values.begin(), values.end(), [](double one) { return std::isfinite(one); }))
      continue;
    fields_[name] = std::move(values);
    widths_[name] = 1;
    for (std::size_t i = states.size(); i < variable.dims.size(); ++i) widths_[name] *= variable.extents[i];
  }
  for (const auto& [name, node] : used_fields) {
    const auto field = image.variables().find(std::string(name));
    if (field != image.variables().end() && field->second.dims.back() != node)
      image.refuse(name, "is over other places");
  }
  // Without a film, all states have the same tilt.
  const auto of_states = [this](const std::string& name) {
    if (has(name)) return fields_.at(name);
    return std::vector<double>(x_.size(), image_.variables().contains(name) ? constant(name).front() : 0.0);
  };
  x_ = fields_.at("x");
  y_ = of_states("y");
  tilt_x_ = of_states("tilt_x");
  tilt_y_ = of_states("tilt_y");
  radius_ = constant("bearing_radius").front();
  clearance_ = constant("radial_clearance").front();
  half_foil_ = half_width_ = 0.5 * constant("axial_length").front();
  if (image_.variables().contains("conicity"))
    profile_ = {.conicity = constant("conicity").front(), .crowning = constant("crowning").front()};
  bumps_ = nodes("", "bump");
  feet_ = nodes("foot_", "foot");
  if (has("pressure")) {
    columns_ = nodes("column_", "column");
    const std::vector<double> z = constant("z");
    if (image_.variables().contains("pad_z")) half_foil_ = z.back();
    for (std::size_t row = 0; row < z.size(); ++row) rows_.emplace_back(z[row], row);
    // Results on half the width are mirrored.
    if (z.front() >= 0.0) {
      for (std::size_t row = 0; row < z.size(); ++row) {
        if (z[row] > 0.0) rows_.emplace_back(-z[row], row);
      }
    }
    std::sort(rows_.begin(), rows_.end());
  }
  if (columns_.empty() && has_curved_top()) {
    for (int line = 0; line < dry_lines; ++line)
      rows_.emplace_back(half_width_ * (2.0 * line / (dry_lines - 1) - 1.0), 0);
  }
  rises_ = per_bump("bump_rise");
  half_lengths_ = per_bump("bump_half_length");
  height_errors_ = per_bump("height_error");
  make_pads();
}

/// A scalar for all states, or one number per node.
std::vector<double> FoilShapes::constant(const std::string& name) const {
  const auto found = image_.variables().find(name);
  if (found == image_.variables().end()) image_.refuse(name, "is missing");
  std::vector<double> values = image_.numbers(found->second);
  if (values.empty()) image_.refuse(name, "is empty");
  return values;
}

std::vector<double> FoilShapes::per_bump(const std::string& name) const {
  std::vector<double> values = constant(name);
  values.resize(bumps_.size(), values.back());
  return values;
}

std::vector<FoilShapes::Node> FoilShapes::nodes(const std::string& prefix, const std::string& dimension) const {
  const std::vector<double> along = image_.numbers(image_.variable(prefix + "theta", {dimension}));
  const std::vector<double> polar = image_.numbers(image_.variable(prefix + "phi", {dimension}));
  const auto found = image_.variables().find(dimension + "_pad");
  std::vector<double> pads(along.size(), 1.0);
  if (found != image_.variables().end()) pads = image_.numbers(image_.variable(found->first, {dimension}));
  std::vector<Node> all;
  for (std::size_t i = 0; i < along.size(); ++i) {
    if (!(pads[i] >= 1.0 && pads[i] <= static_cast<double>(along.size()))) image_.refuse(found->first, "is no pad");
    all.push_back({along[i], polar[i], static_cast<std::size_t>(pads[i]) - 1});
  }
  return all;
}

void FoilShapes::make_pads() {
  if (bumps_.empty()) image_.refuse("bump", "is empty");
  const bool several = image_.variables().contains("pad_lobe");
  const std::vector<double> lobes = several ? constant("pad_lobe") : std::vector<double>{0.0};
  const std::vector<double> welds = several ? constant("pad_weld_angle") : std::vector<double>{};
  const std::vector<double> ends = several ? constant("pad_end_angle") : std::vector<double>{};
  const std::vector<double> middles =
      image_.variables().contains("pad_z") ? constant("pad_z") : std::vector<double>(lobes.size(), 0.0);
  if (middles.size() != lobes.size()) image_.refuse("pad_z", "is over other places");
  pads_.resize(lobes.size());
  const auto collect = [&](const std::vector<Node>& all, std::vector<std::size_t> ShapedPad::*members) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i].pad >= pads_.size()) image_.refuse("pad", "has too few entries");
      (pads_[all[i].pad].*members).push_back(i);
    }
  };
  collect(bumps_, &ShapedPad::bumps);
  collect(feet_, &ShapedPad::feet);
  collect(columns_, &ShapedPad::columns);
  for (std::size_t k = 0; k < pads_.size(); ++k) {
    ShapedPad& pad = pads_[k];
    pad.lobe = lobes[k];
    pad.z = middles[k];
    if (pad.bumps.empty() || pad.feet.empty()) image_.refuse("pad", "has one without bumps");
    // Two positions less than half a turn apart determine the foil direction.
    const Node& crest = bumps_[pad.bumps.front()];
    const Node& foot = feet_[pad.feet.front()];
    pad.sense = std::sin(foot.polar - crest.polar) * std::sin(foot.along - crest.along) < 0.0 ? -1.0 : 1.0;
    pad.weld = crest.polar - pad.sense * crest.along;
    if (several) {
      constexpr double circle = 2.0 * std::numbers::pi;
      pad.middle = welds[k] + 0.5 * pad.sense * std::fmod(pad.sense * (ends[k] - welds[k]) + circle, circle);
    }
    const Node& last = bumps_[pad.bumps.back()];
    const double pitch = pad.bumps.size() > 1 ? last.along - bumps_[pad.bumps[pad.bumps.size() - 2]].along : 0.0;
    pad.length = pad.columns.empty() ? last.along + 0.5 * pitch : columns_[pad.columns.back()].along;
  }
}

double FoilShapes::sleeve_radius() const {
  return radius_ + *std::max_element(rises_.begin(), rises_.end());
}

bool FoilShapes::is_reached(std::size_t state) const {
  const char* const shape = columns_.empty() ? "top_displacement" : "film_thickness";
  return std::isfinite(x_[state]) && std::isfinite(y_[state]) && (!has(shape) || std::isfinite(at(shape, state, 0)));
}

double FoilShapes::at(const std::string& name, std::size_t state, std::size_t node) const {
  return fields_.at(name)[state * widths_.at(name) + node];
}

std::map<std::string, double> FoilShapes::numbers_of(std::size_t state) const {
  std::map<std::string, double> numbers;
  for (const auto& [name, width] : widths_) {
    if (width == 1) numbers[name] = at(name, state, 0);
  }
  return numbers;
}

double FoilShapes::journal_radius(std::size_t state, double polar, double z) const {
  return radius_ - clearance_ - profile_.widening(z / half_width_) +
         (x_[state] + tilt_x_[state] * z) * std::cos(polar) + (y_[state] + tilt_y_[state] * z) * std::sin(polar);
}

/// Value at a point of the film; a field uniform over the width has one per column.
double FoilShapes::film_at(const std::string& name, std::size_t state, std::size_t row, std::size_t column) const {
  const bool over_rows = widths_.at(name) > columns_.size();
  return at(name, state, over_rows ? row * columns_.size() + column : column);
}

/// A displacement `stem` + `mean` that may vary over the width.
double FoilShapes::across(const std::string& stem, const std::string& mean, std::size_t state, std::size_t node,
                          double z) const {
  const double zeta = z / half_foil_;
  const auto part = [&](const std::string& name) { return has(name) ? at(name, state, node) : 0.0; };
  return part(stem + mean) + part(stem + "_slope") * zeta + part(stem + "_parabola") * (1.5 * zeta * zeta - 0.5);
}

/// Lines along the foils at positions over the width. @param line  (z) -> its points
template <typename Line>
ShapedGrid FoilShapes::over_width(ShapedPart part, const ShapedPad& pad, bool varies, const Line& line) const {
  ShapedGrid grid{.part = part, .points = {}};
  const auto add = [&](double z) {
    std::vector<ShapedPoint> points = line(z);
    grid.columns = points.size();
    for (ShapedPoint& point : points) {
      point.z = pad.z + z;
      grid.points.push_back(point);
    }
  };
  if (varies) {
    for (const auto& [z, row] : rows_) add(z);
  } else {
    for (const double z : {-half_foil_, half_foil_}) add(z);
  }
  return grid;
}

ShapedGrid FoilShapes::top_foil_of_film(std::size_t state, const ShapedPad& pad) const {
  ShapedGrid grid{.part = ShapedPart::top_foil, .columns = pad.columns.size(), .points = {}};
  for (const auto& [z, row] : rows_) {
    for (const std::size_t column : pad.columns) {
      const double thickness = film_at("film_thickness", state, row, column);
      grid.points.push_back({.along = columns_[column].along,
                             .radius = journal_radius(state, columns_[column].polar, pad.z + z) + thickness,
                             .z = pad.z + z,
                             .outward = across("film_top", "_displacement", state, column, z),
                             .film_thickness = thickness,
                             .pressure = film_at("pressure", state, row, column)});
    }
  }
  return grid;
}

/// Radius of the undeflected top foil of a pad.
double FoilShapes::undeformed_radius(const ShapedPad& pad, double polar) const {
  return radius_ - pad.lobe * std::cos(polar - pad.middle);
}

/// The top foil over a crest. The stored gap is the minimum over the width: if it varies, the deflection is used
/// instead.
ShapedPoint FoilShapes::top_over_bump(std::size_t state, const ShapedPad& pad, std::size_t bump, double z) const {
  const Node& crest = bumps_[bump];
  const double journal = journal_radius(state, crest.polar, z);
  const double outward = across("top", "_displacement", state, bump, z);
  const double gap =
      has_curved_top() ? undeformed_radius(pad, crest.polar) + outward - journal : at("gap_journal_top", state, bump);
  return {.along = crest.along, .radius = journal + gap, .outward = outward, .film_thickness = gap};
}

/// From the weld over the crests to the free end, which moves like the last crest.
ShapedGrid FoilShapes::top_foil_of_bumps(std::size_t state, const ShapedPad& pad) const {
  return over_width(ShapedPart::top_foil, pad, has_curved_top(), [&](double z) {
    std::vector<ShapedPoint> line;
    for (const std::size_t bump : pad.bumps) line.push_back(top_over_bump(state, pad, bump, z));
    ShapedPoint weld = line.front();
    weld.along = 0.0;
    weld.radius -= weld.outward;
    weld.outward = 0.0;
    ShapedPoint end = line.back();
    end.along = pad.length;
    for (ShapedPoint* const beyond : {&weld, &end}) {
      beyond->film_thickness = beyond->radius - journal_radius(state, pad.weld + pad.sense * beyond->along, z);
    }
    line.insert(line.begin(), weld);
    line.push_back(end);
    return line;
  });
}

double FoilShapes::crest_radius(std::size_t state, const ShapedPad& pad, std::size_t bump, double z) const {
  const double moved = across("crest_v", "", state, bump, z);
  if (!has("gap_top_bump") || has_curved_top()) {
    return undeformed_radius(pad, bumps_[bump].polar) - height_errors_[bump] + moved;
  }
  return middle_crest_radius(state, pad, bump) + moved - across("crest_v", "", state, bump, 0.0);
}

/// Crest radius in the mid-plane, below the top foil by the gap.
double FoilShapes::middle_crest_radius(std::size_t state, const ShapedPad& pad, std::size_t bump) const {
  const Node& crest = bumps_[bump];
  const double gap = at("gap_top_bump", state, bump);
  const double journal = journal_radius(state, crest.polar, pad.z);
  if (columns_.empty()) return journal + at("gap_journal_top", state, bump) + gap;
  const std::size_t column =
      *std::min_element(pad.columns.begin(), pad.columns.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(columns_[a].along - crest.along) < std::abs(columns_[b].along - crest.along);
      });
  return journal + film_at("film_thickness", state, rows_[rows_.size() / 2].second, column) + gap;
}

double FoilShapes::foot_radius(std::size_t state, const ShapedPad& pad, std::size_t bump, double foot_v) const {
  return crest_radius(state, pad, bump, 0.0) - across("crest_v", "", state, bump, 0.0) + height_errors_[bump] +
         rises_[bump] + foot_v;
}

ShapedGrid FoilShapes::bump_foil(std::size_t state, const ShapedPad& pad) const {
  return over_width(ShapedPart::bump_foil, pad, has("crest_v_slope") || has("crest_v_parabola"),
                    [&](double z) { return bump_foil_at(state, pad, z); });
}

/// From the weld through the arcs of all bumps, with flats in between.
std::vector<ShapedPoint> FoilShapes::bump_foil_at(std::size_t state, const ShapedPad& pad, double z) const {
  std::vector<ShapedPoint> line{{.along = 0.0, .radius = foot_radius(state, pad, pad.bumps.front(), 0.0)}};
  const bool two_feet = pad.feet.size() == 2 * pad.bumps.size();
  for (std::size_t i = 0; i < pad.bumps.size(); ++i) {
    const std::size_t bump = pad.bumps[i];
    const double rise = rises_[bump];
    const double arc_radius = (half_lengths_[bump] * half_lengths_[bump] + rise * rise) / (2.0 * rise);
    const double crest_u = across("crest_u", "", state, bump, z);
    const double crest_v = across("crest_v", "", state, bump, z);
    const double crest = crest_radius(state, pad, bump, z);
    for (int k = -half_arc_points; k <= half_arc_points; ++k) {
      // The first bump of a truss starts at the weld, without a foot.
      const bool start = k < 0;
      const bool held = !two_feet && start && i == 0;
      const std::size_t foot = held ? 0 : pad.feet[two_feet ? 2 * i + (start ? 0 : 1) : i - (start ? 1 : 0)];
      const double foot_u = held ? 0.0 : across("foot_u", "", state, foot, z);
      const double foot_v = held ? 0.0 : across("foot_v", "", state, foot, z);
      const double low = foot_radius(state, pad, bump, foot_v);
      const double distance = half_lengths_[bump] * k / half_arc_points;
      const double height = std::sqrt(arc_radius * arc_radius - distance * distance) - (arc_radius - rise);
      const double part = height / rise;
      const double forward = foot_u + part * (crest_u - foot_u);
      line.push_back({.along = bumps_[bump].along + (distance + forward) / radius_,
                      .radius = low + part * (crest - low),
                      .outward = foot_v + part * (crest_v - foot_v),
                      .forward = forward});
    }
  }
  return line;
}

/// Forces on the foils: on the top foil at the journal, on the bump foil at its crests and feet; in the mid-plane,
/// summed over the width.
std::vector<ShapedGrid> FoilShapes::contacts(std::size_t state, const ShapedPad& pad) const {
  std::vector<ShapedGrid> all;
  const auto add = [&](ShapedPart part, const std::string& name, const std::vector<std::size_t>& members,
                       double outward, const auto& place) {
    if (!has("normal_force_" + name)) return;
    ShapedGrid& grid = all.emplace_back(ShapedGrid{.part = part, .points = {}});
    for (const std::size_t i : members) {
      ShapedPoint point = place(i);
      point.z = pad.z;
      point.force_outward = outward * at("normal_force_" + name, state, i);
      point.force_forward = at("friction_force_" + name, state, i);
      point.contact = at("state_" + name, state, i);
      grid.points.push_back(point);
    }
  };
  add(ShapedPart::journal_top, "journal_top", pad.bumps, 1.0, [&](std::size_t bump) {
    const ShapedPoint top = top_over_bump(state, pad, bump, 0.0);
    return ShapedPoint{.along = top.along, .radius = top.radius, .outward = top.outward};
  });
  add(ShapedPart::top_bump, "top_bump", pad.bumps, 1.0, [&](std::size_t bump) {
    const double forward = at("crest_u", state, bump);
    return ShapedPoint{.along = bumps_[bump].along + forward / radius_,
                       .radius = crest_radius(state, pad, bump, 0.0),
                       .outward = across("crest_v", "", state, bump, 0.0),
                       .forward = forward};
  });
  const std::size_t per_bump = pad.feet.size() / pad.bumps.size();
  add(ShapedPart::bump_sleeve, "bump_sleeve", pad.feet, -1.0, [&](std::size_t foot) {
    const std::size_t bump =
        pad.bumps[std::min((foot - pad.feet.front()) / std::max<std::size_t>(1, per_bump), pad.bumps.size() - 1)];
    const double forward = at("foot_u", state, foot);
    const double outward = at("foot_v", state, foot);
    return ShapedPoint{.along = feet_[foot].along + forward / radius_,
                       .radius = foot_radius(state, pad, bump, outward),
                       .outward = outward,
                       .forward = forward};
  });
  return all;
}

std::vector<ShapedGrid> FoilShapes::foils(std::size_t state, const ShapedPad& pad) const {
  std::vector<ShapedGrid> all;
  if (!pad.columns.empty()) {
    all.push_back(top_foil_of_film(state, pad));
  } else if (has("gap_journal_top")) {
    all.push_back(top_foil_of_bumps(state, pad));
  }
  if (!has("crest_v")) return all;
  all.push_back(bump_foil(state, pad));
  for (ShapedGrid& grid : contacts(state, pad)) all.push_back(std::move(grid));
  return all;
}

ShapedGrid FoilShapes::journal(std::size_t state, const ShapedPad& pad) const {
  ShapedGrid grid{.part = ShapedPart::journal, .columns = journal_arc_points, .points = {}};
  for (const double z : {pad.z - half_foil_, pad.z + half_foil_}) {
    for (std::size_t k = 0; k < journal_arc_points; ++k) {
      const double along = pad.length * static_cast<double>(k) / (journal_arc_points - 1);
      const double polar = pad.weld + pad.sense * along;
      const double radius = journal_radius(state, polar, z);
      grid.points.push_back({.along = along, .radius = radius, .z = z, .outward = radius - (radius_ - clearance_)});
    }
  }
  return grid;
}

}  // namespace bumpfoil
