#include "datasets/recording/formats/ros/decompression.h"

#include <bzlib.h>
#include <lz4frame.h>
#include <zstd.h>

#include <memory>

#include "datasets/files/printable.h"

namespace datasets {
namespace {

/// Each fills `plain`, whose size is that of the whole. @return false on damage
bool take_bz2(std::string_view bytes, std::string& plain) {
  std::string source(bytes);  // bzlib wants to write
  auto size = static_cast<unsigned>(plain.size());
  return BZ2_bzBuffToBuffDecompress(plain.data(), &size, source.data(),
                                    static_cast<unsigned>(source.size()), 0, 0) == BZ_OK &&
         size == plain.size();
}

bool take_lz4(std::string_view bytes, std::string& plain) {
  LZ4F_dctx* raw = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION)) != 0) return false;
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> context(
      raw, LZ4F_freeDecompressionContext);
  std::size_t done = 0, hint = 1;
  while (hint != 0) {
    std::size_t produced = plain.size() - done, consumed = bytes.size();
    hint = LZ4F_decompress(raw, plain.data() + done, &produced, bytes.data(), &consumed, nullptr);
    if (LZ4F_isError(hint) != 0 || (produced == 0 && consumed == 0)) return false;
    done += produced;
    bytes.remove_prefix(consumed);
  }
  return done == plain.size();
}

bool take_zstd(std::string_view bytes, std::string& plain) {
  return ZSTD_decompress(plain.data(), plain.size(), bytes.data(), bytes.size()) == plain.size();
}

}  // namespace

std::string decompress(std::string_view name, std::string_view bytes, std::uint64_t size,
                       std::string& plain) {
  constexpr std::uint64_t kLargest = std::uint64_t{512} << 20;  // a chunk has 1 to 4 MB as a rule
  if (size > kLargest) return "a chunk of " + std::to_string(size) + " bytes";
  if (name.empty() || name == "none") {
    plain.assign(bytes);
    return {};
  }
  plain.resize(static_cast<std::size_t>(size));
  bool good = false;
  if (name == "bz2") {
    good = take_bz2(bytes, plain);
  } else if (name == "lz4") {
    good = take_lz4(bytes, plain);
  } else if (name == "zstd") {
    good = take_zstd(bytes, plain);
  } else {
    return "compression `" + printable(name) + "`: allowed: none, bz2, lz4, zstd";
  }
  return good ? "" : "a chunk that is damaged";
}

}  // namespace datasets
