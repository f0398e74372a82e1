# What makes a memory error less useful to an attacker, where the tools have it: bounds of buffers that the C library
# checks, in optimised code only; addresses of functions that are read-only from the start; stacks that are no code.
# Programs are position-independent as compilers make them by default. What is built is looked at by
# tests/cli/test_hardened.py and tests/portable/test_guarded.py.
include(CheckCXXCompilerFlag)
include(CheckLinkerFlag)

# WebAssembly has none of it; programs for Windows are no ELF, and would need a library more.
if(EMSCRIPTEN OR WIN32)
  return()
endif()

# A distribution may have set a lower level.
check_cxx_compiler_flag("-Werror -O1 -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3" STOSS_HAS_FORTIFY_3)
if(STOSS_HAS_FORTIFY_3)
  target_compile_options(stoss_settings INTERFACE
    $<$<CONFIG:Release>:-U_FORTIFY_SOURCE> $<$<CONFIG:Release>:-D_FORTIFY_SOURCE=3>)
endif()
foreach(word relro now noexecstack)
  check_linker_flag(CXX "-Wl,-z,${word}" STOSS_HAS_Z_${word})
  if(STOSS_HAS_Z_${word})
    target_link_options(stoss_settings INTERFACE LINKER:-z,${word})
  endif()
endforeach()
