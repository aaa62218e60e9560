/// Recorded logs: what is broken is refused, in one line that names the file and the place.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "datasets/rawlog/rawlog.h"
#include "tests/datasets/rawlog/rawlog_recording.h"

namespace datasets {
namespace {

class RawlogErrors : public Rawlog {};

TEST_F(RawlogErrors, BadNamesAreRejected) {
  EXPECT_THROW(RawlogReader(file("flight.log")), ldm::InvalidInput);
  EXPECT_THROW(RawlogWriter(file("no/such/folder.rawlog"), recording_.lidar, {}),
               ldm::InvalidInput);
}

TEST_F(RawlogErrors, EveryMissingFileIsNamed) {
  for (const char* name : {"flight.rawlog", "flight.log.toml", "flight.frames.csv",
                           "flight.truth.csv", "flight.solids.csv"}) {
    const std::string saved = content(name);
    fs::remove(file(name));
    expect_failure(name, "");
    replace(name, saved);
  }
  EXPECT_EQ(failure(), "none");
}

TEST_F(RawlogErrors, TruncationAtAnyPlaceIsNamed) {
  const std::string whole = content("flight.rawlog");
  for (std::size_t size = 0; size < whole.size(); size += whole.size() / 23) {
    replace("flight.rawlog", whole.substr(0, size));
    expect_failure("flight.rawlog", "frame ");
  }
  replace("flight.rawlog", whole.substr(0, whole.size() - 1));  // in the checksum
  expect_failure("flight.rawlog", "frame 4");
}

TEST_F(RawlogErrors, AWrongByteAnywhereIsFoundByTheLastFrame) {
  const std::string whole = content("flight.rawlog");
  for (std::size_t place = 10; place < whole.size(); place += whole.size() / 23) {
    std::string damaged = whole;
    damaged[place] = static_cast<char>(damaged[place] ^ 0x55);
    replace("flight.rawlog", damaged);
    EXPECT_NE(failure(), "none") << place;
  }
}

TEST_F(RawlogErrors, GarbageAndTrailingDataAreNamed) {
  replace("flight.rawlog", "not a log at all");
  expect_failure("flight.rawlog", "frame 0");
  write();
  replace("flight.log.toml", "frames = 5", "frames = 4");
  remove_last_line("flight.frames.csv");
  EXPECT_NE(failure(), "none");
}

TEST_F(RawlogErrors, SidecarsOneLineShortAreNamedWithTheLine) {
  for (const auto& [name, place] :
       {std::pair{"flight.frames.csv", "csv:6: the file ends, allowed: 5 frames"},
        std::pair{"flight.truth.csv", "the file ends, but frame 4 has more objects"},
        std::pair{"flight.solids.csv", "the file ends, but object 21 of frame 4"}}) {
    const std::string saved = content(name);
    remove_last_line(name);
    expect_failure(name, place);
    replace(name, saved);
  }
}

TEST_F(RawlogErrors, SidecarsOneLineLongAreNamed) {
  for (const char* name : {"flight.frames.csv", "flight.truth.csv", "flight.solids.csv"}) {
    const std::string saved = content(name);
    const std::size_t last_line = saved.rfind('\n', saved.size() - 2) + 1;
    replace(name, saved + saved.substr(last_line));
    expect_failure(name, "a row too many");
    replace(name, saved);
  }
}

TEST_F(RawlogErrors, BadValuesAreNamedWithLineAndColumn) {
  const std::string frames = content("flight.frames.csv");
  replace("flight.frames.csv", "\n1,0.08", "\n1,soon");
  expect_failure("flight.frames.csv", "csv:3: time_s = soon: allowed: a finite number");
  replace("flight.frames.csv", frames);
  replace("flight.frames.csv", "\n1,0.08", "\n1,inf");
  expect_failure("flight.frames.csv", "csv:3: time_s = inf: allowed: a finite number");
  replace("flight.frames.csv", frames);
  replace("flight.frames.csv", "\n1,0.08", "\n3,0.08");
  expect_failure("flight.frames.csv", "csv:3: frame = 3: allowed: 1");
  replace("flight.frames.csv", frames);
  replace("flight.frames.csv", "\n1,0.08", "\n1,0.08,7");
  expect_failure("flight.frames.csv", "csv:3: 11 values, allowed: 10");
  replace("flight.frames.csv", frames.substr(0, frames.size() - 1));
  expect_failure("flight.frames.csv", "csv:6: the file ends in the middle of this line");
  replace("flight.frames.csv", frames);
  replace("flight.frames.csv", "frame,time_s", "time,frame");
  expect_failure("flight.frames.csv", "csv:1: allowed as first line: frame,time_s");
  replace("flight.frames.csv", frames);

  replace("flight.solids.csv", "\n0,1,box", "\n0,1,cone");
  expect_failure("flight.solids.csv", "csv:2: shape = cone: allowed: box, cylinder, sphere");
}

TEST_F(RawlogErrors, SidecarsOfAnotherLogAreNoticed) {
  replace("flight.frames.csv", "\n1,0.08", "\n1,0.09");
  expect_failure("flight.rawlog", "frame 1: its time is not that of");
  write();
  replace("flight.log.toml", "azimuths = 64", "azimuths = 65");
  expect_failure("flight.rawlog", "frame 0: its image is not as large as");
  write();
  replace("flight.log.toml", "format = 1", "format = 2");
  expect_failure("flight.log.toml", "format = 2");
}

}  // namespace
}  // namespace datasets
