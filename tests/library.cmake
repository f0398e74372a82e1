# Tests are found by their names, test_*.cpp and test_*.py: here those of the library, by room. The programs of
# docs/architecture.md and of examples/ belong to them. Under sanitizers, which make them slow to build and to run, those
# of rooms that handle memory may be enough, STOSS_TEST_ROOMS, and of the command those not marked `numbers`.
set(STOSS_TEST_ROOMS "" CACHE STRING "Folders of tests/ whose tests of the library are built; empty: all")
option(STOSS_TESTS_BY_ROOM "Build a program of each folder of tests of the library, and nothing else (preset dev)" OFF)
set(rooms ${STOSS_TEST_ROOMS})
list(TRANSFORM rooms REPLACE "(.+)" "\\1/test_*.cpp")
if(NOT rooms)
  set(rooms test_*.cpp)
endif()
file(GLOB_RECURSE library_tests CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${rooms})
list(FILTER library_tests EXCLUDE REGEX "^cli/")

# What tests of a room need besides.
file(GLOB besides_bench ${PROJECT_SOURCE_DIR}/bench/*_mesh.cpp ${PROJECT_SOURCE_DIR}/bench/element_*.cpp
  ${PROJECT_SOURCE_DIR}/bench/finite_elements.cpp)
file(GLOB_RECURSE besides_studies ${PROJECT_SOURCE_DIR}/studies/adhesion/*.cpp
  ${PROJECT_SOURCE_DIR}/studies/yield/*.cpp)
list(FILTER besides_studies EXCLUDE REGEX "/main[.]cpp$")
set(besides_examples ${PROJECT_SOURCE_DIR}/examples/gas/collision.cpp ${PROJECT_SOURCE_DIR}/examples/gas/gas.cpp)
set(besides_identities ${CMAKE_CURRENT_SOURCE_DIR}/identities/cases.cpp
  ${CMAKE_CURRENT_SOURCE_DIR}/identities/contacts.cpp)
set(besides_docs ${CMAKE_CURRENT_SOURCE_DIR}/docs/src/bodies/hammer.cpp)
set_source_files_properties(${besides_bench} PROPERTIES COMPILE_OPTIONS "-O3;-fopenmp-simd" SKIP_PRECOMPILE_HEADERS ON)
set_source_files_properties(bench/test_finite_elements.cpp PROPERTIES INCLUDE_DIRECTORIES ${PROJECT_SOURCE_DIR})
set_source_files_properties(support/csv.cpp PROPERTIES
  COMPILE_DEFINITIONS STOSS_TEST_DATA="${CMAKE_CURRENT_SOURCE_DIR}/data")

# A program of some tests of the library.
function(stoss_library_tests target)
  set(sources ${ARGN} support/csv.cpp support/complementarity.cpp)
  foreach(test IN LISTS ARGN)
    string(REGEX REPLACE "/.*" "" room ${test})
    list(APPEND sources ${besides_${room}})
  endforeach()
  list(REMOVE_DUPLICATES sources)
  add_executable(${target} ${sources})
  target_link_libraries(${target} PRIVATE stoss::stoss stoss_around GTest::gtest_main Boost::headers Eigen3::Eigen
    Threads::Threads)
  target_precompile_headers(${target} PRIVATE <gtest/gtest.h>)
  # The private rooms are tested too.
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src
    ${PROJECT_SOURCE_DIR}/studies docs/include)
  stoss_unity_by_folder(${target})
endfunction()

if(STOSS_TESTS_BY_ROOM)
  # A program is linked again when its tests change, not when the library does.
  set(CMAKE_LINK_DEPENDS_NO_SHARED ON)
  set(names "")
  foreach(test IN LISTS library_tests)
    cmake_path(GET test PARENT_PATH folder)
    string(MAKE_C_IDENTIFIER "try_${folder}" name)
    list(APPEND names ${name})
    list(APPEND tests_of_${name} ${test})
  endforeach()
  list(REMOVE_DUPLICATES names)
  foreach(name IN LISTS names)
    stoss_library_tests(${name} ${tests_of_${name}})
    set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    stoss_gtest(${name} ${name} 4)
  endforeach()
else()
  stoss_library_tests(stoss_tests ${library_tests})
  stoss_gtest(library stoss_tests 8)
endif()
