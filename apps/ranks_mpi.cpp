// All calls to MPI. ranks_alone.cpp replaces this file without MPI.

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "ranks.hpp"

namespace bumpfoil {
namespace {

/// Without a launcher, MPI is not initialised: this would take longer than many runs.
bool has_launcher() {
  constexpr std::array names{"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"};
  return std::any_of(names.begin(), names.end(), [](const char* name) { return std::getenv(name) != nullptr; });
}

bool is_joined() {
  int joined = 0;
  MPI_Initialized(&joined);
  return joined != 0;
}

}  // namespace

Ranks::Ranks() {
  if (!has_launcher()) return;
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() {
  if (is_joined()) MPI_Finalize();
}

void Ranks::send(int rank, Subject subject, const std::string& text) const {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, rank, static_cast<int>(subject), MPI_COMM_WORLD);
}

std::optional<Letter> Ranks::receive() const {
  int has_come = 0;
  MPI_Status status;
  if (size_ > 1) MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &has_come, &status);
  if (has_come == 0) return std::nullopt;
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  Letter letter{.rank = status.MPI_SOURCE,
                .subject = static_cast<Subject>(status.MPI_TAG),
                .text = std::string(static_cast<std::size_t>(size), '\0')};
  MPI_Recv(letter.text.data(), size, MPI_CHAR, letter.rank, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return letter;
}

}  // namespace bumpfoil
