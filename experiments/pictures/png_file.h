#pragma once
/// An image as a PNG file that is whole or reported (no paper section).
#include <mrpt/img/CImage.h>

#include "datasets/files/partial_file.h"

namespace experiments {

/// @param file whose name must end in `.png`
/// @throws std::runtime_error if it could not be written.
void save_png(const mrpt::img::CImage& image, datasets::PartialFile& file);

}  // namespace experiments
