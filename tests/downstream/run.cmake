# Installs a build tree into a fresh prefix, then configures, builds and runs a project that uses only this prefix.
cmake_minimum_required(VERSION 3.25)

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " line)
    message(FATAL_ERROR "failed (${status}): ${line}")
  endif()
endfunction()

file(REMOVE_RECURSE "${SCRATCH}")
run(${CMAKE_COMMAND} --install "${BUILD_TREE}" --prefix "${SCRATCH}/prefix")
run(${CMAKE_COMMAND} -S "${PROJECT}" -B "${SCRATCH}/build" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${SCRATCH}/prefix"
  "-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF"
  "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}"
  "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
  "-DCMAKE_CXX_FLAGS=${CXX_FLAGS}")
file(STRINGS "${SCRATCH}/build/CMakeCache.txt" found REGEX "^stoss_DIR:")
string(FIND "${found}" "=${SCRATCH}/prefix/" inside)
if(inside EQUAL -1)
  message(FATAL_ERROR "found a stoss outside the prefix: ${found}")
endif()
run(${CMAKE_COMMAND} --build "${SCRATCH}/build")
run("${SCRATCH}/build/downstream")
