#include "datasets/frame.h"

#include <cstdio>

namespace datasets {

std::string origin_text(const Frame& frame) {
  if (frame.origin.isZero()) return {};
  char text[120];
  std::snprintf(text, sizeof text, "origin_m %.12g %.12g %.12g", frame.origin.x(), frame.origin.y(),
                frame.origin.z());
  return text;
}

}  // namespace datasets
