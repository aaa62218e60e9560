#pragma once
/// Hashes of text: of files and settings in records, and of what a seed stands for. The same on
/// every machine.
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace datasets {

/// FNV-1a (Fowler, Noll, Vo) of the bytes, one text after another.
class Fnv1a {
 public:
  void add(std::string_view text) {
    for (const char c : text) add_byte(static_cast<unsigned char>(c));
  }
  void add_byte(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001b3U; }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

/// 64 well-mixed bits of a list of words; ("ab", "c") and ("a", "bc") differ.
std::uint64_t hash(std::initializer_list<std::string_view> words);

/// Sixteen hexadecimal digits.
std::string hex(std::uint64_t value);

}  // namespace datasets
