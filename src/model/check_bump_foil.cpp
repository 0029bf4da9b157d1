#include "model/check_bump_foil.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/model/validation.hpp"

namespace bumpfoil {
namespace {

/// A dimension of the bumps, general and per section.
struct BumpDimension {
  std::string_view name;
  PerBump BumpFoil::*all;
  std::optional<double> BumpSection::*own;
};
enum DimensionIndex : std::size_t { pitch, length, height, thickness };
constexpr std::array bump_dimensions{BumpDimension{"pitch", &BumpFoil::pitch, &BumpSection::pitch},
                                     BumpDimension{"length", &BumpFoil::length, &BumpSection::length},
                                     BumpDimension{"height", &BumpFoil::height, &BumpSection::height},
                                     BumpDimension{"thickness", &BumpFoil::thickness, &BumpSection::thickness}};

/// Which dimensions are usable at every bump.
using Usable = std::array<bool, bump_dimensions.size()>;

/// Checks the length of a list with one value per bump.
bool check_length_of_list(Checks& checks, const std::string& key, std::size_t values, int bumps) {
  if (bumps < 1) return false;
  return checks.require(std::cmp_equal(values, bumps), key, fmt::format("{} values", values),
                        fmt::format("there must be one value per bump, {} in all", bumps),
                        "give all of them, zeros included");
}

bool check_dimension(Checks& checks, const BumpFoil& foil, const BumpDimension& dimension, int bumps) {
  const std::string key = fmt::format("bump_foil.{}", dimension.name);
  const PerBump& all = foil.*dimension.all;
  bool right = !all.is_list() || check_length_of_list(checks, key, all.values.size(), bumps);
  const std::array<std::string_view, 2> ends{".start", ".end"};
  for (std::size_t i = 0; i < all.values.size(); ++i) {
    const double value = all.values[i];
    if (value >= length_range.least && value <= length_range.most) continue;  // avoids text in the usual case
    const std::string place = all.law ? std::string(ends.at(i)) : all.is_list() ? fmt::format("[{}]", i + 1) : "";
    right = checks.within(key + place, value, length_range) && right;
  }
  for (std::size_t i = 0; i < foil.sections.size(); ++i) {
    const std::optional<double>& own = foil.sections[i].*dimension.own;
    if (!own) continue;
    const std::string place = fmt::format("bump_foil.section[{}].{}", i + 1, dimension.name);
    right = checks.within(place, *own, length_range) && right;
  }
  return right;
}

/// Whether sections, named by their key, refer to existing bumps and do not overlap.
template <typename Section>
bool check_sections(Checks& checks, const std::string& key, const std::vector<Section>& sections, int bumps) {
  bool right = true;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const auto& [from, to] = std::pair{sections[i].from, sections[i].to};
    const std::string own = fmt::format("{}[{}]", key, i + 1);
    right =
        checks.require(from >= 1 && (bumps < 1 || from <= bumps), own + ".from", std::to_string(from),
                       "is not a bump of the foil", fmt::format("give a number from 1 to {}", std::max(bumps, 1))) &&
        checks.require(to >= from && (bumps < 1 || to <= bumps), own + ".to", std::to_string(to),
                       to < from ? "is before the first" : "is not a bump of the foil",
                       fmt::format("give a number from {} to {}", from, std::max(bumps, from))) &&
        right;
  }
  if (!right) return false;
  std::vector<std::size_t> order(sections.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return sections[a].from < sections[b].from; });
  for (std::size_t k = 1; k < order.size(); ++k) {
    const auto [first, second] = std::minmax(order[k - 1], order[k]);
    right = checks.require(sections[order[k - 1]].to < sections[order[k]].from,
                           fmt::format("{}[{}].from", key, second + 1), std::to_string(sections[second].from),
                           fmt::format("shares bumps with {}[{}]", key, first + 1), "give each bump once at most") &&
            right;
  }
  return right && bumps >= 1;
}

/// The key that gives the dimension of a bump (from 0).
std::string key_of_bump(const BumpFoil& foil, DimensionIndex index, std::size_t bump) {
  const BumpDimension& dimension = bump_dimensions.at(index);
  const auto number = static_cast<int>(bump) + 1;
  for (std::size_t i = 0; i < foil.sections.size(); ++i) {
    const BumpSection& section = foil.sections[i];
    if (section.from <= number && number <= section.to && section.*dimension.own) {
      return fmt::format("bump_foil.section[{}].{}", i + 1, dimension.name);
    }
  }
  return (foil.*dimension.all).is_list() ? fmt::format("bump_foil.{}[{}]", dimension.name, number)
                                         : fmt::format("bump_foil.{}", dimension.name);
}

/// Pitches along the circumference.
void check_pitches(Checks& checks, const BumpFoil& foil, const std::vector<BumpShape>& bumps, double radius) {
  const double circumference = turn * radius;
  const auto longest = std::max_element(bumps.begin(), bumps.end(),
                                        [](const BumpShape& a, const BumpShape& b) { return a.pitch < b.pitch; });
  if (!checks.require(longest->pitch <= 0.25 * circumference,
                      key_of_bump(foil, pitch, static_cast<std::size_t>(longest - bumps.begin())),
                      quantity(longest->pitch, "m"), "is more than a quarter of the circumference",
                      fmt::format("give at most {:.6g} m", 0.25 * circumference))) {
    return;
  }
  const double first = bumps.front().pitch;
  const bool equal = std::all_of(bumps.begin(), bumps.end(), [&](const BumpShape& one) { return one.pitch == first; });
  const double sum = equal ? foil.bumps * first
                           : std::accumulate(bumps.begin(), bumps.end(), 0.0,
                                             [](double before, const BumpShape& bump) { return before + bump.pitch; });
  const std::string pitches = equal ? fmt::format("{} pitches of {:.6g} m are", foil.bumps, first)
                                    : fmt::format("{} pitches add up to", foil.bumps);
  checks.require(sum <= circumference * (1.0 + round_off), "bump_foil.bumps", std::to_string(foil.bumps),
                 fmt::format("the foil would overlap itself: {} {:.6g} m, the circumference is {:.6g} m", pitches, sum,
                             circumference),
                 equal ? fmt::format("give at most {} bumps", std::floor(circumference * (1.0 + round_off) / first))
                       : std::string("give fewer bumps or smaller pitches"));
}

/// Checks that arcs neither overlap nor are thicker than their radius.
/// @param key, shaped  the dimension that determines them, and its value, m
bool check_shape(Checks& checks, const BumpFoil& foil, std::size_t bump, const BumpShape& shape, bool pitch_known,
                 const std::string& key, double shaped) {
  const BumpArc arc = make_bump_arc(shape);
  const bool bulges = arc.rise > arc.half_length;
  const bool apart = checks.require(
      !bulges || !pitch_known || arc.flat <= 0.0 || 2.0 * arc.radius < shape.pitch, key, quantity(shaped, "m"),
      fmt::format("bumps would overlap: arcs of more than a half circle are {:.6g} m wide, the pitch is "
                  "{:.6g} m",
                  2.0 * arc.radius, shape.pitch),
      "give a smaller height or a larger pitch");
  return checks.require(shape.thickness < arc.radius, key_of_bump(foil, thickness, bump),
                        quantity(shape.thickness, "m"),
                        fmt::format("is more than the radius of the bump's arc, {:.6g} m", arc.radius),
                        "give a thinner foil or a flatter bump") &&
         apart;
}

/// Checks the nominal shape of a bump. @return whether it is valid
bool check_bump(Checks& checks, const BumpFoil& foil, std::size_t bump, const BumpShape& shape, const Usable& usable) {
  bool right = true;
  if (usable[length] && usable[pitch]) {
    right = checks.require(2.0 * shape.half_length < shape.pitch, key_of_bump(foil, length, bump),
                           quantity(2.0 * shape.half_length, "m"),
                           fmt::format("bumps would overlap: the pitch is {:.6g} m", shape.pitch),
                           "give a chord below the pitch, so that a flat is left");
  }
  if (!usable[height] || !usable[thickness]) return right;
  const double whole = foil.height_reference == HeightReference::overall ? shape.rise + shape.thickness : shape.rise;
  if (!checks.require(shape.rise > 0.0, key_of_bump(foil, height, bump), quantity(whole, "m"),
                      fmt::format("leaves no rise: the foil alone is {:.6g} mm thick", 1e3 * shape.thickness),
                      "give the overall height over the sleeve, or set height_reference = \"midsurface\"")) {
    return false;
  }
  return !usable[length] ||
         (check_shape(checks, foil, bump, shape, usable[pitch], key_of_bump(foil, height, bump), whole) && right);
}

/// Checks a list with one length per bump, each smaller than the rise of its bump (if known).
void check_list(Checks& checks, const std::string& key, const std::vector<double>& list, int bumps,
                const std::vector<double>& rises) {
  if (list.empty()) return;
  check_length_of_list(checks, key, list.size(), bumps);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const double rise = rises.empty() ? 0.0 : rises[std::min(i, rises.size() - 1)];
    const double limit = rise > 0.0 ? rise : length_range.most;
    if (std::abs(list[i]) < limit) continue;  // avoids text in the usual case
    const std::string entry = fmt::format("{}[{}]", key, i + 1);
    if (checks.finite(entry, list[i], "m") && rise > 0.0) {
      checks.require(std::abs(list[i]) < rise, entry, quantity(list[i], "m"),
                     fmt::format("is more than the rise of the bump, {:.6g} m", rise), "is the unit right?");
    }
  }
}

/// Checks the shape of the tallest bump, if height errors give bumps individual shapes.
void check_tallest(Checks& checks, const BumpFoil& foil, const std::vector<BumpShape>& bumps, bool pitch_known) {
  const std::vector<double>& errors = foil.height_errors;
  if (!foil.stiffness_follows_height || errors.empty() || errors.size() != bumps.size()) return;
  std::size_t tallest = 0;
  for (std::size_t n = 1; n < bumps.size(); ++n) {
    if (bumps[n].rise + errors[n] > bumps[tallest].rise + errors[tallest]) tallest = n;
  }
  BumpShape own = bumps[tallest];
  if (!(std::abs(errors[tallest]) < own.rise)) return;  // already checked
  own.rise += errors[tallest];
  check_shape(checks, foil, tallest, own, pitch_known, fmt::format("bump_foil.height_errors[{}]", tallest + 1),
              errors[tallest]);
}

void check_shims(Checks& checks, const std::vector<Shim>& shims, int bumps, double rise) {
  check_sections(checks, "bump_foil.shim", shims, bumps);
  for (std::size_t i = 0; i < shims.size(); ++i) {
    const std::string key = fmt::format("bump_foil.shim[{}].thickness", i + 1);
    if (checks.within(key, shims[i].thickness, length_range) && rise > 0.0) {
      checks.require(shims[i].thickness < rise, key, quantity(shims[i].thickness, "m"),
                     fmt::format("is more than the rise of the bumps, {:.6g} m", rise), "is the unit right?");
    }
  }
}

/// Nominal bumps, with unusable dimensions set to zero.
std::vector<BumpShape> usable_bumps(const BumpFoil& foil, const Usable& usable) {
  BumpFoil copy = foil;
  for (std::size_t i = 0; i < bump_dimensions.size(); ++i) {
    if (usable.at(i)) continue;
    copy.*bump_dimensions.at(i).all = 0.0;
    for (BumpSection& section : copy.sections) (section.*bump_dimensions.at(i).own).reset();
  }
  return nominal_bumps(copy);
}

}  // namespace

CheckedBumpFoil check_bump_foil(Checks& checks, const BumpFoil& foil, double radius) {
  CheckedBumpFoil checked;
  checked.bumps =
      checks.require(foil.bumps >= 1 && foil.bumps <= most_bumps, "bump_foil.bumps", std::to_string(foil.bumps),
                     "is not a valid number of bumps", fmt::format("give a whole number from 1 to {}", most_bumps));
  const int bumps = checked.bumps ? foil.bumps : 0;
  Usable usable{};
  for (std::size_t i = 0; i < bump_dimensions.size(); ++i)
    usable.at(i) = check_dimension(checks, foil, bump_dimensions.at(i), bumps);

  // Without a number of bumps, one represents all; bumps without a position are ignored.
  BumpFoil known = foil;
  if (!checked.bumps) known.bumps = 1;
  if (!check_sections(checks, "bump_foil.section", foil.sections, bumps)) known.sections.clear();
  const std::vector<BumpShape> shapes = usable_bumps(known, usable);

  if (usable[thickness] && radius > 0.0) {
    const auto thickest = std::max_element(
        shapes.begin(), shapes.end(), [](const BumpShape& a, const BumpShape& b) { return a.thickness < b.thickness; });
    check_thinness(checks, key_of_bump(known, thickness, static_cast<std::size_t>(thickest - shapes.begin())),
                   thickest->thickness, radius);
  }
  checked.pitches = usable[pitch] && checked.bumps;
  if (checked.pitches && radius > 0.0) check_pitches(checks, known, shapes, radius);

  bool right = true;
  for (std::size_t n = 0; n < shapes.size() && right; ++n) {
    if (n == 0 || shapes[n] != shapes[n - 1]) right = check_bump(checks, known, n, shapes[n], usable);
  }
  std::vector<double> rises;
  if (usable[height] && usable[thickness] && usable[length]) {
    rises.reserve(shapes.size());
    for (const BumpShape& shape : shapes) rises.push_back(std::max(shape.rise, 0.0));
    checked.rise = *std::max_element(rises.begin(), rises.end());
  }
  check_list(checks, "bump_foil.height_errors", foil.height_errors, bumps, rises);
  if (checked.rise > 0.0) check_tallest(checks, known, shapes, usable[pitch]);
  check_shims(checks, foil.shims, bumps, checked.rise);
  check_list(checks, "bump_foil.sleeve_gaps", foil.sleeve_gaps, bumps, rises);
  return checked;
}

void check_strip_of(Checks& checks, const BumpFoil& foil, int bumps) {
  const auto reaches = [&](const std::string& key, std::size_t values) {
    checks.require_for("strip", std::cmp_greater_equal(values, bumps), "strip.bumps", std::to_string(bumps),
                       fmt::format("is more than the {} values of {}", values, key), "give fewer bumps or more values");
  };
  for (const auto& [name, all, own] : bump_dimensions) {
    const std::string key = fmt::format("bump_foil.{}", name);
    const PerBump& dimension = foil.*all;
    if (dimension.is_list()) reaches(key, dimension.values.size());
    checks.require_for("strip", !dimension.law || bumps <= foil.bumps, "strip.bumps", std::to_string(bumps),
                       fmt::format("is more than the {} bumps that {} is graded along", foil.bumps, key),
                       "give fewer bumps");
  }
  if (!foil.height_errors.empty()) reaches("bump_foil.height_errors", foil.height_errors.size());
  if (!foil.sleeve_gaps.empty()) reaches("bump_foil.sleeve_gaps", foil.sleeve_gaps.size());
}

}  // namespace bumpfoil
