#include "bumpfoil/bearing/fields.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "bumpfoil/contact/residual.hpp"
#include "bumpfoil/structure/width_lines.hpp"

namespace bumpfoil {
namespace {

/// Loads below this fraction of the largest, or below round-off, are reported as open: without load, the largest is
/// itself round-off.
constexpr double open_load = 1e-9;

/// Contacts of one interface: `count` per block from index `first` on, from block `first_block` on. Each is single over
/// the width, or stands for `points` contacts side by side.
struct InterfacePlace {
  int first_block{};
  int first{};
  int count{};
  int points{1};

  [[nodiscard]] Eigen::Index columns(const BearingModel& foils) const {
    return Eigen::Index{foils.structure.K.blocks() - first_block} * count;
  }
  /// Visits each of its contacts. @param visit  (column, first of its points)
  template <typename Visit>
  void each(const BearingModel& foils, const Visit& visit) const {
    if (count == 0) return;
    const Eigen::Index per_block = foils.contacts_per_block();
    Eigen::Index column = 0;
    for (int block = first_block; block < foils.structure.K.blocks(); ++block) {
      const Eigen::Index begin = foils.block(block) * per_block + first;
      for (int k = 0; k < count; ++k) visit(column++, begin + Eigen::Index{k} * points);
    }
  }
};

InterfacePlace place_of(const BearingModel& foils, Interface interface) {
  switch (interface) {
    case Interface::journal_top:
      return {.first_block = foils.structure.first_bump,
              .first = 0,
              .count = foils.top_bump() > 0 ? 1 : 0,
              .points = foils.journal_contacts()};
    case Interface::top_bump:
      return {.first_block = foils.structure.first_bump,
              .first = foils.top_bump(),
              .count = 1,
              .points = foils.crest_contacts()};
    case Interface::bump_sleeve:
      break;
  }
  return {
      .first_block = 0, .first = foils.first_foot(), .count = foils.feet_per_block(), .points = foils.foot_contacts()};
}

/// Loads up to this count as zero, N.
double open_threshold(const BearingModel& foils, const ContactState& state) {
  return std::max(open_load * state.normal_force.maxCoeff(), foils.round_off.force);
}

/// Reported mode of contact `c`: contacts without load are open, frictionless ones slip if they move.
ContactMode reported_mode(const BearingModel& foils, Eigen::Index c, const BearingState& state, double threshold) {
  const auto number = static_cast<std::size_t>(c);
  if (state.contacts.normal_force[c] <= threshold) return ContactMode::open;
  const ContactSite& site = foils.problem.sites[number];
  if (site.tangential < 0 || site.friction_coefficient > 0.0) return state.contacts.mode[number];
  if (foils.film) return ContactMode::stick;  // it may contain several motions: no slip direction
  const Eigen::Index at = Eigen::Index{site.block} * foils.problem.K.block_size() + site.tangential;
  const double slip = state.contacts.x[at] - state.slip_origin[at];
  return slip > displacement_resolution    ? ContactMode::slip_forward
         : slip < -displacement_resolution ? ContactMode::slip_backward
                                           : ContactMode::stick;
}

void record_interface(const BearingModel& foils, const BearingState& state, Interface interface, Eigen::Index increment,
                      InterfaceFields& fields) {
  const double threshold = open_threshold(foils, state.contacts);
  // One row at a time, to resolve its address once.
  auto gap = fields.gap.row(increment);
  auto normal_force = fields.normal_force.row(increment);
  auto friction_force = fields.friction_force.row(increment);
  auto mode = fields.mode.row(increment);
  const InterfacePlace place = place_of(foils, interface);
  place.each(foils, [&](Eigen::Index i, Eigen::Index first) {
    // Over the width: the minimum gap, the sum of forces, and the mode of a point in contact.
    mode[i] = ContactMode::open;
    gap[i] = std::numeric_limits<double>::infinity();
    normal_force[i] = friction_force[i] = 0.0;
    for (Eigen::Index c = first; c < first + place.points; ++c) {
      const ContactMode of_point = reported_mode(foils, c, state, threshold);
      const bool open = of_point == ContactMode::open;
      gap[i] = std::min(gap[i], open ? std::max(0.0, state.contacts.gap[c]) : 0.0);
      if (open) continue;
      mode[i] = of_point;
      normal_force[i] += state.contacts.normal_force[c];
      friction_force[i] += state.contacts.friction_force[c];
    }
  });
}

void record_stress(const BearingModel& foils, const Vector& x, Eigen::Index increment, StressFields& fields) {
  const auto put = [&](FieldMatrix& field, Eigen::Index column, const Vector& values) {
    if (values.size() == 0) return;
    field.row(increment).segment(column, values.size()) =
        values.unaryExpr([&](double s) { return cleared(s, foils.round_off.stress); }).transpose();
  };
  const auto put_one = [&](FieldMatrix& field, Eigen::Index column, const std::optional<double>& value) {
    if (value) put(field, column, Vector::Constant(1, *value));
  };
  for (int pad = 0; pad < foils.pad_count(); ++pad) {
    const Eigen::Index first = foils.structure.blocks_of(pad).first;
    const FoilStress stress = pad_stress(foils, x, pad);
    put_one(fields.top_weld, pad, stress.top_weld);
    put_one(fields.bump_weld, pad, stress.bump_weld);
    put(fields.top_crest, first, stress.top_crest);
    put(fields.bump_crest, first, stress.bump_crest);
    put(fields.bump_foot, first * foils.feet_per_block(), stress.bump_foot);
    put(fields.bump_largest, first, stress.bump_largest);
  }
}

/// Displacements on the crest lines of a mode that is P_k at zeta = 1. Points of strips are not a quadrature rule of
/// the whole width: they use the best fit, available for k = 1.
Vector parts_of_mode(const BearingModel& foils, int k) {
  const std::vector<FoilLine>& lines = foils.crest_lines();
  Vector parts(std::ssize(lines));
  double square = 0.0;
  for (std::size_t s = 0; s < lines.size(); ++s) {
    const double value = legendre(k, lines[s].zeta);
    square += lines[s].weight * value * value;
    parts[static_cast<Eigen::Index>(s)] = lines[s].weight * value;
  }
  return foils.points.empty() ? Vector((2 * k + 1) * parts) : Vector(parts / square);
}

void record_modes(const BearingModel& foils, const Vector& x, Eigen::Index increment, FoilFields& fields) {
  const BumpDofs& dofs = foils.structure.dofs;
  // Writes unknowns of successive bumps or feet, by P_k over the width at zeta = 1.
  const auto put = [&](FieldMatrix& field, int k, int first_block, const std::vector<int>& unknowns) {
    if (field.cols() == 0) return;
    const auto count = std::ssize(unknowns);
    const Vector parts = parts_of_mode(foils, k);
    for (Eigen::Index i = 0; i < field.cols(); ++i) {
      const int block = foils.block(first_block + static_cast<int>(i / count));
      const int unknown = unknowns[static_cast<std::size_t>(i % count)];
      double value = 0.0;
      for (int s = 0; s < foils.crest_contacts(); ++s) {
        value += parts[s] * x[Eigen::Index{block} * foils.problem.K.block_size() + foils.place(s, unknown)];
      }
      field(increment, i) = value;
    }
  };
  const int first_bump = foils.structure.first_bump;
  put(fields.top_slope, 1, first_bump, {dofs.top_u});
  put(fields.top_parabola, 2, first_bump, {dofs.top_u});
  put(fields.crest_u_slope, 1, first_bump, {dofs.crest_u});
  put(fields.crest_v_slope, 1, first_bump, {dofs.crest_v});
  put(fields.foot_u_slope, 1, 0, dofs.foot_u);
  put(fields.foot_v_slope, 1, 0, dofs.foot_v);
  put(fields.crest_u_parabola, 2, first_bump, {dofs.crest_u});
  put(fields.crest_v_parabola, 2, first_bump, {dofs.crest_v});
  put(fields.foot_u_parabola, 2, 0, dofs.foot_u);
  put(fields.foot_v_parabola, 2, 0, dofs.foot_v);
}

StressFields make_stress_fields(const BearingModel& foils, int increments) {
  const Eigen::Index count = foils.structure.blocks_of(0).count;
  const FoilStress none = foil_stress(foils.stress.front(), Vector::Zero(count * foils.structure.dofs.size));
  const auto of_welds = [&](const std::optional<double>& one) {
    return FieldMatrix(increments, one ? foils.pad_count() : 0);
  };
  const auto of_all = [&](const Vector& of_pad) {
    return FieldMatrix(increments, of_pad.size() * foils.bumps() / (count - foils.structure.first_bump));
  };
  return {.top_weld = of_welds(none.top_weld),
          .top_crest = of_all(none.top_crest),
          .bump_weld = of_welds(none.bump_weld),
          .bump_crest = of_all(none.bump_crest),
          .bump_foot = of_all(none.bump_foot),
          .bump_largest = of_all(none.bump_largest)};
}

}  // namespace

void InterfaceFields::resize(Eigen::Index increments, Eigen::Index columns) {
  for (FieldMatrix* field : {&gap, &normal_force, &friction_force}) field->resize(increments, columns);
  mode.resize(increments, columns);
}

void InterfaceFields::truncate(Eigen::Index increments) {
  for (FieldMatrix* field : {&gap, &normal_force, &friction_force}) {
    field->conservativeResize(increments, Eigen::NoChange);
  }
  mode.conservativeResize(increments, Eigen::NoChange);
}

void FoilFields::truncate(Eigen::Index increments) {
  for (FieldMatrix* field :
       {&top_displacement, &crest_u,          &crest_v,           &foot_u,           &foot_v,
        &compression,      &top_slope,        &crest_u_slope,     &crest_v_slope,    &foot_u_slope,
        &foot_v_slope,     &top_parabola,     &crest_u_parabola,  &crest_v_parabola, &foot_u_parabola,
        &foot_v_parabola,  &pad_force_x,      &pad_force_y,       &strip_load,       &stress.top_weld,
        &stress.top_crest, &stress.bump_weld, &stress.bump_crest, &stress.bump_foot, &stress.bump_largest}) {
    field->conservativeResize(increments, Eigen::NoChange);
  }
  for (InterfaceFields* interface : {&journal_top, &top_bump, &bump_sleeve}) interface->truncate(increments);
}

Vector largest_pad_forces(const FoilFields& fields) {
  if (fields.pad_force_x.size() == 0) return {};
  return (fields.pad_force_x.array().square() + fields.pad_force_y.array().square()).colwise().maxCoeff().sqrt();
}

Vector interface_loads(const BearingModel& foils, const ContactState& state, Interface interface) {
  const InterfacePlace place = place_of(foils, interface);
  const double threshold = open_threshold(foils, state);
  Vector loads(place.columns(foils));
  place.each(foils, [&](Eigen::Index i, Eigen::Index first) {
    const double load = state.normal_force.segment(first, place.points).sum();
    loads[i] = load <= threshold ? 0.0 : load;
  });
  return loads;
}

FoilStress pad_stress(const BearingModel& foils, const Vector& x, int pad) {
  const PadBlocks blocks = foils.structure.blocks_of(pad);
  const Eigen::Index size = foils.structure.dofs.size;
  const auto stress_of = [&](const std::vector<StressModel>& models, std::optional<int> strip) {
    const Vector known = foils.foil_unknowns(x, strip);
    return foil_stress(models[static_cast<std::size_t>(pad)], known.segment(blocks.first * size, blocks.count * size));
  };
  FoilStress stress = stress_of(foils.stress, {});
  for (std::size_t strip = 0; strip < foils.strip_stress.size(); ++strip) {
    const FoilStress one = stress_of(foils.strip_stress[strip], static_cast<int>(strip));
    const auto take = [&](Vector FoilStress::*places) {
      stress.*places = strip == 0 ? one.*places : (stress.*places).cwiseMax(one.*places).eval();
    };
    for (const auto places : {&FoilStress::bump_crest, &FoilStress::bump_foot, &FoilStress::bump_largest}) take(places);
    if (one.bump_weld) stress.bump_weld = strip == 0 ? *one.bump_weld : std::max(*stress.bump_weld, *one.bump_weld);
  }
  return stress;
}

Vector strip_loads(const BearingModel& foils, const ContactState& state) {
  Vector loads = Vector::Zero(foils.points.empty() ? 0 : foils.points.back().strip + 1);
  const double threshold = open_threshold(foils, state);
  for (std::size_t p = 0; p < foils.points.size(); ++p) {
    const Eigen::Index first = Eigen::Index{foils.structure.first_bump} * foils.contacts_per_block() + foils.top_bump();
    const auto at_crests = Eigen::seqN(first + static_cast<Eigen::Index>(p), Eigen::Index{foils.bumps()},
                                       Eigen::Index{foils.contacts_per_block()});
    const Vector carried = state.normal_force(at_crests);
    loads[foils.points[p].strip] += (carried.array() > threshold).select(carried, 0.0).sum();
  }
  return loads;
}

FoilFields make_fields(const BearingModel& foils, int increments) {
  const Eigen::Index bumps = foils.bumps();
  const Eigen::Index feet = place_of(foils, Interface::bump_sleeve).columns(foils);
  FoilFields fields;
  fields.top_displacement.resize(increments, foils.has_top_foil() ? bumps : 0);
  for (FieldMatrix* field : {&fields.crest_u, &fields.crest_v, &fields.compression}) field->resize(increments, bumps);
  for (FieldMatrix* field : {&fields.foot_u, &fields.foot_v}) field->resize(increments, feet);
  fields.journal_top.resize(increments, foils.top_bump() > 0 ? bumps : 0);
  fields.top_bump.resize(increments, bumps);
  fields.bump_sleeve.resize(increments, feet);
  // Either the whole bump foil varies linearly, or none of it.
  const bool has_slope = foils.foot_contacts() > 1 && foils.crest_lines().front().zeta < 0.0;
  for (FieldMatrix* field : {&fields.crest_u_slope, &fields.crest_v_slope}) {
    field->resize(increments, has_slope ? bumps : 0);
  }
  const bool has_pressed_top = foils.has_top_foil() && !foils.film;  // films have a top foil shape of their own
  fields.top_slope.resize(increments, has_pressed_top && has_slope ? bumps : 0);
  for (FieldMatrix* field : {&fields.foot_u_slope, &fields.foot_v_slope}) {
    field->resize(increments, has_slope ? feet : 0);
  }
  const bool has_parabola = foils.points.empty() && foils.crest_contacts() > (has_slope ? 2 : 1);
  fields.top_parabola.resize(increments, has_pressed_top && has_parabola ? bumps : 0);
  fields.crest_v_parabola.resize(increments, has_parabola ? bumps : 0);
  const bool slides_as_parabola = has_parabola && foils.sheet == SheetModel::elastic;
  fields.crest_u_parabola.resize(increments, slides_as_parabola ? bumps : 0);
  for (FieldMatrix* field : {&fields.foot_u_parabola, &fields.foot_v_parabola}) {
    field->resize(increments, slides_as_parabola ? feet : 0);
  }
  for (FieldMatrix* field : {&fields.pad_force_x, &fields.pad_force_y}) {
    field->resize(increments, foils.pad_count() > 1 && !foils.film ? foils.pad_count() : 0);
  }
  fields.strip_load.resize(increments, foils.points.empty() ? 0 : foils.points.back().strip + 1);
  fields.stress = make_stress_fields(foils, increments);
  return fields;
}

Vector bump_compression(const FoilStructure& structure, const Vector& x) {
  const BumpDofs& dofs = structure.dofs;
  const Eigen::Index size = dofs.size;
  Vector compression(structure.bumps());
  for (Eigen::Index i = 0; i < compression.size(); ++i) {
    const Eigen::Index block = structure.first_bump + i;
    const auto foot = [&](Eigen::Index of_block, int v) { return x[of_block * size + v]; };
    // A block with one foot shares the other with the previous block, if that belongs to its foil.
    const bool shares = dofs.feet() == 1;
    const bool welded =
        shares && std::find(structure.pads.begin(), structure.pads.end(), block) != structure.pads.end();
    const double before = welded ? 0.0 : foot(shares ? block - 1 : block, dofs.foot_v.front());
    compression[i] = x[block * size + dofs.crest_v] - 0.5 * (before + foot(block, dofs.foot_v.back()));
  }
  return compression;
}

void record(const BearingModel& foils, const BearingState& state, Eigen::Index increment, FoilFields& fields) {
  const Vector x = foils.foil_unknowns(state.contacts.x);
  const BumpDofs& dofs = foils.structure.dofs;
  const Eigen::Index size = dofs.size;
  for (Eigen::Index i = 0; i < foils.bumps(); ++i) {
    const auto bump = x.segment((foils.structure.first_bump + i) * size, size);
    if (foils.has_top_foil()) fields.top_displacement(increment, i) = bump[dofs.top_u];
    fields.crest_u(increment, i) = bump[dofs.crest_u];
    fields.crest_v(increment, i) = bump[dofs.crest_v];
  }
  const Eigen::Index feet = dofs.feet();
  for (Eigen::Index i = 0; i < fields.foot_u.cols(); ++i) {
    const auto foot = static_cast<std::size_t>(i % feet);
    fields.foot_u(increment, i) = x[i / feet * size + dofs.foot_u[foot]];
    fields.foot_v(increment, i) = x[i / feet * size + dofs.foot_v[foot]];
  }
  record_modes(foils, state.contacts.x, increment, fields);
  fields.compression.row(increment) = bump_compression(foils.structure, x);
  record_interface(foils, state, Interface::journal_top, increment, fields.journal_top);
  record_interface(foils, state, Interface::top_bump, increment, fields.top_bump);
  record_interface(foils, state, Interface::bump_sleeve, increment, fields.bump_sleeve);
  if (fields.pad_force_x.cols() > 0) {
    const Eigen::Matrix2Xd forces = pad_forces(foils, state.contacts.normal_force);
    const auto shown = [&](double force) { return cleared(force, foils.round_off.force); };
    fields.pad_force_x.row(increment) = forces.row(0).unaryExpr(shown);
    fields.pad_force_y.row(increment) = forces.row(1).unaryExpr(shown);
  }
  if (fields.strip_load.cols() > 0) fields.strip_load.row(increment) = strip_loads(foils, state.contacts);
  record_stress(foils, state.contacts.x, increment, fields.stress);
}

}  // namespace bumpfoil
