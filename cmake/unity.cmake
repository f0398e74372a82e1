# With CMAKE_UNITY_BUILD, as the presets have it, the files of a folder that use the same namespaces are compiled as
# one: headers are read and templates made once a folder. Such files keep names of their own.
function(stoss_unity_by_folder target)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source OUTPUT_VARIABLE path)
    cmake_path(GET path PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    file(STRINGS ${path} used REGEX "^using namespace")
    string(MAKE_C_IDENTIFIER "${folder} ${used}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# Fuzzers see which branches are taken in a folder, which is compiled as one or file by file; the rest of the target
# stays as it is, and as fast.
function(stoss_fuzzed_folder target folder)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "^${folder}/[^/]*$")
  foreach(source IN LISTS sources)
    if(CMAKE_UNITY_BUILD)
      get_source_file_property(group ${source} UNITY_GROUP)
      set(source ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/Unity/unity_${group}_cxx.cxx)
    endif()
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS ${STOSS_FUZZ_COVERAGE})
  endforeach()
endfunction()
