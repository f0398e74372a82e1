# For compilers that must not see /usr/include, or whose C++ library is not the one that Debian's packages were compiled
# with: the libraries that stoss takes from there as headers alone, linked into a folder by themselves. Toolchain files
# name this file as CMAKE_PROJECT_stoss_INCLUDE.
set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(name boost CLI eigen3/Eigen fmt nlohmann Random123)
  cmake_path(GET name FILENAME folder)
  find_path(STOSS_${folder}_PARENT ${name} PATHS /usr/include /usr/local/include REQUIRED NO_DEFAULT_PATH
    NO_CMAKE_FIND_ROOT_PATH)
  file(CREATE_LINK ${STOSS_${folder}_PARENT}/${name} ${headers}/${folder} SYMBOLIC)
endforeach()
set(STOSS_RANDOM123_INCLUDE_DIR ${headers})

# What find_package finds from here on.
function(stoss_take_headers package target)
  string(TOLOWER ${package} name)
  file(WRITE ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/${name}-config.cmake
    "if(NOT TARGET ${target})\n  add_library(${target} INTERFACE IMPORTED GLOBAL)\n"
    "  target_include_directories(${target} SYSTEM INTERFACE ${headers})\n"
    "  target_compile_definitions(${target} INTERFACE ${ARGN})\nendif()\n")
  file(WRITE ${CMAKE_FIND_PACKAGE_REDIRECTS_DIR}/${name}-config-version.cmake
    "set(PACKAGE_VERSION_COMPATIBLE TRUE)\n")
endfunction()
stoss_take_headers(Boost Boost::headers)
stoss_take_headers(CLI11 CLI11::CLI11)
stoss_take_headers(Eigen3 Eigen3::Eigen)
stoss_take_headers(fmt fmt::fmt FMT_HEADER_ONLY)
stoss_take_headers(nlohmann_json nlohmann_json::nlohmann_json)
