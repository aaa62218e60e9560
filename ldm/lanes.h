#pragma once
/// Four integers side by side in one register of the processor (no paper section).
///
/// The compiler's vector extension (g++ and clang), not the intrinsics of one processor: the same
/// source becomes SSE on x86 and NEON on ARM, with the same bits.
#include <cstdint>

namespace ldm {

using Lanes = std::int32_t __attribute__((vector_size(16)));

/// `value` in each lane.
inline Lanes all_lanes(std::int32_t value) {
  return Lanes{value, value, value, value};
}

}  // namespace ldm
