#pragma once
/// Scans of Velodyne's VLP-16 and HDL-32E, through MRPT (no paper section).
#include <memory>

#include "datasets/recording/formats/pcap/packet_scans.h"

namespace datasets {

/// True for a packet of 1206 bytes with the flags of Velodyne's data.
bool is_velodyne(const Datagram& datagram);

/// @param first packet of the sensor
/// @throws ldm::InvalidInput if it is of a model that MRPT does not know, or has a calibration of
///   its own, as HDL-64E's do.
/// @param place for messages
std::unique_ptr<PacketScans> velodyne_scans(const Datagram& first, const std::string& place);

}  // namespace datasets
