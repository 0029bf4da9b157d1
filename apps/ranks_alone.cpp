// The program without MPI: a single process. ranks_mpi.cpp replaces this file if MPI is available.

#include <array>
#include <cstdlib>
#include <string>

#include "bumpfoil/core/error.hpp"
#include "ranks.hpp"

namespace bumpfoil {

Ranks::Ranks() {
  for (const char* const name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* const size = std::getenv(name);
    if (size == nullptr || std::atoi(size) < 2) continue;
    throw Error(ErrorKind::input, {{"", 0, name, size, "ranks: this program was built without MPI",
                                    "build it where MPI is found, or start it without mpirun"}});
  }
}

Ranks::~Ranks() {}  // no other rank to wait for

void Ranks::send(int /*rank*/, Subject /*subject*/, const std::string& /*text*/) const {}

std::optional<Letter> Ranks::receive() const {
  return std::nullopt;
}

}  // namespace bumpfoil
