# What Debian wants in a package beside what an install has; CPack runs it on the staged files.
set(usr ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr)
set(doc ${usr}/share/doc/bumpfoil)

# The licence stands in the copyright file, and the program once.
file(REMOVE ${doc}/LICENSE)
file(COPY_FILE ${BUMPFOIL_COPYRIGHT} ${doc}/copyright)
set(package ${usr}/lib/python3/dist-packages/bumpfoil)
if(EXISTS ${usr}/bumpfoil)
  file(MAKE_DIRECTORY ${usr}/lib/python3/dist-packages)
  file(RENAME ${usr}/bumpfoil ${package})
  file(REMOVE ${package}/program)
  file(CREATE_LINK ../../../../bin/bumpfoil ${package}/program SYMBOLIC)
endif()

# Nothing in what was compiled that only its makers need.
file(GLOB_RECURSE shared ${usr}/lib/*.so)
file(GLOB_RECURSE static ${usr}/lib/*.a)
execute_process(COMMAND strip --strip-unneeded --remove-section=.comment ${usr}/bin/bumpfoil ${shared} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND strip --strip-debug --remove-section=.comment ${static} COMMAND_ERROR_IS_FATAL ANY)

# Debian's changelog has an entry for each version of the package.
file(STRINGS ${BUMPFOIL_CHANGELOG} released REGEX "^## \\[${CPACK_PACKAGE_VERSION}\\] - ")
string(REGEX REPLACE ".* - " "" day "${released}")
execute_process(COMMAND env LC_ALL=C date --utc --rfc-email --date=${day} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${doc}/changelog "bumpfoil (${CPACK_PACKAGE_VERSION}) stable; urgency=medium

  * What is new is told in CHANGELOG.md beside this file.

 -- ${CPACK_PACKAGE_CONTACT}  ${date}
")
execute_process(COMMAND gzip --best --no-name ${doc}/changelog ${usr}/share/man/man1/bumpfoil.1 COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND chmod -R go-w,go+rX ${usr} COMMAND_ERROR_IS_FATAL ANY)
