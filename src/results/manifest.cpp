#include "results/manifest.hpp"

#include <fmt/format.h>

#include <random>
#include <utility>

#include "bumpfoil/results/checksum.hpp"

namespace bumpfoil {

std::string make_run_id() {
  std::random_device random;
  return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

Manifest make_manifest(std::string run_id, const std::vector<ResultFile>& files) {
  Manifest manifest{std::move(run_id), {}};
  for (const ResultFile& file : files) {
    manifest.files.push_back({file.name, file.contents.size(), xxh3_128(file.contents)});
  }
  return manifest;
}

}  // namespace bumpfoil
