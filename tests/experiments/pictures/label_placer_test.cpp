#include "experiments/pictures/label_placer.h"

#include <gtest/gtest.h>

namespace experiments {
namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;

const AlignedBox2d kNamed(Vector2d(100, 100), Vector2d(120, 110));

TEST(LabelPlacer, PlacesALabelAbove) {
  const AlignedBox2d box = LabelPlacer().place({40, 10}, kNamed);
  EXPECT_EQ(box.center().x(), 110);
  EXPECT_LT(box.max().y(), kNamed.min().y());
  EXPECT_EQ(box.sizes(), Vector2d(40, 10));
}

TEST(LabelPlacer, AvoidsWhatIsThereAndItsOwnLabels) {
  LabelPlacer placer;
  placer.keep_clear({Vector2d(0, 0), Vector2d(300, 95)});
  EXPECT_GT(placer.place({40, 10}, kNamed).min().y(), kNamed.max().y());
  EXPECT_GT(placer.place({40, 10}, kNamed).min().x(), kNamed.max().x());
  EXPECT_LT(placer.place({40, 10}, kNamed).max().x(), kNamed.min().x());
}

TEST(LabelPlacer, CoversAsLittleAsItMust) {
  LabelPlacer placer;
  placer.keep_clear({Vector2d(0, 0), Vector2d(300, 300)});
  placer.keep_clear({Vector2d(0, 0), Vector2d(300, 105)});
  EXPECT_GT(placer.place({40, 10}, kNamed).min().y(), kNamed.max().y());
}

}  // namespace
}  // namespace experiments
