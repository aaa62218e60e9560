#include "datasets/recording/formats/ros/message_fields.h"

#include <algorithm>

#include "datasets/files/printable.h"

namespace datasets {

MessageFields::MessageFields(std::string_view bytes, MessageEncoding encoding)
    : rest_(bytes), whole_(bytes.size()), cdr_(encoding == MessageEncoding::kCdr) {
  if (!cdr_) return;
  rest_.take(1);
  swapped_ = rest_.number<std::uint8_t>() % 2 == 0;  // 0: big-endian, 1: little-endian
  rest_.take(2);
  whole_ -= 4;  // multiples count from here
}

std::string MessageFields::text() {
  std::string_view text = bytes();
  if (cdr_ && text.ends_with('\0')) text.remove_suffix(1);
  return std::string(text);
}

MessageHeader MessageFields::header() {
  if (!cdr_) number<std::uint32_t>();  // its number
  const auto seconds = cdr_ ? static_cast<double>(number<std::int32_t>())
                            : static_cast<double>(number<std::uint32_t>());
  const double stamp = seconds + 1e-9 * number<std::uint32_t>();
  return {stamp, frame_name(text())};
}

void MessageFields::swap(char* bytes, std::size_t count) {
  std::reverse(bytes, bytes + count);
}

std::string frame_name(std::string_view name) {
  if (name.starts_with('/')) name.remove_prefix(1);
  return printable(name);
}

}  // namespace datasets
