// The solver as the page of `bumpfoil designer` runs it: WebAssembly that answers requests in JSON.

#include <exception>
#include <string>

#include "bumpfoil/pages/designer.hpp"

namespace {

/// Of the last answer, until the next request.
std::string last_answer;

}  // namespace

/// @return  the answer to a request, both ended by zero; it stays until the next call
extern "C" const char* bumpfoil_answer(const char* request) {
  try {
    last_answer = bumpfoil::designer_answer(request);
  } catch (const std::exception& error) {
    last_answer = std::string("!") + error.what();
  }
  return last_answer.c_str();
}
