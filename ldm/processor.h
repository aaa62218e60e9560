#pragma once
/// What some processors can do and others cannot (no paper section).

/// Before a function: compiled twice, once for x86 processors with AVX2 and their like, and chosen
/// when the program is loaded. For loops that the compiler turns into vectors; the bits are the
/// same. Elsewhere, and with `NATIVE=1`, there is one.
#if defined(__x86_64__) && !defined(__AVX2__) && !defined(__clang__)
#define LDM_TWICE __attribute__((target_clones("arch=x86-64-v3", "default")))
#else
#define LDM_TWICE
#endif
