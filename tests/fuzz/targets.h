#pragma once
/// The readers as a fuzzer calls them: any bytes must read as frames or be refused in one line.
#include <string>
#include <string_view>
#include <utility>

namespace fuzz {

/// Each throws std::logic_error on a broken promise: another exception than ldm::InvalidInput, a
/// message of several lines, or a frame that no mapper takes.
void pcd(const std::string& bytes);         ///< a PCD file
void trajectory(const std::string& bytes);  ///< a TUM or KITTI trajectory
/// times.txt, poses.txt, calib.txt and a scan of a KITTI folder, with a line `---` between them.
void kitti(const std::string& bytes);
void mrpt_log(const std::string& bytes);  ///< a rawlog, plain or compressed
void ros1_bag(const std::string& bytes);
void mcap_bag(const std::string& bytes);
void sqlite_bag(const std::string& bytes);
/// Both timestamps.txt of a raw recording of KITTI's, its calibration, a file of oxts/ and a scan,
/// so divided.
void kitti_raw(const std::string& bytes);
/// Metadata of an Ouster sensor, or nothing, and a capture file, so divided.
void pcap(const std::string& bytes);

/// Every target with its name, which is that of its corpus.
inline constexpr std::pair<std::string_view, void (*)(const std::string&)> kTargets[] = {
    {"pcd", pcd},
    {"trajectory", trajectory},
    {"kitti", kitti},
    {"mrpt_log", mrpt_log},
    {"ros1_bag", ros1_bag},
    {"mcap_bag", mcap_bag},
    {"sqlite_bag", sqlite_bag},
    {"kitti_raw", kitti_raw},
    {"pcap", pcap}};

}  // namespace fuzz
