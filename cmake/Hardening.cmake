# What compiler and linker have against damaged memory, in the target bumpfoil_hardening; in optimised builds alone, as
# _FORTIFY_SOURCE needs the optimiser. Left out under the sanitizers, which see more and do not go along with it.
include(CheckCXXCompilerFlag)
include(CheckCXXSourceCompiles)
include(CheckLinkerFlag)
include(CheckPIESupported)

add_library(bumpfoil_hardening INTERFACE)
if(BUMPFOIL_SANITIZE)
  return()
endif()

check_pie_supported(LANGUAGES CXX)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(optimised "$<CONFIG:Release,RelWithDebInfo,MinSizeRel>")
foreach(flag -fstack-protector-strong -fcf-protection)
  string(MAKE_C_IDENTIFIER "BUMPFOIL_HAS${flag}" has_flag)
  check_cxx_compiler_flag(${flag} ${has_flag})
  if(${has_flag})
    target_compile_options(bumpfoil_hardening INTERFACE $<${optimised}:${flag}>)
  endif()
endforeach()
foreach(flag -Wl,-z,relro -Wl,-z,now)
  string(MAKE_C_IDENTIFIER "BUMPFOIL_HAS${flag}" has_flag)
  check_linker_flag(CXX ${flag} ${has_flag})
  if(${has_flag})
    target_link_options(bumpfoil_hardening INTERFACE $<${optimised}:${flag}>)
  endif()
endforeach()

# Level 3 also checks objects whose size is known at run time alone. Distributions may have set one already, which some
# compilers warn about when it is set again.
foreach(level 3 2)
  set(CMAKE_REQUIRED_FLAGS "-O2 -Werror -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=${level}")
  check_cxx_source_compiles("#include <cstring>\nint main() {}" BUMPFOIL_HAS_FORTIFY_${level})
  unset(CMAKE_REQUIRED_FLAGS)
  if(BUMPFOIL_HAS_FORTIFY_${level})
    target_compile_options(bumpfoil_hardening INTERFACE
                           "$<${optimised}:-U_FORTIFY_SOURCE;-D_FORTIFY_SOURCE=${level}>")
    break()
  endif()
endforeach()
