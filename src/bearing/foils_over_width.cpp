#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "bearing/foil_lines.hpp"
#include "bumpfoil/bearing/foils.hpp"
#include "bumpfoil/core/assert.hpp"
#include "bumpfoil/model/geometry.hpp"
#include "bumpfoil/structure/top_foil_on_lines.hpp"

namespace bumpfoil {
namespace {

/// Half the axial length, m.
double half_width_of(const Foils& foils) {
  return 0.5 * foils.placed.front().alone.bearing.axial_length;
}

/// Of each station of the top foil.
int unknowns_of_membrane(const WidthLines& width) {
  return 2 * static_cast<int>(width.stretching_orders().size());
}

/// Adds the top foil of a pad to K of the problem.
/// @param stations  of top_foil_on_lines()
void add_top_foil(const Foils& foils, int pad, const WidthLines& width, const std::vector<int>& stations,
                  BlockTridiagonal& K) {
  const FoilDesign design = make_bearing_design(foils.placed[static_cast<std::size_t>(pad)].alone);
  const BlockTridiagonal top = top_foil_on_lines(design, width, stations);
  std::vector<int> places;
  places.reserve(static_cast<std::size_t>(top.block_size()));
  const int of_membrane = unknowns_of_membrane(width);
  int membrane = K.block_size() - of_membrane * static_cast<int>(stations.size());  // the last of the block
  for (std::size_t station = 0; station < stations.size(); ++station) {
    const Eigen::Index first = static_cast<Eigen::Index>(station) * width.count();
    for (const int unknown : {foils.structure.dofs.top_u, foils.structure.dofs.top_moment}) {
      for (Eigen::Index s = 0; s < width.count(); ++s) places.push_back(Foils::place(foils.lines, first + s, unknown));
    }
    for (int i = 0; i < of_membrane; ++i) places.push_back(membrane++);
  }
  const auto first = static_cast<std::size_t>(foils.structure.blocks_of(pad).first);
  for (std::size_t b = 0; b < top.diagonal.size(); ++b) K.diagonal[first + b](places, places) += top.diagonal[b];
  for (std::size_t b = 0; b < top.upper.size(); ++b) K.upper[first + b](places, places) += top.upper[b];
}

/// FoilStructure::forming of top foils that are one under each line, as stiff as its part of the width.
Vector forming_on_lines(const Foils& foils) {
  const BumpDofs& dofs = foils.structure.dofs;
  Vector forming = Vector::Zero(foils.problem.K.rows());
  for (std::size_t s = 0; s < foils.unstaggered_lines(); ++s) {
    const auto put = [&](int unknown, double part) {
      const Eigen::Index blocks = foils.structure.K.blocks();
      forming(Eigen::seqN(Eigen::Index{Foils::place(foils.lines, static_cast<Eigen::Index>(s), unknown)}, blocks,
                          Eigen::Index{foils.problem.K.block_size()})) =
          part * foils.structure.forming(Eigen::seqN(Eigen::Index{unknown}, blocks, Eigen::Index{dofs.size}));
    };
    put(dofs.top_u, foils.lines[s].weight);
    put(dofs.top_moment, 1.0);
  }
  return forming;
}

/// Adds to the gaps of the journal on each line how much nearer it stands there where it is tilted.
void add_tilt(const Eigen::Vector2d& slope, Foils& foils) {
  for (int s = 0; s < foils.journal_contacts(); ++s) {
    foils.assembled_gap(foils.pressed(s)) += foils.lines[static_cast<std::size_t>(s)].zeta *
                                             journal_gaps(0.0, foils.normals_on(s), half_width_of(foils) * slope);
  }
}

/// Columns by which strips of a bump foil are staggered: different ones, rising.
std::vector<int> stations_of(const BumpFoil& foil) {
  std::vector<int> stations{0};
  for (const FoilStrip& strip : foil.strip) stations.push_back(strip.columns());
  std::sort(stations.begin(), stations.end());
  stations.erase(std::unique(stations.begin(), stations.end()), stations.end());
  return stations;
}

int station_of(const BumpFoil& foil, int strip) {
  return foil.strip.empty() ? 0 : foil.strip[static_cast<std::size_t>(strip)].columns();
}

/// The points of all strips, at those of Gauss's rule in each. @param dofs  of a bump foil, as many for each point
std::vector<FoilLine> points_of_strips(const PadDesign& pad, const BumpDofs& dofs) {
  std::vector<FoilLine> points;
  const double from_middle = 0.5 * strip_width(pad) / std::numbers::sqrt3;
  for (int strip = 0; strip < pad.bump_foil.strips; ++strip) {
    for (const double side : {-1.0, 1.0}) {
      FoilLine& point = points.emplace_back();
      point.zeta = (strip_middle(pad, strip) + side * from_middle) / (0.5 * pad.bearing.axial_length);
      point.weight = 0.5 / pad.bump_foil.strips;
      point.places.resize(static_cast<std::size_t>(dofs.size));
      std::iota(point.places.begin(), point.places.end(), (static_cast<int>(points.size()) - 1) * dofs.size);
      point.strip = strip;
    }
  }
  return points;
}

/// The lines of the top foil at each station. They have unknowns of the top foil alone, from `first` on.
std::vector<FoilLine> lines_at(const std::vector<int>& stations, const WidthLines& width, const BumpFoil& foil,
                               const BumpDofs& dofs, int first) {
  std::vector<FoilLine> lines;
  for (const int station : stations) {
    int strip = 0;
    while (station_of(foil, strip) != station) ++strip;
    for (Eigen::Index s = 0; s < width.count(); ++s) {
      FoilLine& line = lines.emplace_back();
      line.zeta = width.zeta[s];
      line.weight = width.weight[s];
      line.places.assign(static_cast<std::size_t>(dofs.size), -1);
      line.places[static_cast<std::size_t>(dofs.top_u)] = first + static_cast<int>(s);
      line.places[static_cast<std::size_t>(dofs.top_moment)] = first + static_cast<int>(width.count() + s);
      line.strip = strip;
    }
    first += 2 * static_cast<int>(width.count());
  }
  return lines;
}

/// Adds the bump foil under a point to K, and what ties its displacement of the top foil to those of the lines.
/// @param strip  foils that are as its strip all over the width
/// @param tie    N/m: brings its rows to the size of the others
void add_point(const Foils& foils, const FoilLine& point, const FoilStructure& strip, const WidthLines& width,
               double tie, BlockTridiagonal& K) {
  const BumpDofs& dofs = strip.dofs;
  std::vector<int> own, places;
  for (int i = 0; i < dofs.size; ++i) {
    if (i == dofs.top_u || i == dofs.top_moment) continue;
    own.push_back(i);
    places.push_back(point.places[static_cast<std::size_t>(i)]);
  }
  const auto of_point = [&](int unknown) { return point.places[static_cast<std::size_t>(unknown)]; };
  const int given = of_point(dofs.top_u);
  const int force = of_point(dofs.top_moment);
  const Vector shapes = width.shapes(point.zeta);
  const int station = station_of(foils.placed.front().alone.bump_foil, point.strip);
  for (std::size_t b = 0; b < K.diagonal.size(); ++b) {
    Matrix& block = K.diagonal[b];
    block(places, places) += point.weight * strip.K.diagonal[b](own, own);
    if (b + 1 < K.diagonal.size()) K.upper[b](places, places) += point.weight * strip.K.upper[b](own, own);
    block(given, force) = block(force, given) = -tie;
    Eigen::Index s = 0;
    for (const FoilLine& line : foils.lines) {
      if (station_of(foils.placed.front().alone.bump_foil, line.strip) != station) continue;
      const int top_u = line.places[static_cast<std::size_t>(dofs.top_u)];
      block(top_u, force) = block(force, top_u) = tie * shapes[s++];
    }
  }
}

}  // namespace

Foils under_tilted_journal(const Foils& foils, int modes, const Eigen::Vector2d& slope) {
  BUMPFOIL_ASSERT(foils.lines.empty() && foils.has_top_foil() && !foils.problem.law);
  const WidthLines width = make_width_lines(modes, WidthPart::whole);
  Foils tilted = foils;
  tilted.lines = foil_lines_of(width, foils.structure.dofs, foils.structure.dofs.size);
  BlockTridiagonal K(foils.structure.K.blocks(), unknowns_on_lines(tilted.lines) + unknowns_of_membrane(width));
  add_bump_foils(tilted, width, K);
  for (int pad = 0; pad < foils.pad_count(); ++pad) add_top_foil(tilted, pad, width, {0}, K);
  tilted.problem.K = std::move(K);
  tilted.forming = forming_on_lines(tilted);
  put_contacts_on_lines({&foils, 1}, 0.0, tilted);
  add_tilt(slope, tilted);
  return tilted;
}

Foils on_strips(const BearingDesign& design, int modes, const Eigen::Vector2d& slope) {
  Foils split = make_foils(design);
  BUMPFOIL_ASSERT(split.has_top_foil() && !split.problem.law);
  const PadDesign& first = split.placed.front().alone;
  const BumpDofs& dofs = split.structure.dofs;
  std::vector<Foils> strips;
  for (int strip = 0; strip < first.bump_foil.strips; ++strip) {
    std::vector<PlacedPad> pads;
    for (const PlacedPad& pad : split.placed) pads.push_back(strip_of(pad, strip));
    strips.push_back(make_uniform_foils(std::move(pads)));
  }
  const WidthLines width = make_width_lines(modes, WidthPart::whole);
  const std::vector<int> stations = stations_of(first.bump_foil);
  split.points = points_of_strips(first, dofs);
  const int of_bump_foils = static_cast<int>(split.points.size()) * dofs.size;
  split.lines = lines_at(stations, width, first.bump_foil, dofs, of_bump_foils);
  if (stations.size() > 1) {
    for (const Foils& strip : strips) split.strip_normals.push_back(strip.normals);
  }
  const int of_station = 2 * static_cast<int>(width.count()) + unknowns_of_membrane(width);
  BlockTridiagonal K(split.structure.K.blocks(), of_bump_foils + static_cast<int>(stations.size()) * of_station);
  const double tie = stiffest_of_bump_foils(split.structure);
  for (const FoilLine& point : split.points) {
    add_point(split, point, strips[static_cast<std::size_t>(point.strip)].structure, width, tie, K);
  }
  for (int pad = 0; pad < split.pad_count(); ++pad) add_top_foil(split, pad, width, stations, K);
  split.problem.K = std::move(K);
  split.forming = forming_on_lines(split);
  put_contacts_on_lines(strips, 0.0, split);
  add_tilt(slope, split);
  return split;
}

}  // namespace bumpfoil
