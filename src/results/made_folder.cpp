#include "bumpfoil/results/made_folder.hpp"

#include <unistd.h>

#include <system_error>

#include "results/posix_file.hpp"

namespace bumpfoil {

namespace fs = std::filesystem;

MadeFolder::MadeFolder(const fs::path& path) {
  std::error_code code;
  for (fs::path missing = path; !missing.empty() && !fs::exists(missing, code); missing = missing.parent_path()) {
    made_.push_back(missing);
  }
  fs::create_directories(path, code);
  if (code) throw_unwritable(path, code.value());
}

MadeFolder::~MadeFolder() {
  for (const fs::path& folder : made_) ::rmdir(folder.c_str());
}

}  // namespace bumpfoil
