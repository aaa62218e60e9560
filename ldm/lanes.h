#pragma once
/// Several integers side by side in one register of the processor (no paper section).
///
/// The compiler's vector extension (g++ and clang): the same source becomes SSE on x86 and NEON on
/// ARM, with the same bits. Where the extension has no word for one instruction that both
/// processors have, a function names it, and `plain` holds what it means on any other.
#include <algorithm>
#include <cstdint>

#if defined(__SSSE3__)
#include <tmmintrin.h>
#elif defined(__ARM_NEON)
#include <arm_neon.h>
#endif

namespace ldm {

using Halves = std::int16_t __attribute__((vector_size(16)));  ///< eight of 16 bits
using Lanes = std::int32_t __attribute__((vector_size(16)));   ///< four of 32 bits
using Words = std::int64_t __attribute__((vector_size(16)));   ///< two of 64 bits

/// The smaller in each half, where a negative number counts as larger than any other.
inline Halves unsigned_min(const Halves& a, const Halves& b) {
  using Unsigned = std::uint16_t __attribute__((vector_size(16)));
  const auto x = reinterpret_cast<Unsigned>(a);
  const auto y = reinterpret_cast<Unsigned>(b);
  return reinterpret_cast<Halves>(x < y ? x : y);
}

namespace plain {

inline Halves saturating_sum(const Halves& a, const Halves& b) {
  Halves sum{};
  for (int i = 0; i < 8; ++i) {
    sum[i] = static_cast<std::int16_t>(std::clamp(a[i] + b[i], INT16_MIN, INT16_MAX));
  }
  return sum;
}

inline Halves rounded_product(const Halves& a, const Halves& b) {
  Halves product{};
  for (int i = 0; i < 8; ++i) {
    product[i] = static_cast<std::int16_t>((a[i] * b[i] + (1 << 14)) >> 15);
  }
  return product;
}

inline Lanes sum_of_products(const Halves& a, const Halves& b) {
  Lanes sum{};
  for (int i = 0; i < 4; ++i) sum[i] = a[2 * i] * b[2 * i] + a[2 * i + 1] * b[2 * i + 1];
  return sum;
}

}  // namespace plain

/// a + b in each half; the nearest number that fits, where the sum does not.
inline Halves saturating_sum(const Halves& a, const Halves& b) {
#if defined(__SSSE3__)
  return reinterpret_cast<Halves>(
      _mm_adds_epi16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#elif defined(__ARM_NEON)
  return reinterpret_cast<Halves>(
      vqaddq_s16(reinterpret_cast<int16x8_t>(a), reinterpret_cast<int16x8_t>(b)));
#else
  return plain::saturating_sum(a, b);
#endif
}

/// a b / 2^15 in each half, rounded to nearest, ties up; requires a or b > -2^15.
inline Halves rounded_product(const Halves& a, const Halves& b) {
#if defined(__SSSE3__)
  return reinterpret_cast<Halves>(
      _mm_mulhrs_epi16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#elif defined(__ARM_NEON)
  return reinterpret_cast<Halves>(
      vqrdmulhq_s16(reinterpret_cast<int16x8_t>(a), reinterpret_cast<int16x8_t>(b)));
#else
  return plain::rounded_product(a, b);
#endif
}

/// a_0 b_0 + a_1 b_1 of each two neighbouring halves; requires a or b > -2^15.
inline Lanes sum_of_products(const Halves& a, const Halves& b) {
#if defined(__SSSE3__)
  return reinterpret_cast<Lanes>(
      _mm_madd_epi16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#elif defined(__ARM_NEON)
  const auto x = reinterpret_cast<int16x8_t>(a);
  const auto y = reinterpret_cast<int16x8_t>(b);
  return reinterpret_cast<Lanes>(vpaddq_s32(vmull_s16(vget_low_s16(x), vget_low_s16(y)),
                                            vmull_s16(vget_high_s16(x), vget_high_s16(y))));
#else
  return plain::sum_of_products(a, b);
#endif
}

}  // namespace ldm
