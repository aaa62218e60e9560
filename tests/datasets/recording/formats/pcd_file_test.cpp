/// PCD files: what PCL wrote reads the same in all encodings, and lies of a header are found.
#include "datasets/recording/formats/pcd_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "datasets/recording/scans/broken_frame.h"
#include "tests/source_folder.h"
#include "tests/text_file.h"

namespace datasets {
namespace {

/// Written by PCL 1.13's pcl_convert_pcd_ascii_binary: 24 points with fields x y z intensity ring,
/// three of them without a return.
std::string fixture(const std::string& name) {
  std::ifstream stream(
      tests::source_folder() / "tests/datasets/recording/formats/pcd" / (name + ".pcd"),
      std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<ldm::Point> points_of(const std::string& content) {
  std::vector<ldm::Point> points;
  parse_pcd(content, "x.pcd", points);
  return points;
}

std::string error_of(const std::string& content) {
  return tests::message_of<BrokenFrame>([&] { points_of(content); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  EXPECT_NE(text.find(from), std::string::npos) << from;
  return text.replace(text.find(from), from.size(), to);
}

constexpr char kHeader[] =
    "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 2\nHEIGHT 1\nPOINTS 2\nDATA ";

template <class T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// The body of a binary_compressed file, whose LZF copies all bytes in runs of at most 32.
std::string compressed(const std::string& bytes) {
  std::string runs;
  for (std::size_t i = 0; i < bytes.size(); i += 32) {
    const std::string run = bytes.substr(i, 32);
    runs += static_cast<char>(run.size() - 1) + run;
  }
  std::string body;
  append(body, static_cast<std::uint32_t>(runs.size()));
  append(body, static_cast<std::uint32_t>(bytes.size()));
  return body + runs;
}

/// Two points of the lowest numbers, the highest, and 1 to 4.
template <class T>
void expect_type(const std::string& type) {
  const T low = std::numeric_limits<T>::lowest();
  const T high = std::numeric_limits<T>::max();
  const T numbers[2][3] = {{low, high, 1}, {2, 3, 4}};
  std::string points, fields;
  for (const auto& point : numbers) {
    for (const T number : point) append(points, number);
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (const auto& point : numbers) append(fields, point[axis]);
  }
  const std::string size = std::to_string(sizeof(T));
  const std::string header = "FIELDS x y z\nSIZE " + size + ' ' + size + ' ' + size + "\nTYPE " +
                             type + ' ' + type + ' ' + type + "\nWIDTH 2\nDATA ";
  const std::vector<ldm::Point> expected = {{static_cast<float>(low), static_cast<float>(high), 1},
                                            {2, 3, 4}};
  EXPECT_EQ(points_of(header + "binary\n" + points), expected) << type << size;
  EXPECT_EQ(points_of(header + "binary_compressed\n" + compressed(fields)), expected)
      << type << size;
}

std::string ascii(const std::string& points) {
  return kHeader + std::string("ascii\n") + points;
}

TEST(PcdFile, ReadsWhatPclWroteInEveryEncoding) {
  const std::vector<ldm::Point> points = points_of(fixture("ascii"));
  ASSERT_EQ(points.size(), 24u);
  EXPECT_EQ(points[0], ldm::Point(-10.4814F, 1.7692F, -5.2018F));
  EXPECT_TRUE(std::isnan(points[3].x()) && std::isnan(points[17].z()));
  for (const char* encoding : {"binary", "binary_compressed"}) {
    const std::vector<ldm::Point> same = points_of(fixture(encoding));
    ASSERT_EQ(same.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_TRUE(same[i][axis] == points[i][axis] ||
                    (std::isnan(same[i][axis]) && std::isnan(points[i][axis])))
            << encoding << " point " << i;
      }
    }
  }
}

TEST(PcdFile, TakesOldHeadersOtherTypesAndOrders) {
  const auto points = points_of(
      "# a comment\nCOLUMNS y normal x z\nSIZE 8 4 2 1\nTYPE F F I U\nCOUNT 1 2 1 1\nWIDTH 1\n"
      "DATA ascii\n2.5 9 9 -300 200\n");
  ASSERT_EQ(points.size(), 1u);
  EXPECT_EQ(points[0], ldm::Point(-300, 2.5F, 200));
  std::string binary =
      "FIELDS y x z\nSIZE 8 2 1\nTYPE F I U\nWIDTH 1\nHEIGHT 1\nVIEWPOINT 1 2 3 1 0 0 0\n"
      "POINTS 1\nDATA binary\n";
  const double y = 2.5;
  const std::int16_t x = -300;
  binary.append(reinterpret_cast<const char*>(&y), 8);
  binary.append(reinterpret_cast<const char*>(&x), 2);
  binary.push_back(static_cast<char>(200));
  EXPECT_EQ(points_of(binary).at(0), ldm::Point(-300, 2.5F, 200));
}

TEST(PcdFile, TakesFieldsInCapitals) {
  const std::string good = replaced(ascii("1 2 3\n4 5 6\n"), "x y z", "X Y Z");
  const std::vector<ldm::Point> expected = {{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(points_of(good), expected);
  for (const char* fields : {"X x y z", "x X y z"}) {  // x is meant, wherever it stands
    const std::vector<ldm::Point> points =
        points_of(std::string("FIELDS ") + fields +
                  "\nSIZE 4 4 4 4\nTYPE F F F F\nWIDTH 1\nDATA ascii\n1 2 3 4\n");
    EXPECT_EQ(points.at(0), ldm::Point(fields[0] == 'x' ? 1.F : 2.F, 3, 4)) << fields;
  }
}

TEST(PcdFile, TakesAnEncodingInCapitals) {
  EXPECT_EQ(points_of(kHeader + std::string("ASCII\n1 2 3\n4 5 6\n")).at(1), ldm::Point(4, 5, 6));
  std::string bytes;
  for (const float number : {1.F, 2.F, 3.F, 4.F, 5.F, 6.F}) append(bytes, number);
  EXPECT_EQ(points_of(kHeader + ("Binary\n" + bytes)).at(1), ldm::Point(4, 5, 6));
}

TEST(PcdFile, PointsAloneSayHowManyThereAre) {
  const std::string lines = "DATA ascii\n1 2 3\n4 5 6\n";
  const std::string header = "VERSION .5\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n";
  EXPECT_EQ(points_of(header + "POINTS 2\n" + lines).size(), 2u);
  EXPECT_EQ(error_of(header + lines), "x.pcd: its header has no WIDTH");
  EXPECT_EQ(error_of(header + "HEIGHT 1\nPOINTS 2\n" + lines), "x.pcd: its header has no WIDTH");
}

TEST(PcdFile, TakesEveryType) {
  expect_type<std::int8_t>("I");
  expect_type<std::int16_t>("I");
  expect_type<std::int32_t>("I");
  expect_type<std::int64_t>("I");
  expect_type<std::uint8_t>("U");
  expect_type<std::uint16_t>("U");
  expect_type<std::uint32_t>("U");
  expect_type<std::uint64_t>("U");
  expect_type<float>("F");
  expect_type<double>("F");
}

TEST(PcdFile, OtherFieldsDoNotMatter) {
  const std::string header =
      "FIELDS histogram z _ x x y _\nSIZE 2 4 1 4 8 4 1\nTYPE U F U F F F I\n"
      "COUNT 2 1 3 1 0 1 1\nWIDTH 2\nDATA ";
  const std::vector<ldm::Point> expected = {{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(points_of(header + "ascii\nnan what 3 _ _ _ 1 2 0\n8 8 6 nan 0 1e999 4 5 six\n"),
            expected);
  std::string points;
  for (const ldm::Point& p : expected) {
    points += "hhhh";
    append(points, p.z());
    points += "___";
    append(points, p.x());
    append(points, p.y());
    points += "_";
  }
  EXPECT_EQ(points_of(header + "binary\n" + points), expected);
  std::string fields = "hhhhhhhh";
  for (const ldm::Point& p : expected) append(fields, p.z());
  fields += "______";
  for (const ldm::Point& p : expected) append(fields, p.x());
  for (const ldm::Point& p : expected) append(fields, p.y());
  fields += "__";
  EXPECT_EQ(points_of(header + "binary_compressed\n" + compressed(fields)), expected);
}

TEST(PcdFile, AsciiNumbersAreWhatIsWritten) {
  const auto points = points_of(
      "FIELDS x y z\nSIZE 1 2 4\nTYPE U I F\nWIDTH 2\nDATA ascii\n"
      "300 -2.5 0.1\r\n \r\n\t1e-40 inf\t16777217\r\n\r\n");
  const std::vector<ldm::Point> expected = {
      {300, -2.5F, 0.1F}, {1e-40F, std::numeric_limits<float>::infinity(), 16777216}};
  EXPECT_EQ(points, expected);
  EXPECT_EQ(points_of(ascii("+1e0 +0.25 -3\n4 +5 6\n")).at(0), ldm::Point(1, 0.25F, -3));
  for (const char* none : {"+-1", "+", "++1", "1+"}) {
    EXPECT_EQ(error_of(ascii(none + std::string(" 2 3\n4 5 6\n"))),
              "x.pcd:9: " + std::string(none) + ": allowed: a number or nan");
  }
}

TEST(PcdFile, AnEmptyCloudIsOne) {
  const std::string no_bytes(8, '\0');
  for (const std::string& encoding :
       {std::string("ascii\n"), std::string("binary\n"), "binary_compressed\n" + no_bytes}) {
    EXPECT_TRUE(
        points_of("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 0\nDATA " + encoding).empty());
  }
}

TEST(PcdFile, HeadersThatAreNone) {
  EXPECT_EQ(error_of(""),
            "x.pcd:1: the file ends in its header: allowed: a PCD file, whose header "
            "ends with DATA");
  EXPECT_NE(error_of("ply\nformat ascii 1.0\n").find("x.pcd:1: allowed: an entry of a PCD header"),
            std::string::npos);
  const std::string good = ascii("1 2 3\n4 5 6\n");
  EXPECT_EQ(points_of(good).size(), 2u);
  const auto error = [&](const std::string& from, const std::string& to) {
    return error_of(replaced(good, from, to));
  };
  EXPECT_NE(error("FIELDS x y z\n", "").find("its header has no FIELDS"), std::string::npos);
  EXPECT_NE(error("x y z", "x y i").find(":2: FIELDS: allowed: x, y and z"), std::string::npos);
  std::string many = "FIELDS";
  for (int i = 0; i < 257; ++i) many += " a";
  EXPECT_NE(error("FIELDS x y z", many).find(":2: FIELDS: allowed: at most 256 fields"),
            std::string::npos);
  EXPECT_NE(error("4 4 4", "4 4 3").find(":3: SIZE: allowed: 1, 2, 4 or 8"), std::string::npos);
  EXPECT_NE(error("4 4 4", "4 4").find(":3: SIZE: 2 values: allowed: 3"), std::string::npos);
  EXPECT_NE(error("4 4 4", "4 4 2").find("allowed for type F: 4 or 8"), std::string::npos);
  EXPECT_NE(error("F F F", "F F G").find(":4: TYPE: allowed: I, U or F"), std::string::npos);
  EXPECT_NE(error("WIDTH 2", "WIDTH -2").find(":5: WIDTH: allowed: whole numbers up to"),
            std::string::npos);
  EXPECT_NE(error("HEIGHT 1", "HEIGHT 2").find(":7: POINTS: allowed: 4 as WIDTH and HEIGHT say"),
            std::string::npos);
  EXPECT_NE(error("DATA ascii", "DATA xml").find(":8: DATA: allowed: ascii, binary"),
            std::string::npos);
  EXPECT_NE(error_of(replaced(replaced(good, "WIDTH 2", "WIDTH 134217728"), "HEIGHT 1\nPOINTS 2",
                              "HEIGHT 134217728"))
                .find("WIDTH: allowed: at most 134217728 points"),
            std::string::npos);
}

TEST(PcdFile, AsciiOfAnotherLengthThanItsHeaderSays) {
  EXPECT_EQ(error_of(ascii("1 2 3\n")),
            "x.pcd:10: the file ends: allowed: 2 points, as the header says");
  EXPECT_EQ(error_of(ascii("1 2 3\n4 5 6\n7 8 9\n")),
            "x.pcd:11: a line too many: the header says otherwise");
  EXPECT_EQ(error_of(ascii("1 2 3\n4 5\n")), "x.pcd:10: 2 values: allowed: 3, as the header says");
  EXPECT_EQ(error_of(ascii("1 2 3\n4 5 six\n")), "x.pcd:10: six: allowed: a number or nan");
  EXPECT_EQ(error_of(ascii("1 2 3\n4 5 1e999\n")), "x.pcd:10: 1e999: allowed: a number or nan");
}

TEST(PcdFile, BinaryOfAnotherLengthThanItsHeaderSays) {
  const std::string header = kHeader + std::string("binary\n");
  const std::string place = "x.pcd: byte " + std::to_string(header.size()) + ": ";
  EXPECT_EQ(error_of(header + std::string(23, 'a')),
            place + "23 bytes of points follow: allowed: 24, as the header says");
  EXPECT_EQ(error_of(header + std::string(36, 'a')),
            place + "36 bytes of points follow: allowed: 24, as the header says");
  EXPECT_EQ(points_of(header + std::string(24, 'a') + std::string(9, '\0')).size(), 2u);
  for (const std::string& end : {std::string("\n"), std::string("\r\n"), std::string("\n\0", 2)}) {
    EXPECT_EQ(points_of(header + std::string(24, 'a') + end).size(), 2u);
    EXPECT_EQ(points_of(kHeader + ("binary_compressed\n" + compressed(std::string(24, 'a'))) + end)
                  .size(),
              2u);
  }
  EXPECT_EQ(error_of(header + std::string(24, 'a') + "\n\n"),
            place + "26 bytes of points follow: allowed: 24, as the header says");
}

TEST(PcdFile, CompressedPointsThatAreDamaged) {
  const std::string whole = fixture("binary_compressed");
  const std::size_t begin = whole.find("binary_compressed\n") + 18;
  EXPECT_NE(error_of(whole.substr(0, begin + 5)).find("5 bytes of points follow: allowed: 8"),
            std::string::npos);
  EXPECT_NE(error_of(whole.substr(0, begin + 100)).find("92 bytes of points follow: allowed: "),
            std::string::npos);
  std::string other_size = whole;
  other_size[begin + 4] = 1;
  EXPECT_NE(error_of(other_size).find("uncompressed size"), std::string::npos);
  std::string damaged = whole;
  damaged[begin + 8] = '\xff';  // a reference to what lies before the beginning
  EXPECT_EQ(error_of(damaged),
            "x.pcd: byte " + std::to_string(begin + 8) + ": the compressed points are damaged");
  const std::string nothing = kHeader + std::string("binary_compressed\n") +
                              std::string("\0\0\0\0\x18\0\0\0", 8);  // 24 bytes out of none
  EXPECT_NE(error_of(nothing).find("the compressed points are damaged"), std::string::npos);
}

TEST(PcdFile, ASmallFileCannotAskForMuchMemory) {
  std::string bomb =
      "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 134217728\nDATA binary_compressed\n";
  const std::uint32_t sizes[2] = {4, 134217728U * 12U};
  bomb.append(reinterpret_cast<const char*>(sizes), sizeof sizes).append("abcd");
  EXPECT_NE(error_of(bomb).find("the compressed points are damaged"), std::string::npos);
}

}  // namespace
}  // namespace datasets
