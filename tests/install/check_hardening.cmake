# The program carries what cmake/Hardening.cmake promises against damaged memory.
execute_process(COMMAND ${READELF} --wide --file-header --program-headers --dynamic --dyn-syms ${PROGRAM}
                OUTPUT_VARIABLE program COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${READELF} --wide --notes ${LIBRARY} OUTPUT_VARIABLE library COMMAND_ERROR_IS_FATAL ANY)

function(require text what)
  if(NOT text MATCHES "${what}")
    message(SEND_ERROR "There is no ${what} in what readelf says: ${ARGN} is missing.")
  endif()
endfunction()
require("${program}" "Type: +DYN" "position independence")
require("${program}" "GNU_RELRO" "the protection of relocations")
require("${program}" "BIND_NOW|Flags: NOW" "binding before the start, without which that is partial")
require("${program}" "__stack_chk_fail" "the stack protector")
require("${program}" "__(mem|str|read|vsn|sn|f|vf|poll)[a-z]*_chk" "_FORTIFY_SOURCE")
if(PROCESSOR MATCHES "x86_64|AMD64")
  require("${library}" "IBT, SHSTK" "control-flow protection")
endif()
