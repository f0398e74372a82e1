# Linux on 32-bit x86, from the Pentium 4 on: the 80-bit registers of older ones would round twice, and results would
# depend on what the compiler keeps in them. Static programs run on 64-bit x86 as they are.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR i686)
set(CMAKE_CXX_COMPILER i686-linux-gnu-g++)
set(CMAKE_C_COMPILER i686-linux-gnu-gcc)
set(CMAKE_CXX_FLAGS_INIT "-msse2 -mfpmath=sse")
set(CMAKE_C_FLAGS_INIT "-msse2 -mfpmath=sse")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
set(CMAKE_PROJECT_stoss_INCLUDE ${CMAKE_CURRENT_LIST_DIR}/headers.cmake)
