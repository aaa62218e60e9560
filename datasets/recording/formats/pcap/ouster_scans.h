#pragma once
/// Scans of Ouster's sensors, by the packets that Ouster's documentation of its firmware describes
/// (no paper section).
#include <filesystem>
#include <memory>

#include "datasets/recording/formats/pcap/packet_scans.h"

namespace datasets {

/// Pixels of the profiles LEGACY, RNG19_RFL8_SIG16_NIR16, RNG19_RFL8_SIG16_NIR16_DUAL,
/// RNG15_RFL8_NIR8 and FUSA_RNG15_RFL8_NIR8_DUAL; both returns of dual ones are points. Points are
/// in the sensor's frame.
/// @param metadata the JSON file of the recording
/// @throws ldm::InvalidInput if it cannot be read, or has another profile.
std::unique_ptr<PacketScans> ouster_scans(const std::filesystem::path& metadata);

}  // namespace datasets
