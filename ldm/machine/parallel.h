#pragma once
/// Threads of one update: the only place that knows how they are made (no paper section).
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace ldm {

/// A number of parts that run at the same time. Work is split into as many parts, whatever the
/// machine: where a result must not depend on that number, its parts are combined in their order.
class Parallel {
 public:
  /// @param threads 1 runs everything in the caller; 0 stands for at_once()
  explicit Parallel(std::int64_t threads);
  ~Parallel();
  Parallel(Parallel&&) noexcept;
  Parallel& operator=(Parallel&&) noexcept;

  int parts() const { return parts_; }
  /// How many can run at the same time: the cores; 1 where there is nothing to run them (no TBB).
  static std::int64_t at_once();

  /// body(part) for each part, at the same time; returns when all are done.
  template <class Body>
  void for_each_part(Body&& body) const {
    if (parts_ == 1) {
      body(0);
      return;
    }
    using Type = std::remove_reference_t<Body>;
    run_parts([](void* b, int part) { (*static_cast<Type*>(b))(part); }, &body);
  }

  /// The share [begin, end) of part `part` of n items; the shares of all parts follow one another.
  struct Share {
    std::size_t begin;
    std::size_t end;
  };
  Share share(int part, std::size_t n) const {
    const auto p = static_cast<std::size_t>(part);
    const auto parts = static_cast<std::size_t>(parts_);
    return {n * p / parts, n * (p + 1) / parts};
  }

 private:
  void run_parts(void (*call)(void*, int), void* body) const;

  int parts_;
  struct Arena;  // of TBB
  std::unique_ptr<Arena> arena_;
};

}  // namespace ldm
