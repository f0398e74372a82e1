# clang with LLVM's C++ library in place of GNU's.
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_C_COMPILER clang)
set(CMAKE_CXX_FLAGS_INIT "-stdlib=libc++ -Wno-pass-failed")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-stdlib=libc++")
set(CMAKE_PROJECT_stoss_INCLUDE ${CMAKE_CURRENT_LIST_DIR}/headers.cmake)
