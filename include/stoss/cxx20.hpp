// Every public header includes this, itself or through others: an older standard is refused in one clear line.
#pragma once

#if __cplusplus <= 201703L
#error "stoss needs C++20: compile with -std=c++20"
#endif
