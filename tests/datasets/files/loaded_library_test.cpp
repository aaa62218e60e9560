/// Libraries beside the program: there or not, and fit for it or not.
#include "datasets/files/loaded_library.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "datasets/recording/formats/pcd_decoder.h"
#include "tests/text_file.h"

namespace datasets {
namespace {

std::string error_of(const char* file, const char* name) {
  return tests::message_of<std::runtime_error>([&] { loaded_symbol(file, name); });
}

TEST(LoadedLibrary, HasTheFunctionOrIsNotThere) {
  EXPECT_NE(loaded_symbol(kPcdLibrary, kDecodePcd), nullptr);
  EXPECT_EQ(loaded_symbol("ldm_no_such.so", kDecodePcd), nullptr);
}

TEST(LoadedLibrary, OneThatDoesNotFit) {
  EXPECT_NE(error_of(kPcdLibrary, "no_such_function").find("ldm_pcd.so: of another version"),
            std::string::npos);
  EXPECT_NE(error_of("datasets_tests", kDecodePcd).find("datasets_tests: "), std::string::npos);
}

}  // namespace
}  // namespace datasets
