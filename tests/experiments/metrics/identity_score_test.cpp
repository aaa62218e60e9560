#include "experiments/metrics/identity_score.h"

#include <gtest/gtest.h>

#include <functional>

namespace experiments {
namespace {

/// Ten frames a second; `change` edits each sighting of an object in view that is track 7.
IdentityTally play(int frames, const std::function<void(int, Sighting&)>& change) {
  IdentityTally tally;
  for (int k = 0; k < frames; ++k) {
    Sighting seen{.object = 3, .time = 0.1 * k, .in_map = true, .visible = true, .track = 7};
    change(k, seen);
    tally.add(seen);
  }
  tally.finish();
  return tally;
}

/// 7 to 8 and back in 1.9 s in the map; a second object has no track and counts for nothing.
TEST(IdentityScore, SwitchesAMinuteAreOverTheTimeInTheMap) {
  IdentityTally tally;
  for (int k = 0; k < 20; ++k) {
    tally.add({.object = 3,
               .time = 0.1 * k,
               .in_map = true,
               .visible = true,
               .track = k < 5 || k >= 10 ? 7 : 8});
    tally.add({.object = 4, .time = 0.1 * k, .in_map = true, .visible = true, .track = {}});
  }
  EXPECT_FALSE(tally.switches_per_minute());
  tally.finish();
  EXPECT_NEAR(*tally.switches_per_minute(), 2 / (1.9 / 60), 1e-9);
}

void hide(int k, int from, int to, Sighting& seen) {
  if (k >= from && k < to) seen.visible = false;
}

TEST(IdentityScore, AnObjectInViewKeepsItsTrack) {
  const IdentityTally tally = play(20, [](int, Sighting&) {});
  EXPECT_EQ(tally.tracks().value(), 1);
  EXPECT_EQ(tally.switches().value(), 0);
  EXPECT_FALSE(tally.kept().value());
  EXPECT_FALSE(tally.hidden_matched().value());
}

TEST(IdentityScore, CountsTracksAndSwitches) {
  const IdentityTally tally = play(20, [](int k, Sighting& seen) {
    if (k >= 5) seen.track = 8;
    if (k >= 10) seen.track = 7;
    if (k == 15) seen.track.reset();  // no switch: nothing was matched
  });
  EXPECT_EQ(tally.tracks().value(), 2);
  EXPECT_EQ(tally.switches().value(), 2);
}

TEST(IdentityScore, AStayEndsOutsideTheMap) {
  const IdentityTally tally = play(20, [](int k, Sighting& seen) {
    seen.in_map = k != 10;
    if (k > 10) seen.track = 9;
  });
  EXPECT_EQ(tally.tracks().count(), 2);
  EXPECT_EQ(tally.tracks().value(), 1);
  EXPECT_EQ(tally.switches().value(), 0);
}

TEST(IdentityScore, AStayWithoutTrackDoesNotCount) {
  const IdentityTally tally = play(20, [](int, Sighting& seen) { seen.track.reset(); });
  EXPECT_EQ(tally.tracks().count(), 0);
}

TEST(IdentityScore, AKeptOcclusion) {
  const IdentityTally tally = play(20, [](int k, Sighting& seen) {
    hide(k, 5, 9, seen);
    if (k == 6) seen.track.reset();
  });
  EXPECT_EQ(tally.kept().count(), 1);
  EXPECT_EQ(tally.kept().value(), 1);
  EXPECT_EQ(tally.hidden_matched().count(), 4);
  EXPECT_EQ(tally.hidden_matched().value(), 0.75);
}

TEST(IdentityScore, ASwitchInHidingIsALoss) {
  const IdentityTally tally = play(20, [](int k, Sighting& seen) {
    hide(k, 5, 9, seen);
    if (k >= 7) seen.track = 8;  // the track of whoever hides it
  });
  EXPECT_EQ(tally.kept().value(), 0);
  EXPECT_EQ(tally.switches().value(), 1);
}

TEST(IdentityScore, ATrackFoundAgainWithinASecondIsKept) {
  const auto kept = [](int found) {
    return play(40,
                [found](int k, Sighting& seen) {
                  hide(k, 5, 9, seen);
                  if (k >= 6 && k < found) seen.track.reset();
                })
        .kept();
  };
  EXPECT_EQ(kept(18).value(), 1);  // in view again from frame 9 on
  EXPECT_EQ(kept(21).value(), 0);
  EXPECT_EQ(kept(21).count(), 1);
}

TEST(IdentityScore, HidingTwiceBeforeItIsFoundIsOneOcclusion) {
  const IdentityTally tally = play(40, [](int k, Sighting& seen) {
    hide(k, 5, 9, seen);
    hide(k, 10, 12, seen);
    if (k >= 5 && k < 14) seen.track.reset();
  });
  EXPECT_EQ(tally.kept().count(), 1);
  EXPECT_EQ(tally.kept().value(), 1);
}

TEST(IdentityScore, WhatWasNeverTrackedHasNothingToKeep) {
  const IdentityTally tally = play(20, [](int k, Sighting& seen) {
    seen.visible = k >= 5;
    if (k < 5) seen.track.reset();
  });
  EXPECT_EQ(tally.kept().count(), 0);
  EXPECT_EQ(tally.hidden_matched().count(), 0);
}

TEST(IdentityScore, LeavingTheMapWhileHiddenDecidesNothing) {
  const IdentityTally tally = play(20, [](int k, Sighting& seen) {
    if (k >= 5) seen.visible = false;
    if (k >= 8) seen.in_map = false;
  });
  EXPECT_EQ(tally.kept().count(), 0);
  EXPECT_EQ(tally.hidden_matched().count(), 3);
}

}  // namespace
}  // namespace experiments
