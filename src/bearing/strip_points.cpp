#include "bearing/strip_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "bearing/foil_lines.hpp"
#include "bumpfoil/model/geometry.hpp"

namespace bumpfoil {
namespace {

const BumpFoil& bump_foil_of(const BearingModel& foils) {
  return foils.placed.front().alone.bump_foil;
}

int station_of(const BearingModel& foils, int strip) {
  const BumpFoil& foil = bump_foil_of(foils);
  return foil.strip.empty() ? 0 : foil.strip[static_cast<std::size_t>(strip)].sixths();
}

/// Adds the bump foil under a point to K, and its tie.
/// @param strip  of the point
/// @param tie    N/m: scales its rows to the others
void add_point(const BearingModel& foils, const FoilLine& point, const FoilStructure& strip, const WidthLines& width,
               double tie, BlockTridiagonal& K) {
  const BumpDofs& dofs = strip.dofs;
  std::vector<int> own, places;
  for (int i = 0; i < dofs.size; ++i) {
    if (i == dofs.top_u || i == dofs.top_moment) continue;
    own.push_back(i);
    places.push_back(point.places[static_cast<std::size_t>(i)]);
  }
  const int given = point.places[static_cast<std::size_t>(dofs.top_u)];
  const int force = point.places[static_cast<std::size_t>(dofs.top_moment)];
  const Vector shapes = width.shapes(point.zeta);
  const int station = station_of(foils, point.strip);
  for (int pad = 0; pad < foils.pad_count(); ++pad) {
    const PadBlocks blocks = strip.blocks_of(pad);
    for (int b = 0; b < blocks.count; ++b) {
      const auto from = static_cast<std::size_t>(blocks.first) + static_cast<std::size_t>(b);
      const auto to = static_cast<std::size_t>(foils.block(blocks.first + b));
      Matrix& block = K.diagonal[to];
      block(places, places) += point.weight * strip.K.diagonal[from](own, own);
      if (b + 1 < blocks.count) K.upper[to](places, places) += point.weight * strip.K.upper[from](own, own);
      block(given, force) = block(force, given) = -tie;
      Eigen::Index s = 0;
      for (const FoilLine& line : foils.lines) {
        if (station_of(foils, line.strip) != station) continue;
        const int top_u = line.places[static_cast<std::size_t>(dofs.top_u)];
        block(top_u, force) = block(force, top_u) = tie * shapes[s++];
      }
    }
  }
}

/// Adds the slice of top foil and bump foil that a point represents to K. The moment of the top foil is that of this
/// slice.
void add_slice(const FoilLine& point, const FoilStructure& strip, BlockTridiagonal& K) {
  Vector part = Vector::Constant(strip.dofs.size, std::sqrt(point.weight));
  part[strip.dofs.top_moment] = 1.0 / part[strip.dofs.top_moment];
  const auto add = [&](const Matrix& slice, Matrix& block) {
    block(point.places, point.places) += part.asDiagonal() * slice * part.asDiagonal();
  };
  for (std::size_t b = 0; b < strip.K.diagonal.size(); ++b) {
    add(strip.K.diagonal[b], K.diagonal[b]);
    if (b < strip.K.upper.size()) add(strip.K.upper[b], K.upper[b]);
  }
}

/// The points of all strips, two Gauss points on each, with unknowns from `further` on. Those of the first point are
/// the foils' own, except for the top foil unless it is split.
std::vector<FoilLine> points_of(const BearingModel& foils, int further) {
  const BumpDofs& dofs = foils.structure.dofs;
  const PadDesign& pad = foils.placed.front().alone;
  const double from_middle = 0.5 * strip_width(pad) / std::numbers::sqrt3;
  std::vector<FoilLine> points;
  for (int strip = 0; strip < pad.bump_foil.strips; ++strip) {
    for (const double side : {-1.0, 1.0}) {
      const bool first = points.empty();
      FoilLine& point = points.emplace_back();
      point.zeta = (strip_middle(pad, strip) + side * from_middle) / (0.5 * pad.bearing.axial_length);
      point.weight = 0.5 / pad.bump_foil.strips;
      point.strip = strip;
      point.places.resize(static_cast<std::size_t>(dofs.size));
      for (int i = 0; i < dofs.size; ++i) {
        const bool of_lines = !foils.split_top_foil && (i == dofs.top_u || i == dofs.top_moment);
        point.places[static_cast<std::size_t>(i)] = first && !of_lines ? i : further++;
      }
    }
  }
  return points;
}

}  // namespace

std::vector<BearingModel> strips_of(const BearingModel& foils) {
  std::vector<BearingModel> strips;
  strips.reserve(static_cast<std::size_t>(bump_foil_of(foils).strips));
  for (int strip = 0; strip < bump_foil_of(foils).strips; ++strip) {
    std::vector<PlacedPad> pads;
    pads.reserve(foils.placed.size());
    for (const PlacedPad& pad : foils.placed) pads.push_back(strip_of(pad, strip));
    strips.push_back(make_uniform_foils(std::move(pads)));
  }
  return strips;
}

void keep_stress(std::span<const BearingModel> strips, BearingModel& foils) {
  const std::vector<FoilStrip>& own = bump_foil_of(foils).strip;
  if (std::none_of(own.begin(), own.end(), [](const FoilStrip& one) { return one.has_own_bumps(); })) return;
  foils.strip_stress.clear();
  for (const BearingModel& strip : strips) foils.strip_stress.push_back(strip.stress);
}

void lay_out_strips(const WidthLines& width, int further, BearingModel& foils) {
  const BumpDofs& dofs = foils.structure.dofs;
  foils.lines.clear();
  for (const int station : bump_foil_of(foils).stations()) {
    int strip = 0;
    while (station_of(foils, strip) != station) ++strip;
    for (Eigen::Index s = 0; s < width.count(); ++s) {
      const bool first = foils.lines.empty();
      FoilLine& line =
          foils.lines.emplace_back(FoilLine{.zeta = width.zeta[s], .weight = width.weight[s], .places = {}});
      line.places.assign(static_cast<std::size_t>(dofs.size), -1);
      for (const int unknown : {dofs.top_u, dofs.top_moment}) {
        line.places[static_cast<std::size_t>(unknown)] = first ? unknown : further++;
      }
      line.strip = strip;
    }
  }
  foils.points = points_of(foils, further);
}

void lay_out_split_foils(BearingModel& foils) {
  foils.split_top_foil = true;
  foils.points = points_of(foils, foils.structure.dofs.size);
  foils.lines = foils.points;
}

void add_slices(const BearingModel& foils, std::span<const BearingModel> strips, BlockTridiagonal& K) {
  for (const FoilLine& point : foils.points) {
    add_slice(point, strips[static_cast<std::size_t>(point.strip)].structure, K);
  }
}

void add_strips(const BearingModel& foils, std::span<const BearingModel> strips, const WidthLines& width,
                BlockTridiagonal& K) {
  const double tie = stiffest_of_bump_foils(foils.structure);
  for (const FoilLine& point : foils.points) {
    add_point(foils, point, strips[static_cast<std::size_t>(point.strip)].structure, width, tie, K);
  }
}

}  // namespace bumpfoil
