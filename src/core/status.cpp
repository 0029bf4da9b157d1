#include "bumpfoil/core/status.hpp"

namespace bumpfoil {
namespace {

constexpr std::array<std::string_view, enum_names<Status>.size()> explanations{
    "converged",
    "no combination of contact modes was found that satisfies all contact conditions",
    "no equilibrium was found for large displacements: the foils may have snapped to another shape",
    "the iterations of the solver ended before its tolerances were met",
    "the response could not be followed without breaking the balance of energies",
    "the residuals of the state exceed the bounds of its solver",
    "the load is not met before the bumps are pressed flat",
    "the position that meets the load was not found",
    "the run was interrupted",
    "the equilibrium of the journal under its load is unstable",
    "the load does not determine the journal position: nothing resists its motion",
    "Newton's method finds no state, even with the smallest steps",
    "touchdown: the film is thinner than the contact threshold film.h_floor",
    "the journal does not fit between the undeformed foils where the path starts",
    "the branch of states ends, and the film does not settle to another state",
    "not computed, since an earlier state of its path was not found",
};

}  // namespace

std::string_view explanation(Status status) {
  return explanations.at(static_cast<std::size_t>(status));
}

}  // namespace bumpfoil
