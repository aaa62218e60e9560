/// Packets of Velodyne's and Ouster's sensors: points by hand, networks, and what is refused.
#include "datasets/recording/formats/pcap/pcap_reader.h"

#include <gtest/gtest.h>
#include <malloc.h>
#include <mrpt/obs/CObservationVelodyneScan.h>

#include <numbers>
#include <set>
#include <sstream>

#include "datasets/files/gz_archive.h"
#include "datasets/recording/formats/pcap/ouster_metadata.h"
#include "datasets/recording/formats/pcap/ouster_scans.h"
#include "datasets/recording/recording_info.h"
#include "tests/datasets/recording/formats/pcap/packet_writer.h"
#include "tests/datasets/recording/recording_folder.h"

namespace datasets {
namespace {

using Packets = std::vector<TestPacket>;
constexpr double kDegree = std::numbers::pi / 180;

void add(Packets& packets, const Packets& more) {
  packets.insert(packets.end(), more.begin(), more.end());
}

class Pcap : public RecordingFolder {
 protected:
  void SetUp() override {
    RecordingFolder::SetUp();
    options_.input.poses = PoseSource::kStill;
    options_.input.min_range = 0;
  }

  std::vector<Frame> frames_of(const fs::path& file) {
    std::vector<Frame> all;
    const auto source = open_recording(file, options_);
    for (Frame frame; source->next(frame);) all.push_back(frame);
    counts_ = source->counts();
    return all;
  }
  std::vector<Frame> frames_of(const Packets& packets) {
    return frames_of(write("a.pcap", pcap_file(packets)));
  }
  std::string failure_of(const fs::path& file) {
    try {
      frames_of(file);
    } catch (const ldm::InvalidInput& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
      return error.what();
    }
    return "none";
  }
  std::string described(const fs::path& file) {
    std::ostringstream out;
    describe_recording(file, options_, out);
    return out.str();
  }

  /// Turns of a VLP-16 from 100 s on, 75 packets and 0.1 s each; the first begins 100 s after an
  /// hour of its clock begins. Turn k sees everything 10 + k metres away.
  static Packets velodyne_turns(int turns, int host = 201) {
    Packets packets;
    for (int k = 0; k < 75 * turns; ++k) {
      const double degrees = std::fmod(4.8 * k, 360);
      add(packets,
          sent(100 + 0.1 / 75 * k, host, 2368,
               velodyne_packet(degrees, 10 + k / 75,
                               static_cast<std::uint32_t>(100'000'000 + k * 100'000 / 75))));
    }
    return packets;
  }
  /// Turns of the sensor that `ouster_metadata` describes, in two packets and 0.1 s each.
  static Packets ouster_turns(const OusterForm& form, int turns, std::uint32_t range = 5000,
                              std::uint16_t port = 7502) {
    Packets packets;
    for (int k = 0; k < 2 * turns; ++k) {
      std::vector<OusterColumn> columns;
      for (int c = 0; c < 4; ++c) {
        const int column = 4 * (k % 2) + c;
        columns.push_back({static_cast<std::uint64_t>(7e9 + 5e7 * k + 12'500'000.0 * c),
                           static_cast<std::uint16_t>(column), range, range});
      }
      add(packets, sent(100 + 0.05 * k, 200, port,
                        ouster_packet(form, static_cast<std::uint16_t>(65535 + k / 2), columns),
                        static_cast<std::uint16_t>(k)));
    }
    return packets;
  }
};

/// Velodyne's azimuth turns clockwise from the front.
void expect_velodyne_turn(const Frame& frame, int turn) {
  ASSERT_EQ(frame.scan.points.size(), 900u);
  EXPECT_NEAR(frame.scan.time, 100 + 0.1 * turn, 1e-5);
  for (std::size_t k = 0; k < 900; ++k) {
    const double azimuth = -0.4 * kDegree * static_cast<double>(k), range = 10 + turn;
    const Eigen::Vector3d expected =
        range * Eigen::Vector3d(std::cos(15 * kDegree) * std::cos(azimuth),
                                std::cos(15 * kDegree) * std::sin(azimuth),
                                -std::sin(15 * kDegree));
    // The lasers sit a little above and below one another.
    EXPECT_LT((frame.scan.points[k].cast<double>() - expected).norm(), 0.02) << k;
  }
}

TEST_F(Pcap, AVelodyneSensor) {
  const Packets packets = velodyne_turns(2);
  const std::vector<std::string> files = {
      pcap_file(packets),
      pcap_file(packets, {.swapped = true}),
      pcap_file(packets, {.nanoseconds = true}),
      pcapng_file(packets),
      pcapng_file(packets, true),
  };
  for (const std::string& file : files) {
    const std::vector<Frame> all = frames_of(write("a.pcap", file));
    ASSERT_EQ(all.size(), 2u);
    for (int turn = 0; turn < 2; ++turn) {
      expect_velodyne_turn(all[static_cast<std::size_t>(turn)], turn);
    }
  }
}

TEST_F(Pcap, NetworksOfSeveralKinds) {
  const std::string payload = velodyne_packet(0, 10, 0);
  const std::string packet = ip4(201, udp(2368, payload)).front();
  const std::string ip6 = std::string("\x60\0\0\0", 4) +
                          big(static_cast<std::uint16_t>(8 + payload.size())) +
                          std::string("\x11\x40", 2) + std::string(32, 'a') + udp(2368, payload);
  const std::pair<std::uint32_t, std::string> captured[] = {
      {1, ethernet(packet) + "padded"},
      {1, ethernet(packet, true)},
      {1, ethernet(ip6)},
      {101, packet},
      {228, packet},
      {0, std::string("\2\0\0\0", 4) + packet},
      {113, std::string(14, 's') + std::string("\x08\x00", 2) + packet},
      {276, std::string("\x08\x00", 2) + std::string(18, 's') + packet}};
  for (const auto& [link, bytes] : captured) {
    const fs::path file = write("a.pcap", pcap_file({{100, bytes}}, {.link = link}));
    ASSERT_EQ(frames_of(file).size(), 1u) << link;
    EXPECT_EQ(frames_of(file).at(0).scan.points.size(), 12u) << link;
  }
}

/// Two firings of 16 lasers in each block, or one of 32.
TEST_F(Pcap, AllReturnsOfABlockArePoints) {
  const auto range_of = [](double) { return 10.0; };
  for (const unsigned char model : {'\x22', '\x21'}) {
    const bool vlp16 = model == 0x22;
    const Packets packet = sent(100, 201, 2368, velodyne_sweep(0, range_of, 0, model));
    const auto points = frames_of(packet).at(0).scan.points;
    ASSERT_EQ(points.size(), 12u * 32);
    std::set<long> rings;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const ldm::Point& p = points[i];
      const double azimuth = -std::atan2(p.y(), p.x()) / kDegree;
      const double firing =
          vlp16 ? 0.2 * static_cast<double>(i / 16) : 0.4 * static_cast<double>(i / 32);
      EXPECT_GT(azimuth, firing - 1e-3) << i;
      EXPECT_LT(azimuth, firing + (vlp16 ? 0.2 : 0.4)) << i;
      rings.insert(std::lround(std::atan2(p.z(), std::hypot(p.x(), p.y())) / kDegree * 3));
    }
    EXPECT_EQ(rings.size(), vlp16 ? 16u : 32u);
  }
}

/// MRPT keeps packets of a real VLP-16 in a log: from a network they give the same points. MRPT's
/// own points, those of every other firing, are among them.
TEST_F(Pcap, RealPacketsGiveThePointsOfMrptsLog) {
  const fs::path log = "/usr/share/mrpt/datasets/test_velodyne_VLP16.rawlog";
  GzArchive archive(log);
  const auto observation =
      std::dynamic_pointer_cast<mrpt::obs::CObservationVelodyneScan>(archive.read_object());
  ASSERT_TRUE(observation);
  Packets packets;
  for (const auto& packet : observation->scan_packets) {
    add(packets, sent(100 + 0.001 * static_cast<double>(packets.size()), 201, 2368,
                      {reinterpret_cast<const char*>(&packet), sizeof packet}));
  }
  options_.input.min_range = 1.01;  // what the log itself leaves out
  std::vector<ldm::Point> of_network, of_log;
  for (const Frame& frame : frames_of(packets)) {
    of_network.insert(of_network.end(), frame.scan.points.begin(), frame.scan.points.end());
  }
  options_.input.sensor.from_log = false;
  for (const Frame& frame : frames_of(log)) {
    of_log.insert(of_log.end(), frame.scan.points.begin(), frame.scan.points.end());
  }
  ASSERT_GT(of_log.size(), 10000u);
  EXPECT_EQ(of_network, of_log);
  observation->generatePointCloud();
  const auto& cloud = observation->point_cloud;
  EXPECT_NEAR(static_cast<double>(cloud.size()), 0.5 * static_cast<double>(of_log.size()), 50);
  for (std::size_t i = 0; i < cloud.size(); i += 17) {
    const ldm::Point p(cloud.x[i], cloud.y[i], cloud.z[i]);
    if (p.norm() < 1.02F) continue;
    float nearest = 1e9F;
    for (const ldm::Point& q : of_log) nearest = std::min(nearest, (p - q).norm());
    EXPECT_LT(nearest, 0.001F + 3e-4F * p.norm()) << i;  // MRPT rounds azimuths to 0.01 degrees
  }
}

/// At 45 degrees a column, whose beams look to the front of the lidar where the column is 0: that
/// is the sensor's back.
TEST_F(Pcap, AnOusterSensorOfEachProfile) {
  for (const OusterForm& form : ouster_forms()) {
    for (const bool sections : {true, false}) {
      write("a.json", ouster_metadata(form.profile, sections));
      const std::vector<Frame> all = frames_of(ouster_turns(form, 2));
      ASSERT_EQ(all.size(), 2u) << form.profile;
      const std::size_t returns = form.dual ? 2 : 1;
      ASSERT_EQ(all[1].scan.points.size(), 16 * returns) << form.profile;
      EXPECT_NEAR(all[1].scan.time, 100.1, 1e-9);
      for (std::size_t k = 0; k < all[1].scan.points.size(); ++k) {
        const std::size_t pixel = k / returns;
        const double column = -45.0 * static_cast<double>(pixel / 2);
        const double altitude = pixel % 2 == 0 ? 30 : -30, azimuth = pixel % 2 == 0 ? 10 : 0;
        const double way = 5 - 0.02, across = way * std::cos(altitude * kDegree);
        const double turn = (column + azimuth) * kDegree;
        const Eigen::Vector3d expected(
            -(across * std::cos(turn) + 0.02 * std::cos(column * kDegree)),
            -(across * std::sin(turn) + 0.02 * std::sin(column * kDegree)),
            way * std::sin(altitude * kDegree) + 0.036);
        EXPECT_LT((all[1].scan.points[k].cast<double>() - expected).norm(), 1e-5)
            << form.profile << ' ' << k;
      }
    }
  }
}

TEST_F(Pcap, WhatAnOusterSensorDidNotMeasureIsLeftOut) {
  const OusterForm& form = ouster_forms()[1];
  write("a.json", ouster_metadata(form.profile));
  std::vector<OusterColumn> columns = {
      {0, 0, 0, 4000}, {1, 1, 4000, 4000, false}, {2, 8, 4000, 4000}, {3, 3, 4000, 0}};
  Packets packets = sent(100, 200, 7502, ouster_packet(form, 7, columns));
  add(packets, sent(100.1, 200, 7502, ouster_packet(form, 7, columns, 3)));  // of another type
  add(packets, sent(100.1, 200, 7503, ouster_packet(form, 7, columns)));     // to another port
  add(packets, sent(100.2, 200, 7502, ouster_packet(form, 8, columns)));
  add(packets, sent(100.3, 200, 7502, ouster_packet(form, 7, columns)));  // late
  add(packets, sent(100.3, 200, 7502, "other"));
  const std::vector<Frame> all = frames_of(packets);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].scan.points.size(), 2u);
  EXPECT_EQ(all[1].scan.points.size(), 2u);
}

TEST_F(Pcap, FragmentsOutOfOrderAndLostOnes) {
  const OusterForm& form = ouster_forms()[2];
  write("a.json", ouster_metadata(form.profile));
  const std::string packet = ouster_packet(
      form, 7, {{0, 0, 4000, 4000}, {1, 1, 4000, 4000}, {2, 2, 4000, 4000}, {3, 3, 4000, 4000}});
  const auto parts = [&](std::uint16_t number) { return ip4(200, udp(7502, packet), number, 64); };
  ASSERT_GE(parts(1).size(), 4u);
  Packets packets;
  for (std::uint16_t number = 1; number <= 200; ++number) {  // without their first part
    packets.push_back({100, ethernet(parts(number)[1])});
  }
  const std::vector<std::string> whole = parts(300);
  for (auto part = whole.rbegin(); part != whole.rend(); ++part) {
    packets.push_back({101, ethernet(*part)});
  }
  const std::vector<Frame> all = frames_of(packets);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].scan.points.size(), 16u);
  EXPECT_EQ(all[0].scan.time, 101);
}

/// What a sensor measures while it drives forward at 10 m/s lies as far ahead as it has driven
/// since the first packet.
TEST_F(Pcap, ScansInMotionAreMovedToTheirTime) {
  options_.input.poses = PoseSource::kLog;
  options_.poses = write("slam.tum", "99 0 0 0 0 0 0 1\n100 10 0 0 0 0 0 1\n101 20 0 0 0 0 0 1\n");
  options_.input.pose_gap = 2;
  const Packets packets = velodyne_turns(1);
  const ldm::Scan moved = frames_of(packets).at(0).scan;
  options_.input.deskew = false;
  const ldm::Scan as_measured = frames_of(packets).at(0).scan;
  ASSERT_EQ(moved.points.size(), 900u);
  for (std::size_t k = 0; k < 900; ++k) {
    const double time = 0.1 / 900 * static_cast<double>(k);
    const ldm::Point shift = moved.points[k] - as_measured.points[k];
    EXPECT_NEAR(shift.x(), 10 * time, 2e-3) << k;
    EXPECT_NEAR(shift.tail<2>().norm(), 0, 1e-4);
  }
}

/// The sensor's clock is set half-way through the second of three turns: times of that turn are
/// those of the capture, and points lie where they would.
TEST_F(Pcap, AClockThatIsSetDuringATurn) {
  options_.input.no_returns = NoReturns::kLog;
  options_.input.poses = PoseSource::kLog;
  options_.poses = write("slam.tum", "99 0 0 0 0 0 0 1\n100 10 0 0 0 0 0 1\n101 20 0 0 0 0 0 1\n");
  options_.input.pose_gap = 2;
  const std::vector<Frame> right = frames_of(velodyne_turns(3));
  EXPECT_TRUE(counts_.other.empty());
  for (const double step : {-0.02, -40.0, 7.0, -1900.0, 1900.0}) {
    Packets packets;
    for (int k = 0; k < 75 * 3; ++k) {
      const double clock = 2000 + 0.1 / 75 * k + (k < 75 + 37 ? 0 : step);
      add(packets, sent(100 + 0.1 / 75 * k, 201, 2368,
                        velodyne_packet(std::fmod(4.8 * k, 360), 10 + k / 75,
                                        static_cast<std::uint32_t>(std::lround(1e6 * clock)))));
    }
    const std::vector<Frame> all = frames_of(packets);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(counts_.other,
              (InputCounts::ByReason{{"turns in which the sensor's clock was set", 1}}));
    for (std::size_t turn = 0; turn < 3; ++turn) {
      for (std::size_t k = 0; k < 900; ++k) {
        const auto& points = all[turn].scan.points;
        EXPECT_LT((points[k] - right[turn].scan.points[k]).norm(), 1e-3F) << turn << ' ' << k;
      }
    }
  }
}

/// The recording begins at 90 degrees of a turn and ends at 180 of the fourth; in the third,
/// packets are lost from 192 to 216 degrees. Nothing is from 101 to 139 degrees: there rays met
/// nothing.
TEST_F(Pcap, WhatIsMissingIsNotWhatMetNothing) {
  const auto range_of = [](double degrees) { return degrees > 101 && degrees < 139 ? 0.0 : 10.0; };
  Packets packets;
  for (int k = 19; k < 3 * 75 + 37; ++k) {
    const double degrees = std::fmod(4.8 * k, 360);
    if (k / 75 == 2 && degrees > 191 && degrees < 216) continue;
    add(packets, sent(100 + 0.1 / 75 * k, 201, 2368,
                      velodyne_sweep(degrees, range_of, static_cast<std::uint32_t>(1e5 / 75 * k))));
  }
  const std::vector<Frame> all = frames_of(packets);
  ASSERT_EQ(all.size(), 4u);
  for (std::size_t turn = 0; turn < 4; ++turn) {
    // Of 190 firings, in each ring; the lasers of a firing look a little further one by one.
    EXPECT_NEAR(static_cast<double>(all[turn].scan.no_returns.size()), 16 * 190, 16 * 3) << turn;
    for (const ldm::Point& ray : all[turn].scan.no_returns) {
      const double degrees = std::fmod(720 - std::atan2(ray.y(), ray.x()) / kDegree, 360);
      EXPECT_TRUE(degrees > 100 && degrees < 140) << turn << ' ' << degrees;
    }
  }
  EXPECT_TRUE(counts_.other.empty());
}

/// Of the eight columns, 45 degrees each, whose first beam looks 10 degrees to the left of the
/// second one; column 0 looks to the sensor's back.
TEST_F(Pcap, ColumnsOfAnOusterSensorThatAreMissing) {
  const OusterForm& form = ouster_forms()[1];
  const auto scans = ouster_scans(write("a.json", ouster_metadata(form.profile)));
  PacketScan scan;
  const auto take = [&](std::uint16_t frame, int first, std::uint64_t time, bool begins = true) {
    std::vector<OusterColumn> columns;
    for (int c = 0; c < 4; ++c) {
      columns.push_back({time + 12'500'000 * static_cast<std::uint64_t>(c),
                         static_cast<std::uint16_t>(first + c), 4000, 4000, c > 0 || begins});
    }
    const std::string payload = ouster_packet(form, frame, columns);
    return scans->take({100 + 0.1 * frame + 0.0125 * first, "192.168.1.200", 7502, payload}, scan);
  };
  EXPECT_FALSE(take(1, 0, 7'000'000'000));
  EXPECT_FALSE(take(1, 4, 7'050'000'000));
  EXPECT_TRUE(take(2, 4, 7'150'000'000));
  for (int degrees = -180; degrees < 180; ++degrees) {
    EXPECT_FALSE(scan.lost.contains(kDegree * degrees)) << degrees;
  }
  // The first half of the second turn was lost: beams of columns 0 to 3.
  EXPECT_TRUE(take(3, 0, 7'200'000'000, false));
  for (int degrees = 0; degrees < 360; ++degrees) {
    const bool lost = degrees > 22.5 && degrees < 212.5;
    EXPECT_EQ(scan.lost.contains(kDegree * (degrees + 0.1)), lost) << degrees;
  }
  EXPECT_EQ(scan.delays.front(), 0);
  // The first column of the third was not measured.
  EXPECT_FALSE(take(3, 4, 7'250'000'000));
  EXPECT_TRUE(scans->finish(scan));
  EXPECT_EQ(scan.points.size(), 14u);
  EXPECT_TRUE(scan.lost.contains(kDegree * 180));
  EXPECT_FALSE(scan.lost.contains(kDegree * 220));
  EXPECT_EQ(scan.delays.front(), 0);
  EXPECT_NEAR(scan.delays.back(), 0.075, 1e-6);
}

/// Packets in which nothing was measured count for the time of those that follow.
TEST_F(Pcap, AnOusterTurnWhoseFirstPacketsMeasuredNothing) {
  const OusterForm& form = ouster_forms()[1];
  for (const bool set : {false, true}) {
    const auto scans = ouster_scans(write("a.json", ouster_metadata(form.profile)));
    const std::uint64_t late = set ? 900'000'000'000 : 0;  // another clock from the sixth column on
    std::vector<OusterColumn> nothing(4, OusterColumn{0, 0, 0, 0, false});
    const std::vector<OusterColumn> half = {{7'050'000'000, 4, 4000, 4000},
                                            {7'062'500'000 + late, 5, 4000, 4000},
                                            {7'075'000'000 + late, 6, 4000, 4000},
                                            {7'087'500'000 + late, 7, 4000, 4000}};
    PacketScan scan;
    const std::string first = ouster_packet(form, 1, nothing),
                      second = ouster_packet(form, 1, half);
    scans->take({100, "192.168.1.200", 7502, first}, scan);
    scans->take({100.05, "192.168.1.200", 7502, second}, scan);
    ASSERT_TRUE(scans->finish(scan));
    EXPECT_EQ(scan.time, 100);
    EXPECT_EQ(scan.clock_set, set);
    ASSERT_EQ(scan.delays.size(), 8u);
    EXPECT_NEAR(scan.delays[0], 0.05, 1e-6);
    EXPECT_NEAR(scan.delays[7], set ? 0.05 : 0.0875, 1e-6);
  }
}

TEST_F(Pcap, PosesOneForEachScan) {
  options_.input.poses = PoseSource::kLog;
  const Packets packets = velodyne_turns(3);
  const fs::path file = write("a.pcap", pcap_file(packets));
  options_.poses = write("results/a_poses_kitti.txt",
                         "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n"
                         "1 0 0 2 0 1 0 0 0 0 1 0\n");
  for (const fs::path& poses : {*options_.poses, options_.poses->parent_path()}) {
    options_.poses = poses;
    const std::vector<Frame> all = frames_of(file);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[2].scan.T_world_sensor.translation.x(), 2);
  }
  write("results/a_poses_kitti.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 1 0 1 0 0 0 0 1 0\n");
  EXPECT_EQ(failure_of(file), path("results/a_poses_kitti.txt") +
                                  ": 2 lines: allowed: 3, one for each scan of " + file.string() +
                                  ", or a trajectory with times (TUM)");
  append("results/a_poses_kitti.txt", "1 0 0 0 0 1 0 0 0 0 1 x\n");
  EXPECT_NE(failure_of(file).find("kitti.txt:3: x: allowed: a finite number"), std::string::npos);
  options_.keep_going = true;
  EXPECT_EQ(frames_of(file).size(), 2u);
  EXPECT_EQ(counts_.frames_skipped, (InputCounts::ByReason{{"bad pose", 1}}));
}

TEST_F(Pcap, WithoutPosesItIsRefused) {
  const fs::path file = write("a.pcap", pcap_file(velodyne_turns(2)));
  options_.input.poses = PoseSource::kLog;
  EXPECT_EQ(failure_of(file),
            file.string() +
                ": has no poses: allowed: --poses FILE (docs/recordings.md says where "
                "from), or --set input.poses=still for a sensor at rest");
  options_.poses = write("slam.tum", "200 0 0 0 0 0 0 1\n201 0 0 0 0 0 0 1\n");
  EXPECT_NE(failure_of(file).find(": no pose at 100 s: the file of --poses has poses at 200 s"),
            std::string::npos)
      << failure_of(file);
  options_.times = *options_.poses;
  EXPECT_NE(failure_of(file).find("packets have their own"), std::string::npos);
  options_.times.reset();
  options_.input.poses_of = PosesOf::kCamera;
  EXPECT_NE(failure_of(file).find("input.poses_of = camera: allowed: in a KITTI folder"),
            std::string::npos);
}

TEST_F(Pcap, TheVehicleAtRestAndInMotion) {
  options_.input.sensor.z = 2;
  EXPECT_EQ(frames_of(velodyne_turns(1)).at(0).scan.T_world_sensor.translation.z(), 2);
  options_.input.poses = PoseSource::kLog;
  options_.input.pose_gap = 2;
  options_.poses = write("slam.tum", "99 0 0 0 0 0 0 1\n101 0 0 0 0 0 0 1\n");
  EXPECT_EQ(frames_of(velodyne_turns(1)).at(0).scan.T_world_uav.translation.z(), -2);
  options_.input.poses_of = PosesOf::kVehicle;
  EXPECT_EQ(frames_of(velodyne_turns(1)).at(0).scan.T_world_sensor.translation.z(), 2);
}

TEST_F(Pcap, ASecondSensorIsCounted) {
  Packets packets = velodyne_turns(2);
  add(packets, velodyne_turns(1, 202));
  EXPECT_EQ(frames_of(packets).size(), 2u);
  EXPECT_EQ(counts_.other_sensors,
            (InputCounts::ByReason{{"192.168.1.202 to port 2368 (packets)", 75}}));
}

TEST_F(Pcap, WhatIsInAFile) {
  Packets packets = velodyne_turns(2);
  add(packets, sent(100.2, 201, 8308, "position"));
  const fs::path file = write("a.pcap", pcap_file(packets));
  const std::string streams =
      "format  pcap\n"
      "packets 192.168.1.201 to port 2368: 1206 bytes, 150, 750.0 Hz\n"
      "packets 192.168.1.201 to port 8308: 8 bytes, 1\n"
      "times   100.000 to 100.200 s (0.2 s)\n";
  EXPECT_EQ(described(file), streams + "taken   scans of Velodyne VLP-16, at rest\n");
  options_.input.poses = PoseSource::kLog;
  EXPECT_EQ(described(file), streams + "taken   nothing: " + failure_of(file) + "\n");
  options_.poses = write("slam.tum", "99 0 0 0 0 0 0 1\n101 0 0 0 0 0 0 1\n");
  EXPECT_EQ(described(file), streams + "taken   scans of Velodyne VLP-16, poses of a file\n");
}

TEST_F(Pcap, BrokenPacketsAreLeftOut) {
  Packets packets = velodyne_turns(1);
  for (const std::size_t at : {std::size_t{42}, std::size_t{42 + 1100 + 3}}) {  // flags, azimuth
    packets[at % 7].bytes.replace(at, 1, "\xaa");
  }
  EXPECT_EQ(frames_of(packets).at(0).scan.points.size(), 876u);
}

TEST_F(Pcap, SensorsThatNobodyKnows) {
  Packets packets = sent(100, 201, 2368, velodyne_packet(0, 10, 0, 0x28));
  const fs::path file = write("a.pcap", pcap_file(packets));
  EXPECT_NE(failure_of(file).find(": a Velodyne sensor of model 0x28: allowed: 0x21 (HDL-32E) and "
                                  "0x22 (VLP-16)"),
            std::string::npos)
      << failure_of(file);
  std::string lower = velodyne_packet(0, 10, 0);
  lower.replace(100, 2, "\xff\xdd");
  write("a.pcap", pcap_file(sent(100, 201, 2368, lower)));
  EXPECT_NE(failure_of(file).find(": a Velodyne sensor of model HDL-64E: allowed: 0x21"),
            std::string::npos)
      << failure_of(file);
  write("a.pcap", pcap_file(sent(100, 201, 2368, "other")));
  EXPECT_EQ(failure_of(file),
            file.string() +
                ": has no packets of a Velodyne sensor: allowed: those, or an Ouster "
                "sensor's with its metadata in a.json");
  const fs::path metadata = write("sensor.json", ouster_metadata("LEGACY"));
  EXPECT_EQ(failure_of(file),
            file.string() + ": has no packets of the sensor of " + metadata.string());
  write("other.json", ouster_metadata("LEGACY"));
  EXPECT_EQ(failure_of(file), file.string() +
                                  ": several metadata files beside it, other.json, "
                                  "sensor.json: allowed: a.json");
  write("a.json", ouster_metadata("RNG99"));
  EXPECT_NE(failure_of(file).find("a.json: packets of profile RNG99: allowed: LEGACY, RNG19"),
            std::string::npos)
      << failure_of(file);
}

TEST_F(Pcap, MetadataThatIsNone) {
  const fs::path file = write("a.pcap", pcap_file(ouster_turns(ouster_forms()[0], 1)));
  const std::string good = ouster_metadata("LEGACY");
  const auto with = [&](const std::string& part, const std::string& other) {
    std::string text = good;
    text.replace(text.find(part), part.size(), other);
    write("a.json", text);
    return failure_of(file);
  };
  const std::string name = path("a.json") + ": ";
  write("a.json", "beams");
  EXPECT_EQ(failure_of(file), name + "no JSON object");
  EXPECT_EQ(with("[30, -30]", "[30]").find(name + "beam_altitude_angles and beam_azimuth_angles"),
            0u);
  EXPECT_EQ(with("[30, -30]", "30"), name + "beam_altitude_angles is no list of numbers");
  EXPECT_EQ(with("[30, -30]", "[30, \"x\"]"), name + "beam_altitude_angles is no list of numbers");
  EXPECT_EQ(with("\"columns_per_frame\": 8", "\"columns_per_frame\": 0"),
            name + "columns_per_frame = 0: allowed: 1 to 8192");
  EXPECT_EQ(with("\"columns_per_frame\": 8", "\"columns_per_frame\": \"8\""),
            name + "columns_per_frame is no number");
  EXPECT_EQ(with("columns_per_frame", "columns"),
            name + "has no columns_per_frame and no lidar_mode such as 1024x10");
  EXPECT_EQ(with("[-1, 0, 0, 0, 0, -1", "[-1, 0, 0, 0, 0, -2"),
            name + "lidar_to_sensor_transform holds no rotation matrix");
  EXPECT_EQ(with("36, 0, 0, 0, 1]", "36]"), name + "lidar_to_sensor_transform has not 16 numbers");
  EXPECT_EQ(with("\"OS-T\"", "5"), name + "prod_line is no text");
  EXPECT_FALSE(is_ouster_metadata(file));
  EXPECT_EQ(with("\"OS-T\"", "\"OS-T\""), "none");
}

TEST_F(Pcap, DamagedFiles) {
  const std::string good = pcap_file(velodyne_turns(2));
  const fs::path file = write("a.pcap", good.substr(0, good.size() - 100));
  EXPECT_NE(failure_of(file).find(": the file is cut short or damaged"), std::string::npos);
  options_.keep_going = true;
  EXPECT_EQ(frames_of(file).size(), 1u);
  EXPECT_EQ(counts_.frames_skipped, (InputCounts::ByReason{{"broken log", 1}}));
  options_.keep_going = false;
  write("a.pcap", "no capture file, though it is long enough");
  EXPECT_EQ(failure_of(file), file.string() + ": no capture file: allowed: pcap or pcapng");
  write("a.pcap", "short");
  EXPECT_EQ(failure_of(file), file.string() + ": no capture file: allowed: pcap or pcapng");
  std::string huge = good;
  huge.replace(24 + 8, 4, little(std::uint32_t{1} << 30));
  write("a.pcap", huge);
  EXPECT_NE(failure_of(file).find("has no packets of a Velodyne sensor"), std::string::npos);
}

TEST_F(Pcap, DamagedBlocksOfPcapng) {
  const std::string good = pcapng_file(velodyne_turns(1));
  const std::size_t network = 28;  // behind the section
  const std::size_t packet = network + 44;
  const auto with = [&](std::size_t at, std::uint32_t number) {
    std::string text = good;
    text.replace(at, 4, little(number));
    return failure_of(write("a.pcapng", text));
  };
  EXPECT_EQ(with(0, 0x0a0d0d0a), "none");
  EXPECT_NE(with(4, 8).find("cut short or damaged"), std::string::npos);
  EXPECT_NE(with(8, 7).find("cut short or damaged"), std::string::npos);
  // Damage before the first packet is told as what is missing.
  for (const std::size_t at : {network + 4, packet + 4, packet + 8, packet + 20}) {
    EXPECT_NE(with(at, 77777777).find("has no packets of a Velodyne sensor"), std::string::npos)
        << at;
  }
  EXPECT_NE(with(packet, 3).find("has no packets of a Velodyne sensor"), std::string::npos);
}

TEST_F(Pcap, MemoryDoesNotGrowWithTheFile) {
  const auto source = open_recording(write("a.pcap", pcap_file(velodyne_turns(60))), options_);
  std::vector<std::size_t> heap;
  heap.reserve(60);
  for (Frame frame; source->next(frame);) heap.push_back(mallinfo2().uordblks);
  ASSERT_EQ(heap.size(), 60u);
  EXPECT_LE(heap[59], heap[10] + 65536);
}

}  // namespace
}  // namespace datasets
