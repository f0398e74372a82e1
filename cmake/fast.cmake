# What makes building faster where it is there: a cache of what was compiled, and LLVM's linker.
option(STOSS_FAST "Use ccache and lld where they are installed" OFF)
if(STOSS_FAST AND PROJECT_IS_TOP_LEVEL)
  find_program(STOSS_CCACHE ccache)
  if(STOSS_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    # Of precompiled headers it is told that they have no names of their own, and no times.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${STOSS_CCACHE})
  endif()
  find_program(STOSS_LLD ld.lld)
  if(STOSS_LLD AND CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF" AND NOT CMAKE_CROSSCOMPILING)
    add_link_options(-fuse-ld=lld)
  endif()
endif()

# A library of those of its sources that match, and of what an archive of the whole of it has otherwise. All of its own
# objects are linked, so that none of the same source comes from the archive.
function(stoss_take_rest_from target archive pattern)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "${pattern}")
  set_target_properties(${target} PROPERTIES SOURCES "${sources}")
  target_link_options(${target} INTERFACE -Wl,--whole-archive $<TARGET_FILE:${target}> -Wl,--no-whole-archive)
  target_link_libraries(${target} INTERFACE ${archive})
endfunction()
