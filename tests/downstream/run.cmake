# Installs a build tree, moves what was installed, and builds and runs a user's project against it: with CMake and with
# pkg-config.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " line)
    message(FATAL_ERROR "failed (${status}): ${line}")
  endif()
endfunction()

file(REMOVE_RECURSE "${SCRATCH}")
run(${CMAKE_COMMAND} --install "${BUILD_TREE}" --prefix "${SCRATCH}/first")
file(RENAME "${SCRATCH}/first" "${SCRATCH}/prefix")

run(${CMAKE_COMMAND} -S "${PROJECT}" -B "${SCRATCH}/build" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${SCRATCH}/prefix"
  "-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF"
  "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}"
  "-DEXAMPLES=${SOURCE}/examples/library")
file(STRINGS "${SCRATCH}/build/CMakeCache.txt" found REGEX "^stoss_DIR:")
string(FIND "${found}" "=${SCRATCH}/prefix/" inside)
if(inside EQUAL -1)
  message(FATAL_ERROR "found a stoss outside the prefix: ${found}")
endif()
run(${CMAKE_COMMAND} --build "${SCRATCH}/build")
run("${SCRATCH}/build/downstream")
foreach(example impact pairs oblique)
  execute_process(COMMAND "${SCRATCH}/build/examples/${example}" OUTPUT_VARIABLE got COMMAND_ERROR_IS_FATAL ANY)
  file(READ "${PROJECT}/${example}.txt" expected)
  if(NOT got STREQUAL expected)
    message(FATAL_ERROR "${example} printed\n${got}docs/reference/cpp.md shows\n${expected}")
  endif()
endforeach()

# What `pkg-config OPTIONS stoss` says of the .pc file in a folder, as a list of words.
function(pkg_config result folder)
  execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=PKG_CONFIG_PATH "PKG_CONFIG_LIBDIR=${folder}"
    pkg-config ${ARGN} stoss COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE words OUTPUT_STRIP_TRAILING_WHITESPACE)
  separate_arguments(words UNIX_COMMAND "${words}")
  set(${result} ${words} PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE pc "${SCRATCH}/prefix/stoss.pc")
cmake_path(GET pc PARENT_PATH folder)
pkg_config(flags "${folder}" --cflags --libs)
separate_arguments(own UNIX_COMMAND "${CXX_FLAGS}")
run(${CXX_COMPILER} -std=c++20 ${own} "${PROJECT}/main.cpp" ${flags} -o "${SCRATCH}/by_pkg_config")
run(${CMAKE_COMMAND} -E env "LD_LIBRARY_PATH=${folder}/.." "${SCRATCH}/by_pkg_config")
# With an older standard every header says what it needs, before anything else is wrong.
file(GLOB_RECURSE headers RELATIVE "${SCRATCH}/prefix/include" "${SCRATCH}/prefix/include/*.hpp")
foreach(header IN LISTS headers)
  file(WRITE "${SCRATCH}/older.cpp" "#include <${header}>\n")
  execute_process(COMMAND ${CXX_COMPILER} -std=c++17 -fsyntax-only -Wfatal-errors "${SCRATCH}/older.cpp" ${flags}
    OUTPUT_QUIET ERROR_VARIABLE said)
  string(REGEX MATCH "error: [^\n]*" first "${said}")
  if(NOT first MATCHES "stoss needs C[+][+]20")
    message(FATAL_ERROR "${header} in C++17 says '${first}'")
  endif()
endforeach()
pkg_config(version "${folder}" --modversion)
if(NOT version STREQUAL VERSION)
  message(FATAL_ERROR "pkg-config says version ${version}, the project is ${VERSION}")
endif()

# What a static library needs, its users are told; a shared one brings it.
foreach(shared ON OFF)
  set(tree "${SCRATCH}/shared_${shared}")
  run(${CMAKE_COMMAND} -S "${SOURCE}" -B "${tree}" -G "${GENERATOR}" -DBUILD_SHARED_LIBS=${shared} -DSTOSS_BUILD_CLI=OFF
    "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}")
  pkg_config(plain "${tree}" --libs-only-other)
  pkg_config(static "${tree}" --libs-only-other --static)
  if(NOT static STREQUAL "-pthread" OR (shared AND plain) OR (NOT shared AND NOT plain STREQUAL "-pthread"))
    message(FATAL_ERROR "shared ${shared}: pkg-config gives '${plain}', with --static '${static}'")
  endif()
endforeach()
