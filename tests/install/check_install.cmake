# Installs into one prefix, moves it to another, runs the program from there and builds a consumer against it
# by each of the compilers.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\nfailed with ${result}:\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
set(prefix "${WORK_DIR}/moved elsewhere")  # a space, because people have them
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/first)
file(RENAME ${WORK_DIR}/first ${prefix})

# Nothing that CMake reads later may point back at the sources or the build.
file(GLOB_RECURSE package_files "${prefix}/*.cmake")
if(NOT package_files)
  message(FATAL_ERROR "No CMake package was installed.")
endif()
foreach(file IN LISTS package_files)
  file(READ "${file}" text)
  foreach(place ${SOURCE_DIR} ${BUILD_DIR} ${WORK_DIR})
    string(FIND "${text}" "${place}" found)
    if(NOT found EQUAL -1)
      message(FATAL_ERROR "${file} is not relocatable: it names ${place}")
    endif()
  endforeach()
endforeach()

run("${prefix}/bin/bumpfoil" --version)
run("${prefix}/bin/bumpfoil" init -o ${WORK_DIR}/case.toml)
run("${prefix}/bin/bumpfoil" cycle ${WORK_DIR}/case.toml --set cycle.steps=10 -o ${WORK_DIR}/results)
foreach(name summary.json cycle.csv result.nc)
  if(NOT EXISTS ${WORK_DIR}/results/${name})
    message(FATAL_ERROR "The moved program wrote no ${name}.")
  endif()
endforeach()

# Manual and completions are where they are looked for, and what the README links to is beside it.
foreach(name man/man1/bumpfoil.1 bash-completion/completions/bumpfoil doc/bumpfoil/README.md doc/bumpfoil/docs/index.md
        doc/bumpfoil/examples/gen1.toml doc/bumpfoil/include/bumpfoil/experiments/cycle/cycle.hpp)
  if(NOT EXISTS "${prefix}/share/${name}")
    message(FATAL_ERROR "No share/${name} was installed.")
  endif()
endforeach()

# What the studies need moves with it.
run("${prefix}/bin/bumpfoil" reproduce --figure 16 -o ${WORK_DIR}/paper)

# Its page moves with it.
if(HAS_REPORT)
  run("${prefix}/bin/bumpfoil" report ${WORK_DIR}/results)
endif()

list(JOIN FLAGS " " flags)
string(REPLACE "," ";" COMPILERS "${COMPILERS}")
foreach(compiler IN LISTS COMPILERS)
  file(REMOVE_RECURSE ${WORK_DIR}/consumer)
  run(${CMAKE_COMMAND} -S ${CONSUMER_DIR} -B ${WORK_DIR}/consumer -G Ninja -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
      -DCMAKE_CXX_COMPILER=${compiler} "-DCMAKE_CXX_FLAGS=${flags}" "-DCMAKE_PREFIX_PATH=${prefix}")
  run(${CMAKE_COMMAND} --build ${WORK_DIR}/consumer)
  run(${WORK_DIR}/consumer/consumer)
  message("${compiler}:\n${output}")
endforeach()
