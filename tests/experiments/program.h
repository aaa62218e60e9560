#pragma once
/// The program `ldm` as a test runs it, in a folder of its own.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "tests/temporary_folder.h"

namespace experiments {

struct Result {
  int code = -1;
  std::string out, error;
};

class Program : public testing::Test {
 protected:
  /// Runs `ldm ARGUMENTS` in the temporary folder, through a shell.
  Result ldm(const std::string& arguments, const std::string& environment = "") {
    return run(LDM_PROGRAM, arguments, environment);
  }
  Result run(const std::string& program, const std::string& arguments,
             const std::string& environment = "") {
    const std::string command = "cd " + folder_.path().string() + " && " + environment + " '" +
                                program + "' " + arguments + " >out 2>error";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, folder_.read("out"),
            folder_.read("error")};
  }
  /// Bad input: code 2, one line on stderr that holds `part`, nothing on stdout.
  void expect_bad(const std::string& arguments, const std::string& part) {
    const Result result = ldm(arguments);
    EXPECT_EQ(result.code, 2) << arguments;
    EXPECT_EQ(result.out, "") << arguments;
    EXPECT_TRUE(result.error.starts_with("ldm: ")) << result.error;
    EXPECT_EQ(std::count(result.error.begin(), result.error.end(), '\n'), 1) << result.error;
    EXPECT_NE(result.error.find(part), std::string::npos) << arguments << ": " << result.error;
  }
  bool exists(const std::string& name) const {
    return std::filesystem::exists(folder_.path() / name);
  }
  static std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
  std::string write_study(const std::string& more = "") {
    return folder_
        .write("tiny.toml",
               "title = \"tiny\"\nscenarios = [\"scenario1\"]\nmethods = [\"current_scan\"]\n"
               "seeds = 3\nframes = 4\n" +
                   more)
        .string();
  }

  tests::TemporaryFolder folder_;
};

}  // namespace experiments
