/// The program `ldm_bench`: times of whole frames and their stages as CSV on standard output.
#include <iostream>
#include <string>
#include <vector>

#include "datasets/files/text.h"
#include "experiments/benchmarks/report.h"

namespace {

constexpr char kUsage[] =
    "usage: ldm_bench [--frames N] [--only PREFIX]...\n"
    "Times of whole frames, of N (100) each, where the name begins with a PREFIX (default: all).\n"
    "A name is SUBJECT/VOXELS/PARTICLES/RAYS/THREADS, for instance ldm/32^3/200000/16x1024/1.\n";
constexpr std::int64_t kFewestFrames = benchmarks::kWarmUp + 2;
constexpr std::int64_t kMostFrames = 1200;

struct Options {
  std::int64_t frames = 100;
  std::vector<std::string> prefixes;
};

/// @throws ldm::InvalidInput unless the text is an allowed number of frames.
std::int64_t frames_in(const std::string& text) {
  std::int64_t frames = 0;
  if (!datasets::parse_number(text, frames) || frames < kFewestFrames || frames > kMostFrames) {
    throw ldm::InvalidInput("--frames " + text + ": allowed: " + std::to_string(kFewestFrames) +
                            " to " + std::to_string(kMostFrames));
  }
  return frames;
}

/// @throws ldm::InvalidInput on anything else than the usage says.
Options parse(const std::vector<std::string>& words) {
  Options options;
  for (std::size_t i = 0; i < words.size(); i += 2) {
    const bool has_value = i + 1 < words.size();
    if (words[i] == "--only" && has_value) {
      options.prefixes.push_back(words[i + 1]);
    } else if (words[i] == "--frames" && has_value) {
      options.frames = frames_in(words[i + 1]);
    } else {
      throw ldm::InvalidInput("argument " + words[i] + ": allowed: --frames N, --only PREFIX");
    }
  }
  return options;
}

void measure(const Options& options) {
  const std::vector<benchmarks::Configuration> chosen =
      benchmarks::configurations(options.prefixes);
  if (chosen.empty()) {
    throw ldm::InvalidInput("--only " + datasets::joined(options.prefixes) +
                            ": no name begins so: allowed, for instance: ldm/32^3");
  }
  benchmarks::Scans scans(options.frames);
  std::vector<benchmarks::Timed> all;
  for (const benchmarks::Configuration& c : chosen) {
    all.push_back({c, benchmarks::make_subject(c, scans, options.frames), {}, {}});
  }
  benchmarks::run_interleaved(all, static_cast<std::size_t>(options.frames));
  benchmarks::print_build(options.frames, std::cout);
  benchmarks::print_footprint(scans, std::cout);
  benchmarks::print_samples(all, std::cout);
  if (!std::cout.flush()) throw std::runtime_error("standard output cannot be written");
}

int complain(const std::exception& error, int code) {
  std::cerr << "ldm_bench: " << error.what() << '\n';
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words == std::vector<std::string>{"--help"}) {
    std::cout << kUsage;
    return 0;
  }
  try {
    measure(parse(words));
    return 0;
  } catch (const ldm::InvalidInput& error) {
    return complain(error, 2);
  } catch (const std::exception& error) {
    return complain(error, 1);
  }
}
