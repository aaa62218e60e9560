/// Libraries beside the program: there or not, and fit for it or not.
#include "datasets/files/loaded_library.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/text_file.h"

namespace datasets {
namespace {

/// Of tests/variants: its function is `answer`.
constexpr char kLibrary[] = "variants/plugins/no_plugin.so";

std::string error_of(const char* file, const char* name) {
  return tests::message_of<std::runtime_error>([&] { loaded_symbol(file, name); });
}

TEST(LoadedLibrary, HasTheFunctionOrIsNotThere) {
  EXPECT_NE(loaded_symbol(kLibrary, "answer"), nullptr);
  EXPECT_EQ(loaded_symbol("ldm_no_such.so", "answer"), nullptr);
}

TEST(LoadedLibrary, OneThatDoesNotFit) {
  EXPECT_NE(error_of(kLibrary, "no_such_function").find("no_plugin.so: of another version"),
            std::string::npos);
  EXPECT_NE(error_of("datasets_tests", "answer").find("datasets_tests: "), std::string::npos);
}

}  // namespace
}  // namespace datasets
