# bumpfoil_embed_files(<target> <source> [<name> <file>]...): compiles the bytes of files into a target, as one source of
# its build, so that the program stays one file that can be moved. The code that reads them declares
#
#     namespace bumpfoil { std::string_view <name>(); }
set(BUMPFOIL_EMBED_TEMPLATE [=[
// The bytes of @BUMPFOIL_EMBED_NAME@.
asm(R"(
  .section .rodata
  .global bumpfoil_bytes_@BUMPFOIL_EMBED_NAME@
  .global bumpfoil_bytes_end_@BUMPFOIL_EMBED_NAME@
bumpfoil_bytes_@BUMPFOIL_EMBED_NAME@:
  .incbin "@BUMPFOIL_EMBED_FILE@"
bumpfoil_bytes_end_@BUMPFOIL_EMBED_NAME@:
  .byte 0
  .previous
)");

extern "C" const char bumpfoil_bytes_@BUMPFOIL_EMBED_NAME@[];
extern "C" const char bumpfoil_bytes_end_@BUMPFOIL_EMBED_NAME@[];

namespace bumpfoil {

std::string_view @BUMPFOIL_EMBED_NAME@() {
  return {bumpfoil_bytes_@BUMPFOIL_EMBED_NAME@, bumpfoil_bytes_end_@BUMPFOIL_EMBED_NAME@};
}

}  // namespace bumpfoil
]=])

function(bumpfoil_embed_files target source)
  set(code "// Written by CMake.\n#include <string_view>\n")
  set(files "")
  while(ARGN)
    list(POP_FRONT ARGN BUMPFOIL_EMBED_NAME file)
    get_filename_component(BUMPFOIL_EMBED_FILE "${file}" ABSOLUTE)
    string(CONFIGURE "${BUMPFOIL_EMBED_TEMPLATE}" embedded @ONLY)
    string(APPEND code "${embedded}")
    list(APPEND files "${BUMPFOIL_EMBED_FILE}")
  endwhile()
  set(path "${CMAKE_CURRENT_BINARY_DIR}/${source}")
  file(CONFIGURE OUTPUT "${path}" CONTENT "${code}" @ONLY)
  # By itself: as part of a batch it would not be compiled anew with the files.
  set_source_files_properties("${path}" TARGET_DIRECTORY ${target}
                              PROPERTIES OBJECT_DEPENDS "${files}" SKIP_UNITY_BUILD_INCLUSION ON
                                         SKIP_PRECOMPILE_HEADERS ON)
  target_sources(${target} PRIVATE "${path}")
endfunction()
