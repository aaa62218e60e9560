/// Scans by their names: natural order, and the lines that belong to them.
#include "datasets/recording/scans/scan_names.h"

#include <gtest/gtest.h>

namespace datasets {
namespace {

using Names = std::vector<std::string>;

TEST(ScanNames, NumbersCountByTheirValue) {
  EXPECT_TRUE(natural_less("2.pcd", "10.pcd"));
  EXPECT_TRUE(natural_less("a2b3", "a2b12"));
  EXPECT_TRUE(natural_less("a", "a1"));
  EXPECT_TRUE(natural_less("007", "8"));
  EXPECT_TRUE(natural_less("01", "1") != natural_less("1", "01"));
  EXPECT_FALSE(natural_less("x", "x"));
}

TEST(ScanNames, FractionsOfTimes) {
  EXPECT_TRUE(natural_less("22.25.pcd", "22.3.pcd", true));
  EXPECT_TRUE(natural_less("T22.25Z.pcd", "T22.3Z.pcd", true));
  EXPECT_TRUE(natural_less("T22Z.pcd", "T22.25Z.pcd", true));
  EXPECT_TRUE(natural_less("9.5.pcd", "10.25.pcd", true));
  EXPECT_TRUE(natural_less("1.9.pcd", "1.10.pcd"));
}

TEST(ScanNames, WhatADotMeans) {
  EXPECT_TRUE(have_fractions({"22.25.pcd", "22.3.pcd"}));
  EXPECT_FALSE(have_fractions({"1.9.pcd", "1.10.pcd", "1.11.pcd"}));
  EXPECT_FALSE(have_fractions({"22.25.pcd", "22.30.pcd"}));  // both ways the same order
  EXPECT_FALSE(have_fractions({"scan.9.pcd", "scan.10.pcd"}));
  EXPECT_FALSE(have_fractions({"8.pcd", "10.pcd"}));
}

TEST(ScanNames, EndingsInCapitalsAndHiddenFiles) {
  EXPECT_TRUE(is_scan_name("a/0000.PCD", ".pcd"));
  EXPECT_TRUE(is_scan_name("LIDAR_TOP__1532402927647951.pcd.bin", ".bin"));
  EXPECT_FALSE(is_scan_name("a/._0000.pcd", ".pcd"));
  EXPECT_FALSE(is_scan_name(".pcd", ".pcd"));
  EXPECT_FALSE(is_scan_name("0000.pcd~", ".pcd"));
}

TEST(ScanNames, AsManyLinesAsScansGoInOrder) {
  EXPECT_EQ(scan_of_each_line({"5.bin", "9.bin"}, 2), (Names{"5.bin", "9.bin"}));
  EXPECT_EQ(scan_of_each_line({"a.pcd", "b.pcd"}, 2), (Names{"a.pcd", "b.pcd"}));
}

TEST(ScanNames, NumbersTellWhatIsMissing) {
  EXPECT_EQ(scan_of_each_line({"0.bin", "2.bin"}, 3), (Names{"0.bin", "", "2.bin"}));
  EXPECT_EQ(scan_of_each_line({"05.bin", "07.bin"}, 3), (Names{"05.bin", "", "07.bin"}));
  EXPECT_EQ(scan_of_each_line({"1.bin", "2.bin"}, 3), (Names{"", "1.bin", "2.bin"}));
  EXPECT_EQ(scan_of_each_line({"0000000000.bin", "0000000002.bin"}, 3),  // as KITTI has them
            (Names{"0000000000.bin", "", "0000000002.bin"}));
}

TEST(ScanNames, ElseNothingDoes) {
  EXPECT_FALSE(scan_of_each_line({"0.bin", "2.bin"}, 4));
  EXPECT_FALSE(scan_of_each_line({"0.bin", "1.bin"}, 1));
  EXPECT_FALSE(scan_of_each_line({"a.pcd", "c.pcd"}, 3));
  EXPECT_FALSE(scan_of_each_line({"1.bin", "01.bin"}, 3));
  EXPECT_FALSE(scan_of_each_line({"1532402927647951.bin", "1532402927647953.bin"}, 3));
}

}  // namespace
}  // namespace datasets
