/// A plugin whose maps are none: one method for each fault, each from its third frame on.
#include <functional>
#include <limits>

#include "ldm/local_dynamic_map.h"
#include "ldm/plugin.h"

namespace {

using Spoil = void(ldm::LocalMap&);

template <Spoil* kSpoil>
class BadMap final : public ldm::Mapper {
 public:
  explicit BadMap(const ldm::Parameters& parameters) : map_(parameters) {}
  void update(const ldm::Scan& scan, ldm::StageListener* listener) override {
    map_.update(scan, listener);
    ++frames_;
  }
  void read(ldm::LocalMap& map) const override {
    map_.read(map);
    if (frames_ > 2) kSpoil(map);
  }

 private:
  ldm::LocalDynamicMap map_;
  int frames_ = 0;
};

void not_a_number(ldm::LocalMap& map) {
  map.occupancy[4] = std::numeric_limits<float>::quiet_NaN();
}
void short_array(ldm::LocalMap& map) {
  map.occupancy.resize(100);
}
void wild_label(ldm::LocalMap& map) {
  map.labels[8] = 999;
}
void wild_cluster(ldm::LocalMap& map) {
  map.clusters.emplace_back().velocity.x() = std::numeric_limits<float>::quiet_NaN();
}

template <Spoil* kSpoil>
ldm::Method row(const char* name) {
  return {.name = name,
          .help = "spoils its map",
          .finds_clusters = true,
          .parameters = {"map", "particles"},
          .create = ldm::create<BadMap<kSpoil>>};
}

}  // namespace

LDM_PLUGIN(row<not_a_number>("not_a_number"), row<short_array>("short_array"),
           row<wild_label>("wild_label"), row<wild_cluster>("wild_cluster"))
