#pragma once
/// Compressed chunks of bags (no paper section).
#include <cstdint>
#include <string>
#include <string_view>

namespace datasets {

/// The bytes of a chunk, decompressed into `plain`.
/// @param name none (or empty), bz2, lz4 (its frame format) or zstd
/// @param size of the decompressed bytes, as the chunk says
/// @return empty, or what is wrong
std::string decompress(std::string_view name, std::string_view bytes, std::uint64_t size,
                       std::string& plain);

}  // namespace datasets
