// compare: size and speed of clers beside Draco, meshoptimizer, OpenCTM, fpzip, zstd and xz.
#include <sys/resource.h>
#include <sys/utsname.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <span>
#include <sstream>

#include "bench/heap.h"
#include "bench/ours.h"
#include "bench/report.h"
#include "bench/result.h"
#include "bench/rivals/draco.h"
#include "bench/rivals/draco_debian.h"
#include "bench/rivals/fpzip.h"
#include "bench/rivals/general.h"
#include "bench/rivals/meshopt.h"
#include "bench/rivals/meshopt_npm.h"
#include "bench/rivals/openctm.h"
#include "bench/schedule.h"

namespace clers::bench {
namespace {

constexpr char usage[] =
    R"(usage: compare [OPTION]... [MESH or FOLDER]...

Measures size, speed, memory and fidelity of mesh codecs, one thread, taking turns.
Without a mesh: the folder $CLERS_CORPUS, else what scripts/fetch-corpus brought.

  --modes LIST      of connectivity, q11, q14, q16, lossless, file (default: all)
  --codecs LIST     names or beginnings of names: clers, draco, draco-cl7, ... (default: all)
  --filter TEXT     only meshes whose name contains TEXT
  --group NAME      only meshes of this group of the means: manifold, "not manifold", ...
  --repeats N       samples of each encode and decode (default 60)
  --min-time S      seconds a sample lasts at least; short runs are repeated (default 0.00002)
  --budget S        seconds for one codec's encodes or decodes of one mesh; slow ones get
                    fewer samples, three at least; of what takes longer once, the first run
                    is the only one (default 1)
  --minutes M       that all may take: makes the budget smaller where it must; the first runs
                    of all codecs on all meshes are never left out
  --passes N        the samples are taken in N passes over all meshes (default 3)
  --timeout S       seconds of CPU time for a codec's first run (default 120)
  --json FILE       the results
  --html FILE       the results as one page with charts
  --scaling FILE    what the program scaling wrote, for the page
  --from FILE       no measuring: make the page from an earlier --json
)";

struct Arguments {
  std::vector<Mode> modes{std::begin(all_modes), std::end(all_modes)};
  std::vector<std::string> codecs, meshes;
  std::string filter, group, json, html, scaling, from;
  Sampling sampling;
  int passes = 3;
  double minutes = 0;  // 0: any time
  unsigned timeout = 120;
};

[[noreturn]] void fail_usage(const std::string& what) {
  std::cerr << "compare: " << what << "\n" << usage;
  std::exit(2);
}

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  std::stringstream stream(list);
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

Mode mode_of(const std::string& text) {
  for (const Mode mode : all_modes)
    if (text == name(mode)) return mode;
  fail_usage("no such mode: " + text);
}

bool is_group(const std::string& group) {
  return std::any_of(std::begin(all_modes), std::end(all_modes), [&](Mode mode) {
    const std::vector<std::string> names = group_names(mode);
    return std::find(names.begin(), names.end(), group) != names.end();
  });
}

double number(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value >= 0))
    fail_usage("not a number: " + text);
  return value;
}

// The folder of $CLERS_CORPUS, else where scripts/fetch-corpus puts its meshes.
std::string default_corpus() {
  const auto variable = [](const char* what) {
    const char* value = std::getenv(what);
    return std::string(value ? value : "");
  };
  if (const std::string corpus = variable("CLERS_CORPUS"); !corpus.empty()) return corpus;
  std::string fetched = variable("CLERS_CORPUS_CACHE");
  if (fetched.empty()) fetched = variable("HOME") + "/.cache/clers/corpus";
  if (!std::filesystem::is_directory(fetched))
    fail_usage("no mesh given, CLERS_CORPUS is not set and scripts/fetch-corpus did not run");
  return fetched;
}

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    const auto value = [&]() -> std::string {
      if (i + 1 == argc) fail_usage(option + " needs a value");
      return argv[++i];
    };
    if (option == "--help" || option == "-h") {
      std::cout << usage;
      std::exit(0);
    } else if (option == "--modes") {
      a.modes.clear();
      for (const std::string& part : split(value())) a.modes.push_back(mode_of(part));
    } else if (option == "--codecs") {
      a.codecs = split(value());
    } else if (option == "--filter") {
      a.filter = value();
    } else if (option == "--group") {
      a.group = value();
      if (!is_group(a.group)) fail_usage("no such group: " + a.group);
    } else if (option == "--repeats") {
      a.sampling.repeats = std::max(1, static_cast<int>(number(value())));
    } else if (option == "--min-time") {
      a.sampling.min_sample = number(value());
    } else if (option == "--budget") {
      a.sampling.budget = number(value());
    } else if (option == "--minutes") {
      a.minutes = number(value());
    } else if (option == "--passes") {
      a.passes = std::max(1, static_cast<int>(number(value())));
    } else if (option == "--timeout") {
      a.timeout = static_cast<unsigned>(number(value()));
    } else if (option == "--json") {
      a.json = value();
    } else if (option == "--html") {
      a.html = value();
    } else if (option == "--scaling") {
      a.scaling = value();
    } else if (option == "--from") {
      a.from = value();
    } else if (option.rfind("--", 0) == 0) {
      fail_usage("no such option: " + option);
    } else {
      a.meshes.push_back(option);
    }
  }
  if (a.meshes.empty() && a.from.empty()) a.meshes.push_back(default_corpus());
  return a;
}

std::vector<CodecEntry> all_codecs() {
  std::vector<CodecEntry> all;
  for (std::vector<CodecEntry> some :
       {clers_codecs(), draco_codecs(), draco_debian_codecs(), meshopt_codecs(),
        meshopt_npm_codecs(), openctm_codecs(), fpzip_codecs(), general_codecs()})
    all.insert(all.end(), std::make_move_iterator(some.begin()),
               std::make_move_iterator(some.end()));
  return all;
}

bool wanted(const CodecEntry& entry, const std::vector<std::string>& names) {
  for (const std::string& n : names)
    if (entry.name.rfind(n, 0) == 0) return true;
  return names.empty();
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

Setting setting(const Arguments& arguments) {
  utsname system{};
  uname(&system);
  Setting s;
  s.machine = processor();
  s.system = std::string(system.sysname) + " " + system.release + " " + system.machine;
#ifdef __clang__
  s.compiler = "clang " __clang_version__;
#else
  s.compiler = "g++ " __VERSION__;
#endif
  s.flags = CLERS_BENCH_FLAGS;
  s.versions = {{"clers", CLERS_BENCH_VERSION},
                {"draco", draco_version() + " (" CLERS_BENCH_DRACO_BUILD ")"},
                {"draco-debian", draco_debian_version()},
                {"meshoptimizer", meshopt_version()},
                {"meshoptimizer-npm", meshopt_npm_version()},
                {"openctm", openctm_version()},
                {"fpzip", fpzip_version()},
                {"zstd", zstd_version()},
                {"xz", xz_version()}};
  s.passes = arguments.passes;
  s.sampling = arguments.sampling;
  return s;
}

// What the connectivity of the mesh takes Draco; 0 if it fails.
std::uint64_t draco_connectivity(const Input& input, unsigned timeout) {
  for (const CodecEntry& entry : draco_codecs())
    if (entry.name == "draco-valence")
      return try_codec(entry, input, Mode::connectivity, timeout).bytes;
  return 0;
}

// What all results of a mesh say of it.
Result about(const Input& input, unsigned timeout) {
  Result r;
  r.mesh = input.name;
  r.family = input.family;
  r.triangles = input.triangle_count();
  r.vertices = input.vertex_count;
  r.manifold = input.manifold;
  r.fanned = input.fanned;
  r.corner_values = input.has_corner_values();
  r.draco_connectivity = draco_connectivity(input, timeout);
  return r;
}

// First runs of all codecs on one mesh in one mode: bytes, heap, fidelity.
std::vector<Result> first_runs(const Input& input, Mode mode, const Result& mesh,
                               const std::vector<CodecEntry>& entries, unsigned timeout) {
  std::vector<Result> rows;
  for (const CodecEntry& entry : entries) {
    if (std::find(entry.modes.begin(), entry.modes.end(), mode) == entry.modes.end()) continue;
    Result r = mesh;
    r.codec = entry.name;
    r.mode = mode;
    r.timed = entry.timed;
    r.trial = try_codec(entry, input, mode, timeout);
    rows.push_back(std::move(r));
  }
  if (!rows.empty()) rows.push_back(least_of(rows));
  return rows;
}

// Times what did not fail and is not too slow.
void take_samples(const Input& input, const std::vector<CodecEntry>& entries,
                  const Sampling& sampling, std::span<Result> rows) {
  std::vector<std::unique_ptr<Codec>> codecs;
  std::vector<Task> encodes, decodes;
  std::vector<Result*> timed;
  for (Result& row : rows) {
    if (row.failed() || !row.timed || !is_sampled(row.trial, sampling)) continue;
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&](const CodecEntry& e) { return e.name == row.codec; });
    codecs.push_back(entry->make());
    Codec* codec = codecs.back().get();
    codec->prepare(input, row.mode);
    timed.push_back(&row);
    encodes.push_back({[codec] { codec->encode(); }, [] {}});
    decodes.push_back({[codec] { codec->decode(); }, [codec] { codec->discard(); }});
  }
  const std::vector<Samples> encode = sample_in_turns(encodes, sampling);
  const std::vector<Samples> decode = sample_in_turns(decodes, sampling);
  for (std::size_t i = 0; i < timed.size(); ++i) {
    Result& r = *timed[i];
    r.encode_samples.insert(r.encode_samples.end(), encode[i].begin(), encode[i].end());
    r.decode_samples.insert(r.decode_samples.end(), decode[i].begin(), decode[i].end());
  }
}

// What was not sampled has its first run.
void sum_up(Result& r) {
  if (r.encode_samples.empty()) r.encode_samples = {r.trial.encode_seconds};
  if (r.decode_samples.empty()) r.decode_samples = {r.trial.decode_seconds};
  r.encode = summary(r.encode_samples);
  r.decode = summary(r.decode_samples);
}

std::string read_text(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error(file + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const std::string& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw std::runtime_error(file + ": cannot be written");
}

// A mesh file and its results, mode by mode.
struct Work {
  std::filesystem::path file;
  std::vector<std::vector<Result>> modes;
  bool left_out = false;
};

// The first runs of all codecs on a file, in each mode.
void try_all(Work& work, const std::vector<CodecEntry>& entries, const Arguments& arguments) {
  const Input input = read_input(work.file);
  Result mesh = about(input, arguments.timeout);
  for (const Mode mode : arguments.modes) {
    mesh.mode = mode;
    if (arguments.group.empty() || in_group(mesh, arguments.group))
      work.modes.push_back(first_runs(input, mode, mesh, entries, arguments.timeout));
  }
}

// One pass over a file. Prints its rows when there are no more samples to come.
void sample_all(Work& work, bool last, const std::vector<CodecEntry>& entries,
                const Sampling& sampling, const Setting& setting) {
  const Input input = read_input(work.file);
  for (std::vector<Result>& rows : work.modes) {
    take_samples(input, entries, sampling, rows);
    if (!last) continue;
    for (Result& r : rows)
      if (!r.failed() && r.timed) sum_up(r);
    print_rows(std::cout, setting, rows);
  }
}

std::vector<const Trial*> timed_trials(const std::vector<Work>& works) {
  std::vector<const Trial*> trials;
  for (const Work& work : works)
    for (const std::vector<Result>& rows : work.modes)
      for (const Result& r : rows)
        if (!r.failed() && r.timed) trials.push_back(&r.trial);
  return trials;
}

// Runs `work` on each file that was not left out; what it cannot do is left out from then on.
void for_each_file(std::vector<Work>& works, const std::string& what,
                   const std::function<void(Work&)>& work) {
  std::size_t count = 0;
  for (Work& w : works) {
    ++count;
    if (w.left_out) continue;
    std::cerr << "[" << what << ", mesh " << count << "/" << works.size() << "] "
              << w.file.filename().string() << "\n";
    try {
      work(w);
    } catch (const std::exception& e) {
      std::cerr << "compare: " << w.file.string() << " left out: " << e.what() << "\n";
      w = {w.file, {}, true};
    }
  }
}

// How long it has been, and what share of it was ours: others may use the processor too.
class Watch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  double share() const {
    double used = 0;
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
      rusage spent{};
      getrusage(who, &spent);
      used += double(spent.ru_utime.tv_sec + spent.ru_stime.tv_sec) +
              1e-6 * double(spent.ru_utime.tv_usec + spent.ru_stime.tv_usec);
    }
    return std::min(1.0, used / seconds());
  }

 private:
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
};

// The samples of one pass.
Sampling of_one_pass(const Sampling& all, int passes) {
  Sampling one = all;
  one.repeats = (all.repeats + passes - 1) / passes;
  one.least = (all.least + passes - 1) / passes;
  one.budget /= passes;
  return one;
}

std::vector<Result> measure_all(const Setting& setting, const Arguments& arguments) {
  const Watch watch;
  keep_heap_warm();
  std::vector<CodecEntry> entries;
  for (CodecEntry& entry : all_codecs())
    if (wanted(entry, arguments.codecs)) entries.push_back(std::move(entry));
  if (entries.empty()) fail_usage("no such codec");

  std::vector<Work> works;
  for (const auto& file : list_files(arguments.meshes))
    if (file.string().find(arguments.filter) != std::string::npos) works.push_back({file, {}});
  for_each_file(works, "first runs", [&](Work& work) { try_all(work, entries, arguments); });
  for (int pass = 1; pass <= setting.passes; ++pass) {
    Sampling sampling = of_one_pass(setting.sampling, setting.passes);
    if (arguments.minutes > 0) {
      const double left = 60 * arguments.minutes - watch.seconds();
      sampling =
          fitted(sampling, timed_trials(works), watch.share() * left / (setting.passes - pass + 1));
    }
    for_each_file(
        works, "pass " + std::to_string(pass) + "/" + std::to_string(setting.passes),
        [&](Work& work) { sample_all(work, pass == setting.passes, entries, sampling, setting); });
  }
  std::vector<Result> results;
  for (Work& work : works)
    for (std::vector<Result>& rows : work.modes)
      std::move(rows.begin(), rows.end(), std::back_inserter(results));
  if (results.empty()) throw std::runtime_error("no mesh was measured");
  return results;
}

int run(int argc, char** argv) {
  const Arguments arguments = parse(argc, argv);
  std::string json;
  if (!arguments.from.empty()) {
    json = read_text(arguments.from);
  } else {
    const Setting s = setting(arguments);
    std::cout << s.machine << ", " << s.system << ", " << s.compiler << ", " << s.flags << "\n";
    for (const auto& [what, version] : s.versions) std::cout << what << " " << version << "\n";
    const std::vector<Result> results = measure_all(s, arguments);
    print_means(std::cout, s, results);
    std::ostringstream text;
    write_json(text, s, results);
    json = text.str();
  }
  if (!arguments.json.empty()) write_text(arguments.json, json);
  if (!arguments.html.empty())
    write_text(arguments.html,
               report_page(json, arguments.scaling.empty() ? "" : read_text(arguments.scaling)));
  return 0;
}

}  // namespace
}  // namespace clers::bench

int main(int argc, char** argv) {
  try {
    return clers::bench::run(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << "compare: " << e.what() << "\n";
    return 1;
  }
}
