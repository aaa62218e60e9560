#include "datasets/recording/formats/pcd_reader.h"

#include <string>
#include <vector>

#include "datasets/recording/formats/pcd_file.h"
#include "datasets/recording/formats/scan_folder_reader.h"
#include "datasets/recording/scans/scan_names.h"

namespace datasets {

std::unique_ptr<ScanReader> open_pcd_folder(const std::filesystem::path& folder,
                                            const RecordingOptions& options) {
  ScanFolder scans;
  scans.folder = folder;
  scans.names = scan_names(folder, kPcdEnding);
  scans.load = [content = std::string()](const std::filesystem::path& file,
                                         std::vector<ldm::Point>& points) mutable {
    read_scan_file(file, content);
    parse_pcd(content, file.string(), points);
  };
  scans.timeline = timeline_files(folder / "times.txt", folder / "poses.txt", options);
  return std::make_unique<ScanFolderReader>(std::move(scans), options);
}

}  // namespace datasets
