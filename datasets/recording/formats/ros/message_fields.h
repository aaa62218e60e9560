#pragma once
/// The fields of a message, one after the other, in ROS 1's encoding or in CDR (XCDR1, as ROS 2
/// writes it; no paper section).
#include <string>

#include "datasets/recording/formats/bytes.h"
#include "datasets/recording/formats/ros/bag_file.h"

namespace datasets {

/// `std_msgs/Header`.
struct MessageHeader {
  double stamp = 0;   ///< [s]
  std::string frame;  ///< without the slash that old ones begin with
};

class MessageFields {
 public:
  /// @throws ShortBytes, as all of its functions, if the bytes end too early.
  MessageFields(std::string_view bytes, MessageEncoding encoding);

  /// A number, at a multiple of its size in CDR.
  template <class Number>
  Number number() {
    if (cdr_) {
      const std::size_t past = (whole_ - rest_.size()) % sizeof(Number);
      if (past != 0) rest_.take(sizeof(Number) - past);
    }
    Number value = rest_.number<Number>();
    if (swapped_) swap(reinterpret_cast<char*>(&value), sizeof value);
    return value;
  }
  std::string text();
  /// Bytes behind their number.
  std::string_view bytes() { return rest_.take(number<std::uint32_t>()); }
  MessageHeader header();
  std::size_t left() const { return rest_.size(); }

 private:
  static void swap(char* bytes, std::size_t count);

  Bytes rest_;
  std::size_t whole_;
  bool cdr_;
  bool swapped_ = false;  // big-endian
};

/// A frame's name without the slash that old ones begin with.
std::string frame_name(std::string_view name);

}  // namespace datasets
