// scaling: cost per triangle from a thousand to ten million triangles, of clean meshes and of
// others.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>

#include "bench/heap.h"
#include "bench/ours.h"
#include "bench/rivals/draco.h"
#include "bench/timing.h"
#include "bench/trial.h"
#include "codec/compare.h"
#include "codec/decode.h"
#include "codec/encode.h"
#include "corpus/generate.h"

namespace clers::bench {
namespace {

constexpr char usage[] =
    R"(usage: scaling [OPTION]...

Connectivity of growing meshes: nanoseconds and bytes of heap a triangle, to encode, to decode, and to
verify that what comes back is the same, without positions. With them the exponent of time over
triangles, fitted from 10 000 triangles up (1: linear), and the most that a doubling of the size costs
(2: linear), between sizes that follow each other from 100 000 up.

  --min N        triangles of the smallest meshes (default 1000)
  --max N        triangles of the largest meshes (default 10000000)
  --step X       from one size to the next (default 3.16)
  --codecs LIST  beginnings of names (default clers-1,clers-5,draco-standard,draco-valence)
  --shape TEXT   only those whose name contains TEXT
  --defects      only meshes that are not clean
  --repeats N    samples (default 9; at least three even where one takes long)
  --timeout S    seconds of CPU time for a codec's first run (default 120)
  --json FILE    the points and the fits
)";

using Make = Mesh (*)(double triangles);

std::uint32_t count(double x) {
  return static_cast<std::uint32_t>(std::max(3.0, std::round(x)));
}

Mesh torus(double triangles) {
  const std::uint32_t side = count(std::sqrt(triangles / 2));
  return corpus::torus(side, side);
}

// The icosphere nearest in size: they grow by four.
Mesh icosphere(double triangles) {
  return corpus::icosphere(static_cast<unsigned>(
      std::max(0.0, std::floor(std::log(triangles / 20) / std::log(4.0) + 0.05))));
}

Mesh flipped_grid(double triangles) {
  const std::uint32_t side = count(std::sqrt(triangles / 2));
  return corpus::flip_edges(corpus::grid(side, side), 8ull * side * side, 1);
}

// Handles grow with the triangles: four for each cell of 7 392.
Mesh gyroid(double triangles) {
  const std::uint32_t cells = static_cast<std::uint32_t>(std::round(std::cbrt(triangles / 7392)));
  return corpus::gyroid(std::max(1u, cells), std::max(1u, cells), std::max(1u, cells), 16,
                        corpus::Ends::periodic);
}

// A handle for every twelve triangles.
Mesh lattice(double triangles) {
  return corpus::lattice(static_cast<std::uint32_t>(std::max(1.0, std::cbrt(triangles / 24))));
}

Mesh doubled_torus(double triangles) {
  return corpus::doubled(torus(triangles / 2));
}
Mesh two_sided_torus(double triangles) {
  return corpus::two_sided(torus(triangles / 2));
}
Mesh same_triangle(double triangles) {
  return corpus::same_triangle(count(triangles));
}
Mesh all_triples(double triangles) {
  return corpus::all_triples(count(std::cbrt(6 * triangles) + 1));
}
Mesh fan(double triangles) {
  return corpus::fan(count(triangles));
}
Mesh pinched_hub(double triangles) {
  return corpus::pinched_hub(count(triangles));
}
Mesh isolated(double triangles) {  // nine vertices of ten
  const Mesh clean = torus(triangles);
  return corpus::isolate(clean, 9 * clean.vertex_count);
}
Mesh one_reversed(double triangles) {
  return corpus::reverse_some(torus(triangles), 1, 1);
}
Mesh few_fins(double triangles) {
  return corpus::add_fins(torus(triangles), 5, 1);
}
Mesh many_fins(double triangles) {
  return corpus::add_fins(torus(triangles * 0.9), count(triangles * 0.1), 1);
}
Mesh moebius_bands(double triangles) {
  return corpus::copies(corpus::moebius_strip(20, 2), count(triangles / 80));
}
Mesh moebius_band(double triangles) {
  return corpus::moebius_strip(count(triangles / 20), 10);
}
Mesh book(double triangles) {
  return corpus::book(count(triangles));
}
Mesh books(double triangles) {
  return corpus::copies(corpus::book(20), count(triangles / 20));
}
Mesh chessboard(double triangles) {
  return corpus::chessboard(count(std::sqrt(triangles)));
}
Mesh soup(double triangles) {
  return corpus::random_soup(count(triangles / 4), count(triangles), 3, 1);
}
Mesh tetrahedra(double triangles) {
  return corpus::copies(corpus::tetrahedron(), count(triangles / 4));
}

// A mesh of 18 triangles with an attribute for every twenty of the triangles that are asked for.
Mesh many_attributes(double triangles) {
  Mesh mesh = corpus::torus(3, 3);
  const std::uint32_t attributes = count(triangles / 20);
  const Attribute position = std::move(mesh.attributes[0]);
  mesh.attributes.clear();
  for (std::uint32_t k = 0; k < attributes; ++k)
    mesh.attributes.push_back({"a" + std::to_string(k), Domain::vertex, Scalar::uint8, 1,
                               std::vector<std::byte>(mesh.vertex_count, std::byte(k % 7))});
  mesh.attributes.push_back(position);  // last, where a search for it takes longest
  return mesh;
}

enum class Kind { clean, defects, attributes };

struct Shape {
  const char* name;
  Make make;
  bool shuffled;
  Kind kind = Kind::defects;
};

constexpr Shape shapes[] = {
    {"torus", torus, false, Kind::clean},
    {"icosphere", icosphere, false, Kind::clean},
    {"flipped grid", flipped_grid, false, Kind::clean},
    {"gyroid", gyroid, false, Kind::clean},
    {"lattice", lattice, false, Kind::clean},
    {"torus, shuffled", torus, true, Kind::clean},
    {"icosphere, shuffled", icosphere, true, Kind::clean},
    {"flipped grid, shuffled", flipped_grid, true, Kind::clean},
    {"gyroid, shuffled", gyroid, true, Kind::clean},
    {"tetrahedra", tetrahedra, false},
    {"fan", fan, false},
    {"isolated vertices", isolated, false},
    {"one reversed face", one_reversed, false},
    {"five fins", few_fins, false},
    {"a tenth fins", many_fins, false},
    {"doubled torus", doubled_torus, false},
    {"two-sided torus", two_sided_torus, false},
    {"same triangle", same_triangle, false},
    {"all triples", all_triples, false},
    {"pinched hub", pinched_hub, false},
    {"chessboard", chessboard, false},
    {"book", book, false},
    {"books", books, false},
    {"moebius band", moebius_band, false},
    {"moebius bands", moebius_bands, false},
    {"soup", soup, false},
    {"many attributes", many_attributes, false, Kind::attributes},
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A cost by the triangle that is measured; not a number where it was not, or the codec failed.
struct Cost {
  const char* name;  ///< in JSON, with "_ns" or "_bytes"
  const char* unit;
};
constexpr Cost costs[] = {{"encode", "ns"},         {"decode", "ns"},
                          {"verify", "ns"},         {"encode_peak", "bytes"},
                          {"decode_peak", "bytes"}, {"verify_peak", "bytes"}};
constexpr std::size_t cost_count = std::size(costs);
enum { encode_ns, decode_ns, verify_ns, encode_peak, decode_peak, verify_peak };

struct Point {
  std::string shape, codec;
  std::size_t triangles;
  double bits_per_triangle = nan;
  std::array<double, cost_count> cost = {nan, nan, nan, nan, nan, nan};
};

struct Fit {
  std::string shape, codec;
  std::size_t largest = 0;
  std::array<double, cost_count> exponent = {}, doubling = {};
};

struct Arguments {
  double min = 1e3, max = 1e7, step = std::sqrt(10.0);
  std::vector<std::string> codecs = {"clers-1", "clers-5", "draco-standard", "draco-valence"};
  std::string shape, json;
  bool defects = false;
  unsigned timeout = 120;
  Sampling sampling{9, 2e-5, 2};
};

// Slope of log time over log triangles by least squares; time is the cost times the triangles. Not
// a number if there are fewer than two sizes to fit.
double exponent(const std::vector<Point>& points, std::size_t cost) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const Point& p : points) {
    if (p.triangles < 10000 || std::isnan(p.cost[cost])) continue;
    const double x = std::log(double(p.triangles)), y = x + std::log(p.cost[cost]);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double spread = n * sxx - sx * sx;
  return n > 1 && spread > 0 ? (n * sxy - sx * sy) / spread : nan;
}

// The most that time grows when the triangles double.
double doubling(const std::vector<Point>& points, std::size_t cost) {
  double most = nan;
  const Point* last = nullptr;
  for (const Point& p : points) {
    if (p.triangles < 99000 || std::isnan(p.cost[cost])) continue;
    if (last) {
      const double size = double(p.triangles) / double(last->triangles);
      const double growth = size * p.cost[cost] / last->cost[cost];
      most = std::fmax(most, std::pow(growth, std::log(2.0) / std::log(size)));
    }
    last = &p;
  }
  return most;
}

std::vector<CodecEntry> chosen_codecs(const std::vector<std::string>& names, Mode mode) {
  std::vector<CodecEntry> entries;
  for (const std::vector<CodecEntry>& some : {clers_codecs(), draco_codecs()})
    for (const CodecEntry& entry : some)
      if (std::find(entry.modes.begin(), entry.modes.end(), mode) != entry.modes.end() &&
          std::any_of(names.begin(), names.end(),
                      [&](const std::string& n) { return entry.name.rfind(n, 0) == 0; }))
        entries.push_back(entry);
  return entries;
}

Input make(const Shape& shape, double triangles) {
  Mesh mesh = shape.make(triangles);
  if (shape.shuffled) mesh = corpus::shuffle(mesh, 1);
  std::vector<float> positions(3 * std::size_t(mesh.vertex_count));
  std::memcpy(positions.data(), mesh.position()->data.data(), positions.size() * sizeof(float));
  std::vector<Attribute> attributes = std::move(mesh.attributes);
  Input input =
      make_input(shape.name, mesh.vertex_count, std::move(mesh.corners), std::move(positions));
  if (shape.kind == Kind::attributes) input.mesh.attributes = std::move(attributes);
  return input;
}

// What a cost is divided by: triangles, or what stands for them.
std::size_t size_of(const Shape& shape, const Input& input) {
  return shape.kind == Kind::attributes ? 20 * (input.mesh.attributes.size() - 1)
                                        : input.triangle_count();
}

// The shape in its sizes, smallest first.
std::vector<Input> make_all(const Shape& shape, const Arguments& a) {
  std::vector<Input> inputs;
  for (double n = a.min; n <= a.max * 1.001; n *= a.step) {
    Input input = make(shape, n);
    if (inputs.empty() || size_of(shape, input) > size_of(shape, inputs.back()))
      inputs.push_back(std::move(input));
  }
  return inputs;
}

// Time and heap to find that what comes back is the same, without positions.
void verify(const Input& input, const Shape& shape, const Sampling& sampling, Point& point) {
  Mesh mesh = input.mesh;
  if (shape.kind != Kind::attributes) mesh.attributes.clear();
  const auto encoded = encode({&mesh, 1});
  if (!encoded) return;
  const auto decoded = decode(encoded->bytes);
  if (!decoded) return;
  Samples samples;
  std::uint64_t peak = 0;
  for (double spent = 0; samples.empty() || (spent < sampling.budget &&
                                             samples.size() < std::size_t(sampling.repeats));) {
    const double start = thread_seconds();
    if (samples.empty()) start_counting_heap();
    const auto found = compare(mesh, (*decoded)[0]);
    if (samples.empty()) peak = stop_counting_heap();
    if (!found || found->verdict != Verdict::same) return;
    samples.push_back(thread_seconds() - start);
    spent += samples.back();
  }
  const double n = double(size_of(shape, input));
  point.cost[verify_ns] = 1e9 * summary(samples).quiet / n;
  point.cost[verify_peak] = double(peak) / n;
}

// All sizes and codecs take turns, so that what else the machine does bends no curve.
std::vector<Point> measure(const Shape& shape, const std::vector<Input>& inputs,
                           const std::vector<CodecEntry>& entries, const Arguments& a) {
  const Mode mode = shape.kind == Kind::attributes ? Mode::lossless : Mode::connectivity;
  std::vector<Point> points(inputs.size() * entries.size());  // mesh by mesh, as tables have them
  std::vector<std::unique_ptr<Codec>> codecs;
  std::vector<Task> encodes, decodes;
  std::vector<Point*> timed;
  // Codec by codec: the smallest mesh of each follows a large one, and finds the caches as cold.
  for (std::size_t e = 0; e < entries.size(); ++e) {
    for (std::size_t m = 0; m < inputs.size(); ++m) {
      Point& p = points[m * entries.size() + e];
      p.shape = shape.name;
      p.codec = entries[e].name;
      p.triangles = size_of(shape, inputs[m]);
      const double n = double(p.triangles);
      const Trial trial = try_codec(entries[e], inputs[m], mode, a.timeout);
      if (!trial.failure.empty()) {
        std::fprintf(stderr, "scaling: %s, %zu triangles: %s %s\n", shape.name, p.triangles,
                     p.codec.c_str(), trial.failure.c_str());
        continue;
      }
      p.bits_per_triangle = 8.0 * double(trial.bytes) / n;
      p.cost[encode_peak] = double(trial.encode_peak) / n;
      p.cost[decode_peak] = double(trial.decode_peak) / n;
      codecs.push_back(entries[e].make());
      Codec* codec = codecs.back().get();
      codec->prepare(inputs[m], mode);
      timed.push_back(&p);
      encodes.push_back({[codec] { codec->encode(); }, [] {}});
      decodes.push_back({[codec] { codec->decode(); }, [codec] { codec->discard(); }});
    }
  }
  const auto encode = sample_in_turns(encodes, a.sampling),
             decode = sample_in_turns(decodes, a.sampling);
  for (std::size_t i = 0; i < timed.size(); ++i) {
    const double n = double(timed[i]->triangles);
    timed[i]->cost[encode_ns] = 1e9 * summary(encode[i]).quiet / n;
    timed[i]->cost[decode_ns] = 1e9 * summary(decode[i]).quiet / n;
  }
  return points;
}

// Verifying is the library's, and no level's: a row of its own.
std::vector<Point> measure_verify(const Shape& shape, const std::vector<Input>& inputs,
                                  const Arguments& a) {
  std::vector<Point> points;
  for (const Input& input : inputs) {
    points.push_back({shape.name, "verify", size_of(shape, input)});
    verify(input, shape, a.sampling, points.back());
    if (std::isnan(points.back().cost[verify_ns]))
      std::fprintf(stderr, "scaling: %s, %zu triangles: verify is undecided\n", shape.name,
                   points.back().triangles);
  }
  return points;
}

Fit fit(const std::vector<Point>& line) {
  Fit f{line.front().shape, line.front().codec, line.back().triangles};
  for (std::size_t c = 0; c < cost_count; ++c) {
    f.exponent[c] = exponent(line, c);
    f.doubling[c] = doubling(line, c);
  }
  return f;
}

std::string cell(int width, int digits, double value) {
  char text[32];
  if (std::isnan(value)) {
    std::snprintf(text, sizeof text, "%*s", width, "-");
  } else {
    std::snprintf(text, sizeof text, "%*.*f", width, digits, value);
  }
  return text;
}

// The table of one shape.
void print(const std::vector<Point>& points, const std::vector<Point>& verified,
           const std::vector<Fit>& fits, std::size_t entries) {
  std::printf(
      "\n%s, a triangle: encode ns, decode ns (bits) peak bytes of heap; verify ns, peak\n%10s",
      verified.front().shape.c_str(), "triangles");
  for (const Fit& f : fits) std::printf(f.codec == "verify" ? " %15s" : " %31s", f.codec.c_str());
  for (std::size_t m = 0; m < verified.size(); ++m) {
    std::printf("\n%10zu", verified[m].triangles);
    for (std::size_t e = 0; e < entries; ++e) {
      const Point& p = points[m * entries + e];
      std::printf(" %s %s (%s) %s", cell(8, 1, p.cost[encode_ns]).c_str(),
                  cell(7, 1, p.cost[decode_ns]).c_str(), cell(5, 3, p.bits_per_triangle).c_str(),
                  cell(6, 0, std::fmax(p.cost[encode_peak], p.cost[decode_peak])).c_str());
    }
    std::printf(" %s %s", cell(8, 1, verified[m].cost[verify_ns]).c_str(),
                cell(6, 0, verified[m].cost[verify_peak]).c_str());
  }
  for (const bool doubling : {false, true}) {
    std::printf("\n%10s", doubling ? "doubling" : "exponent");
    for (const Fit& f : fits) {
      const auto& of = doubling ? f.doubling : f.exponent;
      if (f.codec == "verify") {
        std::printf(" %s %s", cell(8, 3, of[verify_ns]).c_str(),
                    cell(6, 2, of[verify_peak]).c_str());
      } else {
        std::printf(" %s %s %7s %s", cell(8, 3, of[encode_ns]).c_str(),
                    cell(7, 3, of[decode_ns]).c_str(), "",
                    cell(6, 2, std::fmax(of[encode_peak], of[decode_peak])).c_str());
      }
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}

// JSON has no word for what is not a number.
struct JsonNumber {
  double value;
};

std::ostream& operator<<(std::ostream& out, JsonNumber n) {
  if (std::isnan(n.value)) return out << "null";
  return out << n.value;
}

void write_json(std::ostream& out, const std::vector<Point>& points, const std::vector<Fit>& fits) {
  out << "{\"points\": [";
  const char* separator = "\n";
  for (const Point& p : points) {
    out << separator << "{\"shape\": \"" << p.shape << "\", \"codec\": \"" << p.codec
        << "\", \"triangles\": " << p.triangles;
    for (std::size_t c = 0; c < cost_count; ++c)
      out << ", \"" << costs[c].name << "_" << costs[c].unit << "\": " << JsonNumber{p.cost[c]};
    out << ", \"bits_per_triangle\": " << JsonNumber{p.bits_per_triangle} << "}";
    separator = ",\n";
  }
  out << "],\n\"fits\": [";
  separator = "\n";
  for (const Fit& f : fits) {
    out << separator << "{\"shape\": \"" << f.shape << "\", \"codec\": \"" << f.codec
        << "\", \"largest\": " << f.largest;
    for (std::size_t c = 0; c < cost_count; ++c)
      out << ", \"" << costs[c].name << "_exponent\": " << JsonNumber{f.exponent[c]} << ", \""
          << costs[c].name << "_doubling\": " << JsonNumber{f.doubling[c]};
    out << "}";
    separator = ",\n";
  }
  out << "]}\n";
}

Arguments parse(int argc, char** argv) {
  Arguments a;
  const auto fail = [](const std::string& what) {
    std::cerr << "scaling: " << what << "\n" << usage;
    std::exit(2);
  };
  for (int i = 1; i < argc; ++i) {
    const std::string option = argv[i];
    if (option == "--help" || option == "-h") {
      std::cout << usage;
      std::exit(0);
    }
    if (option == "--defects") {
      a.defects = true;
      continue;
    }
    if (i + 1 == argc) fail("what is " + option + "?");
    const std::string value = argv[++i];
    if (option == "--min") {
      a.min = std::max(1.0, std::atof(value.c_str()));
    } else if (option == "--max") {
      a.max = std::atof(value.c_str());
    } else if (option == "--step") {
      a.step = std::atof(value.c_str());
      if (!(a.step > 1)) fail("not a step: " + value);
    } else if (option == "--timeout") {
      a.timeout = static_cast<unsigned>(std::max(1, std::atoi(value.c_str())));
    } else if (option == "--codecs") {
      a.codecs.clear();
      for (std::size_t at = 0; at <= value.size(); at = value.find(',', at) + 1) {
        a.codecs.push_back(value.substr(at, value.find(',', at) - at));
        if (value.find(',', at) == std::string::npos) break;
      }
    } else if (option == "--shape") {
      a.shape = value;
    } else if (option == "--repeats") {
      a.sampling.repeats = std::max(1, std::atoi(value.c_str()));
    } else if (option == "--json") {
      a.json = value;
    } else {
      fail("no such option: " + option);
    }
  }
  return a;
}

int run(int argc, char** argv) {
  const Arguments a = parse(argc, argv);
  keep_heap_warm();
  std::vector<Point> points;
  std::vector<Fit> fits;
  for (const Shape& shape : shapes) {
    if (std::string(shape.name).find(a.shape) == std::string::npos ||
        (a.defects && shape.kind == Kind::clean))
      continue;
    const std::vector<Input> inputs = make_all(shape, a);
    if (inputs.empty()) continue;
    std::vector<CodecEntry> entries;
    if (shape.kind != Kind::attributes) {
      entries = chosen_codecs(a.codecs, Mode::connectivity);
    } else {  // rivals take positions alone
      for (CodecEntry& entry : chosen_codecs(a.codecs, Mode::lossless))
        if (entry.name.rfind("clers", 0) == 0) entries.push_back(std::move(entry));
    }
    const std::vector<Point> rows = measure(shape, inputs, entries, a);
    const std::vector<Point> verified = measure_verify(shape, inputs, a);
    std::vector<Fit> own;
    for (std::size_t e = 0; e < entries.size(); ++e) {
      std::vector<Point> line;
      for (std::size_t i = e; i < rows.size(); i += entries.size()) line.push_back(rows[i]);
      own.push_back(fit(line));
    }
    own.push_back(fit(verified));
    print(rows, verified, own, entries.size());
    points.insert(points.end(), rows.begin(), rows.end());
    points.insert(points.end(), verified.begin(), verified.end());
    fits.insert(fits.end(), own.begin(), own.end());
  }
  if (!a.json.empty()) {
    std::ofstream out(a.json);
    write_json(out, points, fits);
    if (!out.flush()) throw std::runtime_error(a.json + ": cannot be written");
  }
  return 0;
}

}  // namespace
}  // namespace clers::bench

int main(int argc, char** argv) {
  try {
    return clers::bench::run(argc, argv);
  } catch (const std::exception& e) {
    std::cerr << "scaling: " << e.what() << "\n";
    return 1;
  }
}
