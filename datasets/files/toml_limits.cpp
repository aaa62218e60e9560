#include "datasets/files/toml_limits.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "ldm/types.h"

namespace datasets {
namespace {

/// Follows brackets and dotted keys through the text; strings and comments are stepped over.
class LevelCounter {
 public:
  LevelCounter(std::string_view text, std::string_view name) : text_(text), name_(name) {}

  void check() {
    while (at_ < text_.size()) step();
  }

 private:
  void step() {
    const char c = text_[at_];
    if (c == '"' || c == '\'') return skip_string(c);
    if (c == '#') return skip_comment();
    if (c == '[' || c == '{') limit(++brackets_, "brackets");
    if ((c == ']' || c == '}') && brackets_ > 0) --brackets_;
    if (c == '.') {
      limit(++dots_ + 1, "parts of a key");
    } else if (std::isalnum(static_cast<unsigned char>(c)) == 0 && !is_within_key(c)) {
      dots_ = 0;
    }
    if (c == '\n') ++line_;
    ++at_;
  }

  static bool is_within_key(char c) { return c == '_' || c == '-' || c == ' ' || c == '\t'; }

  void limit(int levels, const char* what) const {
    if (levels <= kMostTomlLevels) return;
    throw ldm::InvalidInput(std::string(name_) + ':' + std::to_string(line_) + ": more than " +
                            std::to_string(kMostTomlLevels) + ' ' + what + ": allowed: at most " +
                            std::to_string(kMostTomlLevels));
  }

  void skip_comment() { at_ = std::min(text_.find('\n', at_), text_.size()); }

  /// From an opening quotation mark, one or three, to behind its end. What has no end is the
  /// parser's to refuse.
  void skip_string(char mark) {
    const bool long_one = text_.substr(at_, 3) == std::string(3, mark);
    const std::string end(long_one ? 3 : 1, mark);
    at_ += end.size();
    for (bool escaped = false; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\n' && !long_one) return;
      if (!escaped && text_.substr(at_, end.size()) == end) {
        at_ += end.size();
        return;
      }
      escaped = !escaped && mark == '"' && text_[at_] == '\\';
      line_ += static_cast<int>(text_[at_] == '\n');
    }
  }

  std::string_view text_, name_;
  std::size_t at_ = 0;
  int line_ = 1, brackets_ = 0, dots_ = 0;
};

}  // namespace

void check_toml_limits(std::string_view text, std::string_view name) {
  if (text.size() > kMostTomlBytes) {
    throw ldm::InvalidInput(std::string(name) + ": " + std::to_string(text.size()) +
                            " bytes: allowed: at most " + std::to_string(kMostTomlBytes));
  }
  LevelCounter(text, name).check();
}

}  // namespace datasets
