#include "datasets/recording/formats/pcd_file.h"

#include <stdexcept>

#include "datasets/files/loaded_library.h"
#include "datasets/recording/formats/pcd_check.h"
#include "datasets/recording/formats/pcd_decoder.h"
#include "datasets/recording/formats/pcd_header.h"

namespace datasets {
namespace {

/// Loaded with the first file.
DecodePcd& decoder() {
  static DecodePcd* const decode = loaded_function<DecodePcd>(kPcdLibrary, kDecodePcd);
  if (decode == nullptr) {
    throw std::runtime_error(std::string("PCD files cannot be read: allowed: with ") + kPcdLibrary +
                             " beside this program or in ../lib/ldm");
  }
  return *decode;
}

}  // namespace

void parse_pcd(std::string_view content, const std::string& name, std::vector<ldm::Point>& points) {
  const PcdHeader header = parse_pcd_header(content, name);
  std::string_view body = content.substr(header.data_begin);
  std::string lines;
  if (header.encoding == PcdHeader::Encoding::kAscii) {
    body = lines = checked_lines(body, header, name);
  } else {
    check_bytes(body, header, name);
  }
  if (header.points == 0) return;
  if (!decoder()(header, body, points)) throw damaged_points(header, name);
}

}  // namespace datasets
