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
