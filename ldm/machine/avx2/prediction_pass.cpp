/// Four particles at a time: what ParticlePair, VelocityNoise and ParticleMotion::move do to one
/// pair, done to two in registers twice as wide.
#include "ldm/particle_motion.h"

#ifdef __x86_64__
#include <immintrin.h>

/// Before a function: may use AVX2, and is called only on processors that have it.
#define LDM_AVX2 __attribute__((target("avx2")))

namespace ldm {
namespace {

/// The constants of a motion, in both halves of a register. Particles 0 and 2 are in the lower
/// halves, 1 and 3 in the upper: two loads from the memory unpack to that, each in its half.
class FourMotions {
 public:
  LDM_AVX2 explicit FourMotions(const ParticleMotion::Constants& motion)
      : extent_(in_both_halves(motion.extent)),
        origin_(in_both_halves(motion.origin)),
        highest_(in_both_halves(motion.highest)),
        step_(in_both_halves(motion.step)),
        row_stride_(in_both_halves(motion.row_stride)),
        layer_stride_(in_both_halves(motion.layer_stride)),
        gone_(in_both_halves(motion.gone)),
        fraction_bits_(_mm_cvtsi32_si128(motion.fraction_bits)),
        doublings_(motion.doublings) {}

  LDM_AVX2 __m256i gone() const { return gone_; }
  /// ParticleMotion::move. Slots, each in two lanes of 32 bits.
  LDM_AVX2 __m256i move(__m256i& position, __m256i velocity) const {
    __m256i way = _mm256_mulhrs_epi16(velocity, step_);
    for (int i = 0; i < doublings_; ++i) way = _mm256_adds_epi16(way, way);
    const __m256i before = _mm256_sub_epi16(position, origin_);
    const __m256i from_lowest =
        _mm256_add_epi16(_mm256_min_epu16(before, _mm256_add_epi16(before, extent_)), way);
    const __m256i inside = _mm256_cmpeq_epi16(_mm256_min_epu16(from_lowest, highest_), from_lowest);
    const __m256i moved = _mm256_add_epi16(from_lowest, origin_);
    position = _mm256_min_epu16(moved, _mm256_sub_epi16(moved, extent_));
    const __m256i voxel = _mm256_srl_epi16(position, fraction_bits_);
    const __m256i parts = _mm256_mullo_epi32(_mm256_madd_epi16(voxel, row_stride_), layer_stride_);
    const __m256i slots = _mm256_add_epi32(parts, _mm256_shuffle_epi32(parts, 0b10'11'00'01));
    const __m256i all_inside = _mm256_cmpeq_epi64(inside, _mm256_set1_epi64x(-1));
    return _mm256_blendv_epi8(gone_, slots, all_inside);
  }

 private:
  template <class Lanes>
  LDM_AVX2 static __m256i in_both_halves(const Lanes& lanes) {
    return _mm256_broadcastsi128_si256(reinterpret_cast<__m128i>(lanes));
  }

  __m256i extent_, origin_, highest_, step_, row_stride_, layer_stride_, gone_;
  __m128i fraction_bits_;
  int doublings_;
};

/// Draws of VelocityNoise for four particles.
class FourNoises {
 public:
  explicit FourNoises(const VelocityNoise& noise) : table_(noise.table().data()) {}

  /// VelocityNoise::draw
  LDM_AVX2 __m256i of(std::uint64_t first_two, std::uint64_t last_two) const {
    const __m128i even =
        _mm_add_epi16(entries<0>(first_two, last_two), entries<1>(first_two, last_two));
    const __m128i odd =
        _mm_add_epi16(entries<2>(first_two, last_two), entries<3>(first_two, last_two));
    return _mm256_set_m128i(odd, even);
  }

 private:
  /// Those that a quarter of each names.
  template <int kQuarter>
  LDM_AVX2 __m128i entries(std::uint64_t first_two, std::uint64_t last_two) const {
    constexpr int kShift = 16 * kQuarter + 16 - VelocityNoise::kBits;
    constexpr std::uint64_t kMask = VelocityNoise::kSize - 1;
    return _mm_set_epi64x(table_[last_two >> kShift & kMask], table_[first_two >> kShift & kMask]);
  }

  const std::int64_t* table_;
};

/// Four particles in two registers each.
struct FourParticles {
  __m256i position, velocity;

  LDM_AVX2 explicit FourParticles(const Particle* four) {
    const auto* const at = reinterpret_cast<const __m256i*>(four);
    const __m256i a = _mm256_loadu_si256(at);
    const __m256i b = _mm256_loadu_si256(at + 1);
    position = _mm256_unpacklo_epi64(a, b);
    velocity = _mm256_unpacklo_epi64(_mm256_srli_si256(a, kVelocityOffset),
                                     _mm256_srli_si256(b, kVelocityOffset));
  }

  LDM_AVX2 void store(__m256i slots, Particle* four) const {
    // x, y, z and vx, vy, vz of a particle come together; the slot goes behind them.
    const __m256i together = _mm256_broadcastsi128_si256(
        _mm_setr_epi8(0, 1, 2, 3, 4, 5, 8, 9, 10, 11, 12, 13, -1, -1, -1, -1));
    const __m256i a = _mm256_shuffle_epi8(_mm256_unpacklo_epi64(position, velocity), together);
    const __m256i b = _mm256_shuffle_epi8(_mm256_unpackhi_epi64(position, velocity), together);
    constexpr int kLastOfEach = 0b1000'1000;
    auto* const at = reinterpret_cast<__m256i*>(four);
    _mm256_storeu_si256(at, _mm256_blend_epi32(a, _mm256_shuffle_epi32(slots, 0), kLastOfEach));
    _mm256_storeu_si256(at + 1, _mm256_blend_epi32(b, slots, kLastOfEach));
  }
};

LDM_AVX2 void count_slots(__m256i slots, const SparseNumbers::Writer& count) {
  count.add_one(static_cast<std::uint32_t>(_mm256_extract_epi32(slots, 0)));
  count.add_one(static_cast<std::uint32_t>(_mm256_extract_epi32(slots, 2)));
  count.add_one(static_cast<std::uint32_t>(_mm256_extract_epi32(slots, 4)));
  count.add_one(static_cast<std::uint32_t>(_mm256_extract_epi32(slots, 6)));
}

LDM_AVX2 std::size_t move_fours(const PredictionPass& pass, std::size_t begin, std::size_t end) {
  const FourMotions motion(pass.motion.constants());
  const FourNoises noise(pass.noise);
  const RandomStream stream = pass.stream;
  const SparseNumbers::Writer count = pass.count;
  std::size_t i = begin;
  __m256i sigma = noise.of(stream.bits(i / 2), stream.bits(i / 2 + 1));
  __m256i counted = motion.gone();
  for (; i + 4 <= end; i += 4) {
    FourParticles four(pass.particles + i);
    four.velocity = _mm256_adds_epi16(four.velocity, sigma);
    sigma = noise.of(stream.bits(i / 2 + 2), stream.bits(i / 2 + 3));
    count_slots(counted, count);
    counted = motion.move(four.position, four.velocity);
    four.store(counted, pass.particles + i);
  }
  count_slots(counted, count);
  // GCC 12 forgets it here: with upper halves in use, the weights of `circular_buffer_pf`, whose
  // exponentials are SSE's code, took 0.25 ms instead of 0.10.
  _mm256_zeroupper();
  return i;
}

}  // namespace

std::size_t PredictionPass::move_fours(std::size_t begin, std::size_t end) const {
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  return has_avx2 ? ldm::move_fours(*this, begin, end) : begin;
}

}  // namespace ldm
#else

namespace ldm {

std::size_t PredictionPass::move_fours(std::size_t begin, std::size_t) const {
  return begin;
}

}  // namespace ldm
#endif
