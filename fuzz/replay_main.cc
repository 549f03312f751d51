// Runs a fuzz target over files, without a fuzzer: seeds in the tests of every build, findings when
// they are debugged. Where bytes must make sense to get anywhere, the tests mutate seeds; where any
// do (round_trip makes meshes from them), random ones reach more in less time.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
/// Mends what a mutation would be refused for at once. Not every target has one.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed)
    __attribute__((weak));

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t largest_mutated = 640;  // bytes; the number of mutants grows with the size

std::size_t runs = 0;

void run(const Bytes& input) {
  // A copy of the exact size, so that sanitizers see a read past its end.
  const Bytes exact(input.begin(), input.end());
  LLVMFuzzerTestOneInput(exact.data(), exact.size());
  ++runs;
}

void run_mutant(Bytes input) {
  run(input);
  if (!LLVMFuzzerCustomMutator) return;
  input.resize(LLVMFuzzerCustomMutator(input.data(), input.size(), input.size(), 0));
  run(input);
}

/// Every prefix, and every byte changed in three ways.
void run_mutants(Bytes input) {
  if (input.size() > largest_mutated) return;
  for (std::size_t size = 0; size < input.size(); ++size)
    run_mutant(Bytes(input.begin(), input.begin() + static_cast<std::ptrdiff_t>(size)));
  for (std::uint8_t& byte : input)
    for (const unsigned change : {0x01u, 0x80u, 0xffu}) {
      byte = static_cast<std::uint8_t>(byte ^ change);
      run_mutant(input);
      byte = static_cast<std::uint8_t>(byte ^ change);
    }
}

/// Any bytes, up to 303 of them, fewer more often than many; the same on every machine.
void run_random(unsigned count) {
  std::mt19937 random(1);
  for (unsigned i = 0; i < count; ++i) {
    const std::size_t most = random() % 300;
    Bytes input(3 + most * (random() % 1024) / 1024);
    for (std::uint8_t& byte : input) byte = static_cast<std::uint8_t>(random());
    run(input);
  }
}

}  // namespace

int main(int argc, char** argv) {
  bool mutate = false;
  unsigned random = 0;
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--mutate") == 0) {
      mutate = true;
    } else if (std::strcmp(argv[i], "--random") == 0 && i + 1 < argc) {
      random = static_cast<unsigned>(std::strtoul(argv[++i], nullptr, 10));
    } else if (std::filesystem::is_directory(argv[i])) {
      for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[i]))
        if (entry.is_regular_file()) files.push_back(entry.path());
    } else {
      files.emplace_back(argv[i]);
    }
  }
  if (files.empty()) {
    std::fprintf(stderr, "usage: %s [--mutate] [--random COUNT] FILE-or-DIRECTORY...\n", argv[0]);
    return 2;
  }
  std::sort(files.begin(), files.end());  // directories list in any order
  for (const auto& file : files) {
    std::ifstream stream(file, std::ios::binary);
    const std::vector<char> content{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) {
      std::fprintf(stderr, "%s: cannot be read\n", file.c_str());
      return 2;
    }
    const Bytes input(content.begin(), content.end());
    run(input);
    if (mutate) run_mutants(input);
  }
  const char* const times = std::getenv("CLERS_LONG");
  run_random(random * (times ? static_cast<unsigned>(std::strtoul(times, nullptr, 10)) : 1));
  std::printf("%zu files, %zu inputs\n", files.size(), runs);
  return 0;
}
