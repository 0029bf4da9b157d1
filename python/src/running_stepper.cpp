#include "running_stepper.hpp"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <cmath>
#include <string>
#include <utility>

#include "bumpfoil/bearing/backward_difference.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/experiments/equilibrium/equilibrium.hpp"
#include "run.hpp"

namespace bumpfoil {
namespace {

namespace py = pybind11;

FilmBearingOptions stepper_options(const Case& input, const BearingModel& bearing) {
  FilmBearingOptions options;
  options.newton.thickness_floor = thickness_floor(input) / bearing.film->scales.thickness;
  return options;
}

/// @throws Error (input) unless one of position (m) and load (N) is given
OperatingPoint point_to(const std::optional<Eigen::Vector2d>& position, const std::optional<Eigen::Vector2d>& load,
                        double speed) {
  if (position.has_value() == load.has_value()) {
    refuse_argument("position, load", position ? "are both given" : "are missing", "give one of them");
  }
  if (!std::isfinite(speed)) refuse_argument("speed", "is not finite", "give a speed in rad/s");
  if (position) {
    if (!position->allFinite()) refuse_argument("position", "is not finite", "give two lengths in m");
    return OperatingPoint::held_at(*position, speed);
  }
  if (!load->allFinite()) refuse_argument("load", "is not finite", "give two forces in N");
  return OperatingPoint::loaded_by(*load, speed);
}

SharedInstant failed(const ReachedInstant& from, Status status) {
  ReachedInstant instant = from;
  instant.status = status;
  return std::make_shared<const ReachedInstant>(std::move(instant));
}

py::dict fields_of(const ReachedInstant& instant, const BearingModel& bearing) {
  const FoilFilmState& film = instant.state.film;
  py::dict fields;
  fields["pressure"] = Matrix(bearing.film->scales.gas.ambient_pressure * film.pressure);
  fields["film_thickness"] = Matrix(bearing.film->scales.thickness * film.thickness);
  fields["bump_load"] = bump_loads(bearing, instant.state);
  return fields;
}

}  // namespace

RunningStepper::RunningStepper(const Case& input)
    : input_(input),
      bearing_(std::make_shared<const BearingModel>(make_film_bearing(input))),
      stepper_(bearing_, stepper_options(input, *bearing_)) {}

RunningStepper::RunningStepper(const RunningStepper& other)
    : input_(other.input_), bearing_(other.bearing_), stepper_(bearing_, other.stepper_.options()) {}

SharedInstant RunningStepper::begin(const OperatingPoint& point) {
  Case requested = input_;
  auto& settings = requested.settings.get_or_create<EquilibriumSettings>();
  settings.speeds = {point.speed};
  (point.by_load() ? settings.loads : settings.positions) = {point.journal};
  (point.by_load() ? settings.positions : settings.loads).clear();
  const EquilibriumResult result = run_equilibrium(requested, {settings.path});
  const RunningState& found = result.states.back();
  ReachedInstant instant{.state = found.last.value_or(BearingState{}), .outcome = {}, .status = found.report.status};
  instant.state.time = 0.0;
  if (instant.status == Status::converged) instant.outcome = film_bearing_outcome(*bearing_, instant.state);
  return std::make_shared<const ReachedInstant>(std::move(instant));
}

SharedInstant RunningStepper::advance(const ReachedInstant& from, double dt, const OperatingPoint& to) {
  if (!(std::isfinite(dt) && dt > 0.0)) refuse_argument("dt", "is no length of a step", "give a time in s above 0");
  const std::scoped_lock lock(mutex_);
  ReachedInstant instant{.state = from.state, .outcome = {}};
  OperatingPoint tilted = to;
  tilted.tilt = bearing_->film->surroundings.tilt;
  instant.status = stepper_.advance(stepper_.move_to(tilted, dt), instant.state).status;
  if (instant.status != Status::converged) return failed(from, instant.status);
  instant.outcome = film_bearing_outcome(*bearing_, instant.state);
  instant.span = bdf2(dt, from.state.last_step.dt).span;
  return std::make_shared<const ReachedInstant>(std::move(instant));
}

std::optional<Eigen::Matrix2d> RunningStepper::tangent(const ReachedInstant& instant) {
  const std::scoped_lock lock(mutex_);
  if (instant.span == 0.0) {
    const auto stiffness = stepper_.stiffness(instant.state);
    return stiffness ? std::optional<Eigen::Matrix2d>(stiffness->topLeftCorner<2, 2>()) : std::nullopt;
  }
  // What a step does to all that has a rate is what e^{s t} does at s = 1 / span.
  const auto impedances = stepper_.impedances(instant.state, {1.0 / instant.span});
  if (!impedances) return std::nullopt;
  return impedances->front().real().topLeftCorner<2, 2>();
}

void add_running_stepper(py::module_& m) {
  py::class_<ReachedInstant, std::shared_ptr<ReachedInstant>>(m, "ReachedInstant")
      .def_property_readonly("status", [](const ReachedInstant& self) { return std::string(name_of(self.status)); })
      .def_property_readonly("explanation",
                             [](const ReachedInstant& self) { return std::string(explanation(self.status)); })
      .def_property_readonly("time", [](const ReachedInstant& self) { return self.state.time; })
      .def_property_readonly("speed", [](const ReachedInstant& self) { return self.state.speed; })
      .def_property_readonly("position", [](const ReachedInstant& self) { return self.state.position; })
      .def_property_readonly("force", [](const ReachedInstant& self) { return self.outcome.force; })
      .def_property_readonly("power", [](const ReachedInstant& self) { return self.outcome.power; });
  using Place = std::optional<Eigen::Vector2d>;
  const auto shared = [](SharedInstant instant) { return std::const_pointer_cast<ReachedInstant>(std::move(instant)); };
  py::class_<RunningStepper>(m, "RunningStepper")
      .def(py::init([](const CaseSource& source) { return std::make_unique<RunningStepper>(read_source(source)); }))
      .def(py::init<const RunningStepper&>())
      .def("begin",
           [=](RunningStepper& self, double speed, const Place& position, const Place& load) {
             const OperatingPoint point = point_to(position, load, speed);
             const py::gil_scoped_release unlocked;
             return shared(self.begin(point));
           })
      .def("advance",
           [=](RunningStepper& self, const ReachedInstant& from, double dt, double speed, const Place& position,
               const Place& load) {
             const OperatingPoint to = point_to(position, load, speed);
             const py::gil_scoped_release unlocked;
             return shared(self.advance(from, dt, to));
           })
      .def("tangent",
           [](RunningStepper& self, const ReachedInstant& instant) {
             const py::gil_scoped_release unlocked;
             return self.tangent(instant);
           })
      .def("thinnest_film",
           [](const RunningStepper& self, const ReachedInstant& instant) {
             return self.bearing().film->scales.thickness * instant.outcome.thinnest.thickness;
           })
      .def("fields", [](const RunningStepper& self, const ReachedInstant& instant) {
        return fields_of(instant, self.bearing());
      });
}

}  // namespace bumpfoil
