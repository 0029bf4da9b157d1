#include "bumpfoil/core/error.hpp"
#include "case/text_file.hpp"

namespace bumpfoil {

/// A page has no files: whatever names one is told to hold what is in it.
std::string read_text_file(const std::string& path) {
  throw Error(ErrorKind::file, {{path, 0, "", "", "cannot be read: a page has no files beside the case",
                                 "give what it holds in the case itself, as a list"}});
}

}  // namespace bumpfoil
