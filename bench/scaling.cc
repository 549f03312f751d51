// scaling: cost per triangle from a thousand to ten million triangles.
#include <algorithm>
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
#include "corpus/generate.h"

namespace clers::bench {
namespace {

constexpr char usage[] =
    R"(usage: scaling [OPTION]...

Connectivity of growing meshes: nanoseconds a triangle, and the exponent of time over triangles,
fitted from 10 000 triangles up (1: linear).

  --max N        triangles of the largest meshes (default 10000000)
  --codecs LIST  beginnings of names (default clers-1,clers-5,draco-standard,draco-valence)
  --shape NAME   only this one
  --repeats N    samples (default 9; at least three even where one takes long)
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

struct Shape {
  const char* name;
  Make make;
  bool shuffled;
};

constexpr Shape shapes[] = {
    {"torus", torus, false},
    {"icosphere", icosphere, false},
    {"flipped grid", flipped_grid, false},
    {"gyroid", gyroid, false},
    {"lattice", lattice, false},
    {"torus, shuffled", torus, true},
    {"icosphere, shuffled", icosphere, true},
    {"flipped grid, shuffled", flipped_grid, true},
    {"gyroid, shuffled", gyroid, true},
};

struct Point {
  std::string shape, codec;
  std::size_t triangles;
  double encode_ns, decode_ns, bits_per_triangle;
};

struct Fit {
  std::string shape, codec;
  std::size_t largest = 0;
  double encode = 0, decode = 0;
};

struct Arguments {
  double max = 1e7;
  std::vector<std::string> codecs = {"clers-1", "clers-5", "draco-standard", "draco-valence"};
  std::string shape, json;
  Sampling sampling{9, 2e-5, 2};
};

// Slope of log time over log triangles by least squares; time is the cost times the triangles. Not
// a number if there are fewer than two sizes to fit.
double exponent(const std::vector<Point>& points, double Point::*cost) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (const Point& p : points) {
    if (p.triangles < 10000) continue;
    const double x = std::log(double(p.triangles)), y = x + std::log(p.*cost);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  const double spread = n * sxx - sx * sx;
  return n > 1 && spread > 0 ? (n * sxy - sx * sy) / spread
                             : std::numeric_limits<double>::quiet_NaN();
}

std::vector<CodecEntry> chosen_codecs(const std::vector<std::string>& names) {
  std::vector<CodecEntry> entries;
  for (const std::vector<CodecEntry>& some : {clers_codecs(), draco_codecs()})
    for (const CodecEntry& entry : some)
      if (std::find(entry.modes.begin(), entry.modes.end(), Mode::connectivity) !=
              entry.modes.end() &&
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
  return make_input(shape.name, mesh.vertex_count, std::move(mesh.corners), std::move(positions));
}

// The shape in its sizes, smallest first.
std::vector<Input> make_all(const Shape& shape, double max) {
  std::vector<Input> inputs;
  for (double n = 1000; n <= max * 1.001; n *= std::sqrt(10.0)) {
    Input input = make(shape, n);
    if (inputs.empty() || input.triangle_count() > inputs.back().triangle_count())
      inputs.push_back(std::move(input));
  }
  return inputs;
}

// All sizes and codecs take turns, so that what else the machine does bends no curve.
std::vector<Point> measure(const std::vector<Input>& inputs, const std::vector<CodecEntry>& entries,
                           const Sampling& sampling) {
  std::vector<std::unique_ptr<Codec>> codecs;
  std::vector<Task> encodes, decodes;
  // Codec by codec: the smallest mesh of each follows a large one, and finds the caches as cold.
  for (const CodecEntry& entry : entries) {
    for (const Input& input : inputs) {
      codecs.push_back(entry.make());
      Codec* codec = codecs.back().get();
      codec->prepare(input, Mode::connectivity);
      encodes.push_back({[codec] { codec->encode(); }, [] {}});
      decodes.push_back({[codec] { codec->decode(); }, [codec] { codec->discard(); }});
    }
  }
  const auto encode = sample_in_turns(encodes, sampling),
             decode = sample_in_turns(decodes, sampling);
  std::vector<Point> points;  // mesh by mesh, as tables have them
  for (std::size_t m = 0; m < inputs.size(); ++m) {
    const double n = double(inputs[m].triangle_count());
    for (std::size_t e = 0; e < entries.size(); ++e) {
      const std::size_t i = e * inputs.size() + m;
      points.push_back({inputs[m].name, entries[e].name, inputs[m].triangle_count(),
                        1e9 * summary(encode[i]).quiet / n, 1e9 * summary(decode[i]).quiet / n,
                        8.0 * double(codecs[i]->bytes()) / n});
    }
  }
  return points;
}

// The table of one shape, and its fits.
std::vector<Fit> print(const std::vector<Point>& points, const std::vector<CodecEntry>& entries) {
  std::printf("\n%s, nanoseconds a triangle: encode decode (bits a triangle)\n%10s",
              points.front().shape.c_str(), "triangles");
  for (const CodecEntry& e : entries) std::printf(" %24s", e.name.c_str());
  std::vector<std::vector<Point>> lines(entries.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point& p = points[i];
    if (i % entries.size() == 0) std::printf("\n%10zu", p.triangles);
    std::printf(" %8.1f %7.1f (%5.3f)", p.encode_ns, p.decode_ns, p.bits_per_triangle);
    lines[i % entries.size()].push_back(p);
  }
  std::printf("\n%10s", "exponent");
  std::vector<Fit> fits;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    fits.push_back({points.front().shape, entries[i].name, points.back().triangles,
                    exponent(lines[i], &Point::encode_ns), exponent(lines[i], &Point::decode_ns)});
    for (const auto& [width, slope] : {std::pair(8, fits.back().encode), {7, fits.back().decode}}) {
      if (std::isnan(slope)) {
        std::printf(" %*s", width, "-");
      } else {
        std::printf(" %*.3f", width, slope);
      }
    }
    std::printf("        ");
  }
  std::printf("\n");
  std::fflush(stdout);
  return fits;
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
        << "\", \"triangles\": " << p.triangles << ", \"encode_ns\": " << p.encode_ns
        << ", \"decode_ns\": " << p.decode_ns << ", \"bits_per_triangle\": " << p.bits_per_triangle
        << "}";
    separator = ",\n";
  }
  out << "],\n\"fits\": [";
  separator = "\n";
  for (const Fit& f : fits) {
    out << separator << "{\"shape\": \"" << f.shape << "\", \"codec\": \"" << f.codec
        << "\", \"largest\": " << f.largest << ", \"encode_exponent\": " << JsonNumber{f.encode}
        << ", \"decode_exponent\": " << JsonNumber{f.decode} << "}";
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
    if (i + 1 == argc) fail("what is " + option + "?");
    const std::string value = argv[++i];
    if (option == "--max") {
      a.max = std::atof(value.c_str());
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
  const std::vector<CodecEntry> entries = chosen_codecs(a.codecs);
  keep_heap_warm();
  std::vector<Point> points;
  std::vector<Fit> fits;
  for (const Shape& shape : shapes) {
    if (!a.shape.empty() && a.shape != shape.name) continue;
    const std::vector<Input> inputs = make_all(shape, a.max);
    if (inputs.empty()) continue;
    const std::vector<Point> row = measure(inputs, entries, a.sampling);
    const std::vector<Fit> fit = print(row, entries);
    points.insert(points.end(), row.begin(), row.end());
    fits.insert(fits.end(), fit.begin(), fit.end());
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
