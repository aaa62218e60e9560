#pragma once
/// What some processors can do and others cannot (no paper section).
#include <cstddef>  // says which C library this is

/// Before a function: compiled twice, the second time for x86-64-v3 (AVX2, FMA, BMI), and chosen
/// when the program is loaded. For loops that the compiler turns into vectors; the bits are the
/// same, as nothing is fused (-ffp-contract=off). Compiled once where the whole build has AVX2, by
/// clang, and without glibc, which does the choosing and is not ready for it under a sanitizer.
#if defined(__x86_64__) && !defined(__AVX2__) && !defined(__clang__) && defined(__GLIBC__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LDM_TARGET_CLONES __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define LDM_TARGET_CLONES
#endif
