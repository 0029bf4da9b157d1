# bumpfoil_embed_file(<target> <name> <file>): compiles the bytes of a file into a target, so that the program stays one
# file that can be moved. The code that reads them declares
#
#     namespace bumpfoil { std::string_view <name>(); }
set(BUMPFOIL_EMBED_TEMPLATE "${CMAKE_CURRENT_LIST_DIR}/embedded_file.cpp.in")

function(bumpfoil_embed_file target name file)
  get_filename_component(BUMPFOIL_EMBED_FILE "${file}" ABSOLUTE)
  set(BUMPFOIL_EMBED_NAME "${name}")
  set(source "${CMAKE_CURRENT_BINARY_DIR}/embedded_${name}.cpp")
  configure_file("${BUMPFOIL_EMBED_TEMPLATE}" "${source}" @ONLY)
  # By itself: as part of a batch it would not be compiled anew with the file.
  set_source_files_properties("${source}" TARGET_DIRECTORY ${target}
                              PROPERTIES OBJECT_DEPENDS "${BUMPFOIL_EMBED_FILE}" SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE "${source}")
endfunction()
