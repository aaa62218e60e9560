#include "datasets/recording/formats/pcap/pcap_contents.h"

#include <algorithm>
#include <optional>

#include "datasets/files/text.h"
#include "datasets/recording/formats/pcap/ouster_metadata.h"
#include "datasets/recording/formats/pcap/ouster_scans.h"
#include "datasets/recording/formats/pcap/velodyne_scans.h"
#include "datasets/recording/scans/broken_frame.h"
#include "datasets/recording/scans/scan_names.h"

namespace datasets {
namespace {

namespace fs = std::filesystem;

/// @param several names them, if nothing tells which
std::optional<fs::path> metadata_beside(const fs::path& file, std::string& several) {
  const fs::path own = fs::path(file).replace_extension(".json");
  if (fs::exists(own)) return own;
  std::vector<std::string> found;
  std::error_code error;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(fs::absolute(file).parent_path(), error)) {
    if (is_scan_name(entry.path(), ".json") && is_ouster_metadata(entry.path())) {
      found.push_back(entry.path().filename().string());
    }
  }
  std::sort(found.begin(), found.end());
  if (found.size() > 1) several = joined(found);
  if (found.size() != 1) return {};
  return file.parent_path() / found.front();
}

}  // namespace

std::string PcapStream::text() const {
  return source + " to port " + std::to_string(port) + ": " + std::to_string(size) + " bytes";
}

std::vector<PcapStream> read_streams(const fs::path& file) {
  std::vector<PcapStream> streams;
  UdpDatagrams datagrams(file);
  try {
    for (Datagram datagram; datagrams.next(datagram);) {
      auto stream = std::find_if(streams.begin(), streams.end(),
                                 [&](const PcapStream& known) { return known.has(datagram); });
      if (stream == streams.end()) {
        streams.push_back({datagram.source, datagram.port, datagram.payload.size(), 0,
                           datagram.time, datagram.time});
        stream = streams.end() - 1;
      }
      ++stream->datagrams;
      stream->last = datagram.time;
    }
  } catch (const BrokenFrame&) {  // which is told when its turn comes
  }
  return streams;
}

PcapPlan plan_of_pcap(const fs::path& file) {
  PcapPlan plan;
  UdpDatagrams datagrams(file);
  std::string several;
  const std::optional<fs::path> metadata = metadata_beside(file, several);
  if (metadata) plan.scans = ouster_scans(*metadata);
  try {
    for (Datagram datagram; datagrams.next(datagram);) {
      if (is_velodyne(datagram)) {
        plan.scans = velodyne_scans(datagram, datagrams.place());
      } else if (!plan.scans || !plan.scans->is_packet(datagram)) {
        continue;
      }
      plan.source = datagram.source;
      plan.port = datagram.port;
      return plan;
    }
  } catch (const BrokenFrame&) {  // the file ends before the first packet
  }
  if (metadata) {
    throw ldm::InvalidInput(file.string() + ": has no packets of the sensor of " +
                            metadata->string());
  }
  const std::string own = fs::path(file).replace_extension(".json").filename().string();
  if (!several.empty()) {
    throw ldm::InvalidInput(file.string() + ": several metadata files beside it, " + several +
                            ": allowed: " + own);
  }
  throw ldm::InvalidInput(file.string() +
                          ": has no packets of a Velodyne sensor: allowed: those, or an Ouster "
                          "sensor's with its metadata in " +
                          own);
}

}  // namespace datasets
