#pragma once
/// Numbers and texts in the bytes of a file: little-endian, one after the other (no paper section).
#include <bit>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace datasets {

static_assert(std::endian::native == std::endian::little,
              "numbers are read as they lie in the file");

/// The bytes end before the fields that they should hold.
struct ShortBytes : std::runtime_error {
  ShortBytes() : std::runtime_error("the bytes end too early") {}
};

class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : rest_(bytes) {}

  bool empty() const { return rest_.empty(); }
  std::size_t size() const { return rest_.size(); }
  /// @throws ShortBytes unless there are so many.
  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) throw ShortBytes();
    const std::string_view taken = rest_.substr(0, static_cast<std::size_t>(count));
    rest_.remove_prefix(taken.size());
    return taken;
  }
  template <class Number>
  Number number() {
    Number value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }
  /// A text behind its length of 32 bits.
  std::string_view text() { return take(number<std::uint32_t>()); }

 private:
  std::string_view rest_;
};

}  // namespace datasets
