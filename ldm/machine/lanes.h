#pragma once
/// Several numbers side by side in one register of the processor (no paper section).
///
/// The compiler's vector extension (g++ and clang): the same source becomes SSE on x86 and NEON on
/// ARM, with the same bits. Where the extension has no word for one instruction that both
/// processors have, a function names it, and `portable` holds what it means on any other.
#include <algorithm>
#include <cstdint>

#if defined(__SSSE3__)
#include <tmmintrin.h>
#elif defined(__ARM_NEON)
#include <arm_neon.h>
#endif

namespace ldm {

using Int16x8 = std::int16_t __attribute__((vector_size(16)));
using UInt16x8 = std::uint16_t __attribute__((vector_size(16)));  ///< sums wrap
using Int32x4 = std::int32_t __attribute__((vector_size(16)));
using Int64x2 = std::int64_t __attribute__((vector_size(16)));
using UInt8x16 = std::uint8_t __attribute__((vector_size(16)));
using Float32x4 = float __attribute__((vector_size(16)));

/// True if all lanes are 0.
inline bool is_zero(const UInt8x16& a) {
  const auto words = reinterpret_cast<Int64x2>(a);
  return (words[0] | words[1]) == 0;
}

/// The smaller in each lane.
inline UInt16x8 lower(const UInt16x8& a, const UInt16x8& b) {
  return a < b ? a : b;
}

namespace portable {

inline Int16x8 saturating_sum(const Int16x8& a, const Int16x8& b) {
  Int16x8 sum{};
  for (int i = 0; i < 8; ++i) {
    sum[i] = static_cast<std::int16_t>(std::clamp(a[i] + b[i], INT16_MIN, INT16_MAX));
  }
  return sum;
}

inline Int16x8 rounded_product(const Int16x8& a, const Int16x8& b) {
  Int16x8 product{};
  for (int i = 0; i < 8; ++i) {
    product[i] = static_cast<std::int16_t>((a[i] * b[i] + (1 << 14)) >> 15);
  }
  return product;
}

inline Int32x4 sum_of_products(const Int16x8& a, const Int16x8& b) {
  Int32x4 sum{};
  for (int i = 0; i < 4; ++i) sum[i] = a[2 * i] * b[2 * i] + a[2 * i + 1] * b[2 * i + 1];
  return sum;
}

}  // namespace portable

/// a + b in each lane; the nearest number that fits, where the sum does not.
inline Int16x8 saturating_sum(const Int16x8& a, const Int16x8& b) {
#if defined(__SSSE3__)
  return reinterpret_cast<Int16x8>(
      _mm_adds_epi16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#elif defined(__ARM_NEON)
  return reinterpret_cast<Int16x8>(
      vqaddq_s16(reinterpret_cast<int16x8_t>(a), reinterpret_cast<int16x8_t>(b)));
#else
  return portable::saturating_sum(a, b);
#endif
}

/// a b / 2^15 in each lane, rounded to nearest, ties up; requires a or b > -2^15.
inline Int16x8 rounded_product(const Int16x8& a, const Int16x8& b) {
#if defined(__SSSE3__)
  return reinterpret_cast<Int16x8>(
      _mm_mulhrs_epi16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#elif defined(__ARM_NEON)
  return reinterpret_cast<Int16x8>(
      vqrdmulhq_s16(reinterpret_cast<int16x8_t>(a), reinterpret_cast<int16x8_t>(b)));
#else
  return portable::rounded_product(a, b);
#endif
}

/// a_0 b_0 + a_1 b_1 of each two neighbouring lanes; requires a or b > -2^15.
inline Int32x4 sum_of_products(const Int16x8& a, const Int16x8& b) {
#if defined(__SSSE3__)
  return reinterpret_cast<Int32x4>(
      _mm_madd_epi16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#elif defined(__ARM_NEON)
  const auto x = reinterpret_cast<int16x8_t>(a);
  const auto y = reinterpret_cast<int16x8_t>(b);
  return reinterpret_cast<Int32x4>(vpaddq_s32(vmull_s16(vget_low_s16(x), vget_low_s16(y)),
                                              vmull_s16(vget_high_s16(x), vget_high_s16(y))));
#else
  return portable::sum_of_products(a, b);
#endif
}

}  // namespace ldm
