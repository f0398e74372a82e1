#pragma once

// Function multiversioning: one portable binary that uses AVX2 where the processor has it (AVX-512 was no faster).
// Sanitizers cannot run before the resolver, and clang 14 lacks architecture levels here; both get the portable code.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__ELF__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define STOSS_MULTIVERSION __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define STOSS_MULTIVERSION
#endif
