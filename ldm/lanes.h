#pragma once
/// Four integers side by side in one register of the processor (no paper section).
///
/// The compiler's vector extension (g++ and clang), not the intrinsics of one processor: the same
/// source becomes SSE on x86 and NEON on ARM, with the same bits.
#include <cstdint>

namespace ldm {

using Lanes = std::int32_t __attribute__((vector_size(16)));

using UnsignedLanes = std::uint32_t __attribute__((vector_size(16)));

/// `value` in each lane.
inline Lanes all_lanes(std::int32_t value) {
  return Lanes{value, value, value, value};
}

/// The smaller in each lane, where a negative number counts as larger than any other.
inline Lanes unsigned_min(const Lanes& a, const Lanes& b) {
  const auto x = reinterpret_cast<UnsignedLanes>(a);
  const auto y = reinterpret_cast<UnsignedLanes>(b);
  return reinterpret_cast<Lanes>(x < y ? x : y);
}

}  // namespace ldm
