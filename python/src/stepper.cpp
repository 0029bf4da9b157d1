#include "stepper.hpp"

#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <string>
#include <utility>

#include "bumpfoil/core/status.hpp"
#include "bumpfoil/experiments/build.hpp"
#include "bumpfoil/motion/load_search.hpp"
#include "cycle_views.hpp"
#include "run.hpp"

namespace bumpfoil {
namespace {

namespace py = pybind11;

/// A load smaller than the requested one by this factor counts as zero.
constexpr double least_load = 1e-6;

}  // namespace

BearingStepper::BearingStepper(const Case& input)
    : foils_(make_bearing_foils(input, {"path"})), settings_(input.solver), stepper_(make_stepper(foils_, settings_)) {}

BearingStepper::BearingStepper(const BearingStepper& other)
    : foils_(other.foils_), settings_(other.settings_), stepper_(make_stepper(foils_, settings_)) {}

Excitation BearingStepper::excitation_of(Excitation excitation, const Destination& to) const {
  if (to.position && to.load) refuse_argument("advance", "both a position and a load are given", "give one of them");
  if (to.position && !to.position->allFinite()) refuse_argument("position", "is not finite", "give two lengths in m");
  if (to.load && !(to.load->allFinite() && to.load->norm() > 0.0)) {
    refuse_argument("load", "is zero or not finite", "give two forces in N; without a load, a position");
  }
  if (to.position) excitation.position = *to.position;
  if (!to.top_load) return excitation;
  if (!foils_->has_top_foil() || to.top_load->size() != foils_->bumps() || !to.top_load->allFinite()) {
    refuse_argument("top_load", "is no list of " + std::to_string(foils_->bumps()) + " forces on a top foil",
                    "give one in N for each bump, positive outward");
  }
  excitation.top_load = *to.top_load;
  return excitation;
}

SharedState BearingStepper::checked() {
  ReachedState reached;
  const Eigen::Vector2d along = Eigen::Vector2d::UnitX();
  if (step_.converged()) {
    reached.increment = place_increment(*foils_, step_, along);
    check_increment(*foils_, step_.state, reached.increment);
    reached.increment.work = step_.state.work;
    reached.increment.dissipated_energy = step_.state.dissipated_energy;
    reached.fields = make_fields(*foils_, 1);
    record(*foils_, step_.state, 0, reached.fields);
  } else {
    reached.increment = failed_increment(step_, along);
  }
  reached.state = step_.state;
  return std::make_shared<const ReachedState>(std::move(reached));
}

SharedState BearingStepper::assemble(const Destination& to) {
  if (to.load)
    refuse_argument("load", "cannot be met by foils that are not assembled", "advance to it from a position");
  const std::scoped_lock lock(mutex_);
  stepper_.assemble(excitation_of({}, to), step_);
  return checked();
}

SharedState BearingStepper::advance(const ReachedState& from, const Destination& to) {
  const std::scoped_lock lock(mutex_);
  const Excitation excitation = excitation_of(from.state, to);
  if (to.load) {
    BearingState begin = from.state;
    static_cast<Excitation&>(begin) = excitation;
    advance_to_load(stepper_, begin, *to.load, least_load * to.load->norm(), foils_->clearance + foils_->rise, step_);
  } else {
    stepper_.advance(from.state, excitation, step_);
  }
  return checked();
}

TangentMatrices BearingStepper::tangents(const ReachedState& state) {
  const std::scoped_lock lock(mutex_);
  return stepper_.tangents(state.state);
}

void add_stepper(py::module_& m) {
  py::class_<ReachedState, std::shared_ptr<ReachedState>>(m, "ReachedState")
      .def_property_readonly("status",
                             [](const ReachedState& self) { return std::string(name_of(self.increment.status)); })
      .def_property_readonly("explanation",
                             [](const ReachedState& self) { return std::string(explanation(self.increment.status)); })
      .def_property_readonly("position",
                             [](const ReachedState& self) -> Eigen::Vector2d {
                               return {self.increment.x, self.increment.y};
                             })
      .def_property_readonly("force",
                             [](const ReachedState& self) -> Eigen::Vector2d {
                               return {self.increment.force_x, self.increment.force_y};
                             })
      .def_property_readonly("elastic_energy", [](const ReachedState& self) { return self.increment.elastic_energy; })
      .def_property_readonly("dissipated_energy",
                             [](const ReachedState& self) { return self.increment.dissipated_energy; })
      .def_property_readonly("work", [](const ReachedState& self) { return self.increment.work; })
      .def("fields", [](const py::object& self) { return row_views(self.cast<const ReachedState&>().fields, self); });
  const auto destination = [](std::optional<Eigen::Vector2d> position, std::optional<Eigen::Vector2d> load,
                              std::optional<Vector> top_load) {
    return Destination{std::move(position), std::move(load), std::move(top_load)};
  };
  using Place = std::optional<Eigen::Vector2d>;
  const auto shared = [](SharedState state) { return std::const_pointer_cast<ReachedState>(std::move(state)); };
  py::class_<BearingStepper>(m, "BearingStepper")
      .def(py::init([](const CaseSource& source) { return std::make_unique<BearingStepper>(read_source(source)); }))
      .def(py::init<const BearingStepper&>())
      .def("assemble",
           [=](BearingStepper& self, Place position, std::optional<Vector> top_load) {
             const Destination to = destination(std::move(position), {}, std::move(top_load));
             const py::gil_scoped_release unlocked;
             return shared(self.assemble(to));
           })
      .def("advance",
           [=](BearingStepper& self, const ReachedState& from, Place position, Place load,
               std::optional<Vector> top_load) {
             const Destination to = destination(std::move(position), std::move(load), std::move(top_load));
             const py::gil_scoped_release unlocked;
             return shared(self.advance(from, to));
           })
      .def("tangents", [](BearingStepper& self, const ReachedState& state) {
        const TangentMatrices tangents = [&] {
          const py::gil_scoped_release unlocked;
          return self.tangents(state);
        }();
        return std::pair(tangents.loading, tangents.unloading);
      });
}

}  // namespace bumpfoil
