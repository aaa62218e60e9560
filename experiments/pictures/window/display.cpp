#include "experiments/pictures/window/display.h"

#include <X11/Xlib.h>  // its macros leave no room for other libraries

namespace experiments {

bool has_display() {
  // Never closed: a server that loses its last client starts anew, and refuses the next one
  // meanwhile.
  static Display* const display = XOpenDisplay(nullptr);
  return display != nullptr;
}

}  // namespace experiments
