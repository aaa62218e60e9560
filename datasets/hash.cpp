#include "datasets/hash.h"

#include <cstdio>

#include "datasets/random.h"

namespace datasets {

std::uint64_t hash(std::initializer_list<std::string_view> words) {
  Fnv1a fnv;
  for (const std::string_view word : words) {
    fnv.add(word);
    fnv.add_byte(0);  // the end of a word, which text cannot hold
  }
  return mixed(fnv.value());  // FNV's high bits mix poorly
}

std::string hex(std::uint64_t value) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value));
  return digits;
}

}  // namespace datasets
