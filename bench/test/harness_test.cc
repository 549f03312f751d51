// A benchmark is believed only if its judge finds what is wrong: lost and added triangles, copied
// vertices, moved positions, codecs that crash, hang or lie; and if its clock and its heap count.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <thread>

#include "bench/fidelity.h"
#include "bench/heap.h"
#include "bench/input.h"
#include "bench/result.h"
#include "bench/schedule.h"
#include "bench/timing.h"
#include "bench/trial.h"

namespace clers::bench {
namespace {

volatile int busy;  // work that no compiler leaves out

// A square of two triangles and a vertex that no triangle uses.
Input square() {
  return make_input("test-square", 5, {0, 1, 2, 2, 1, 3},
                    {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 5, 5, 5});
}

Output same(const Input& input) {
  Output out{input.triangles, std::vector<std::uint32_t>(input.vertex_count), input.positions};
  std::iota(out.origin.begin(), out.origin.end(), 0u);
  return out;
}

TEST(Fidelity, RenumberingAndTurningAreNoLoss) {
  const Input input = square();
  Output out = same(input);
  EXPECT_TRUE(check(input, out, Mode::lossless).same());
  // Vertices backwards, triangles swapped and turned.
  out.origin = {4, 3, 2, 1, 0};
  out.triangles = {3, 1, 2, 2, 4, 3};
  for (std::size_t v = 0; v < 5; ++v)
    for (std::size_t k = 0; k < 3; ++k) out.positions[3 * v + k] = input.positions[3 * (4 - v) + k];
  EXPECT_TRUE(check(input, out, Mode::lossless).same());
}

TEST(Fidelity, CountsTrianglesLostAndAdded) {
  const Input input = square();
  Output lost = same(input);
  lost.triangles.resize(3);
  EXPECT_EQ(check(input, lost, Mode::connectivity).triangles_lost, 1u);
  EXPECT_FALSE(check(input, lost, Mode::connectivity).same());

  Output twice = same(input);
  twice.triangles.insert(twice.triangles.end(), {0, 1, 2});
  EXPECT_EQ(check(input, twice, Mode::connectivity).triangles_added, 1u);

  Output flipped = same(input);
  std::swap(flipped.triangles[0], flipped.triangles[1]);
  EXPECT_EQ(check(input, flipped, Mode::connectivity).triangles_lost, 1u);
  EXPECT_EQ(check(input, flipped, Mode::connectivity).triangles_added, 1u);
}

TEST(Fidelity, CountsVerticesLostAndDuplicated) {
  const Input input = square();
  Output lost = same(input);
  lost.origin.pop_back();
  EXPECT_EQ(check(input, lost, Mode::connectivity).vertices_lost, 1u);

  // Vertex 1 in two copies, one for each triangle: what Draco does where a mesh is not manifold.
  Output copied = same(input);
  copied.origin.push_back(1);
  copied.triangles[4] = 5;
  const Fidelity f = check(input, copied, Mode::connectivity);
  EXPECT_EQ(f.vertices_added, 1u);
  EXPECT_EQ(f.triangles_lost + f.triangles_added, 0u);
  EXPECT_FALSE(f.same());
}

TEST(Fidelity, MeasuresPositionsByTheMode) {
  const Input input = square();  // side 5: at 11 bits a step is 5/2047
  Output out = same(input);
  out.positions[0] += 0.0012f;  // less than half a step
  EXPECT_EQ(check(input, out, Mode::connectivity).positions_off, 0u);
  EXPECT_EQ(check(input, out, Mode::q11).positions_off, 0u);
  EXPECT_EQ(check(input, out, Mode::q14).positions_off, 1u);
  EXPECT_EQ(check(input, out, Mode::lossless).positions_off, 1u);
  out.positions[0] = 0.0013f;
  EXPECT_EQ(check(input, out, Mode::q11).positions_off, 1u);
  out.positions[0] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(check(input, out, Mode::q11).positions_off, 1u);
}

TEST(Fidelity, RefusesLies) {
  const Input input = square();
  Output beyond = same(input);
  beyond.triangles[0] = 5;
  EXPECT_THROW(check(input, beyond, Mode::connectivity), CodecFailure);
  Output foreign = same(input);
  foreign.origin[0] = 5;
  EXPECT_THROW(check(input, foreign, Mode::connectivity), CodecFailure);
  Output short_of = same(input);
  short_of.positions.pop_back();
  EXPECT_THROW(check(input, short_of, Mode::lossless), CodecFailure);
}

TEST(Manifold, IsJudgedByEdgesAndFans) {
  EXPECT_TRUE(is_oriented_manifold(4, {0, 1, 2, 2, 1, 3}));
  EXPECT_TRUE(is_oriented_manifold(4, {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2}));
  EXPECT_FALSE(is_oriented_manifold(4, {0, 1, 2, 1, 2, 3})) << "an edge twice in one direction";
  EXPECT_FALSE(is_oriented_manifold(5, {0, 1, 2, 2, 1, 3, 1, 2, 4})) << "three at an edge";
  EXPECT_FALSE(is_oriented_manifold(5, {0, 1, 2, 0, 3, 4})) << "two fans at vertex 0";
  EXPECT_FALSE(is_oriented_manifold(2, {0, 1, 1})) << "a vertex twice in a triangle";
}

TEST(Fidelity, ComparesFilesBitForBit) {
  Input input = square();
  input.file.meshes = {input.mesh};
  Output out;
  EXPECT_THROW(check(input, out, Mode::file), CodecFailure) << "no mesh";
  out.meshes = {input.mesh};
  EXPECT_TRUE(check(input, out, Mode::file).same());
  out.meshes[0].attributes[0].data[0] ^= std::byte{1};
  EXPECT_THROW(check(input, out, Mode::file), CodecFailure) << "another value";
}

TEST(Grid, MovesPositionsByHalfAStepAtMost) {
  const Input input = square();
  for (const Mode mode : {Mode::q11, Mode::q14, Mode::q16}) {
    const Grid grid = grid_of(input, bits(mode));
    Output out = same(input);
    out.positions = off_grid(on_grid(input.positions, grid), grid);
    EXPECT_TRUE(check(input, out, mode).same());
    EXPECT_EQ(on_grid(out.positions, grid), on_grid(input.positions, grid));
  }
  EXPECT_THROW(on_grid({0, std::numeric_limits<float>::infinity(), 0}, grid_of(input, 11)),
               CodecFailure);
}

// Codecs that go wrong in one way each.
struct Faulty : Codec {
  enum class Fault { none, throws, crashes, exits, hangs, lies } fault;
  const Input* input = nullptr;
  std::vector<char> result;

  explicit Faulty(Fault f) : fault(f) {}
  void prepare(const Input& i, Mode) override { input = &i; }
  void encode() override {
    std::vector<char> scratch(3 << 20);
    scratch[1 << 20] = 1;
  }
  std::size_t bytes() const override { return 17; }
  std::size_t position_bytes() const override { return 5; }
  void decode() override {
    result.resize(1 << 20);
    if (fault == Fault::throws) throw CodecFailure("cannot do it");
    if (fault == Fault::crashes) std::abort();
    if (fault == Fault::exits) std::_Exit(0);
    if (fault == Fault::hangs)
      for (;;) busy = 1;
  }
  void discard() override {}
  Output output() override {
    Output out = same(*input);
    if (fault == Fault::lies) out.triangles.resize(3);
    return out;
  }
};

Trial trial_of(Faulty::Fault fault) {
  const CodecEntry entry{
      "faulty", {Mode::connectivity}, [fault] { return std::make_unique<Faulty>(fault); }};
  return try_codec(entry, square(), Mode::connectivity, 1);
}

TEST(Trial, TellsHowACodecFails) {
  EXPECT_EQ(trial_of(Faulty::Fault::throws).failure, "cannot do it");
  EXPECT_EQ(trial_of(Faulty::Fault::crashes).failure, "crashes (Aborted)");
  EXPECT_EQ(trial_of(Faulty::Fault::exits).failure, "ends the process");
  EXPECT_EQ(trial_of(Faulty::Fault::hangs).failure, "takes too long");
}

TEST(Trial, CountsBytesHeapAndLoss) {
  const Trial good = trial_of(Faulty::Fault::none);
  EXPECT_EQ(good.failure, "");
  EXPECT_EQ(good.bytes, 17u);
  EXPECT_EQ(good.position_bytes, 5u);
  EXPECT_GT(good.encode_seconds, 0);
  EXPECT_GT(good.decode_seconds, 0);
  EXPECT_TRUE(good.fidelity.same());
  EXPECT_NEAR(double(good.encode_peak), 3 << 20, 1 << 16);
  EXPECT_NEAR(double(good.decode_peak), 1 << 20, 1 << 16);
  const Trial lie = trial_of(Faulty::Fault::lies);
  EXPECT_EQ(lie.failure, "");
  EXPECT_EQ(lie.fidelity.triangles_lost, 1u);
}

TEST(Heap, CountsTheMostHeldAtOnce) {
  start_counting_heap();
  void* volatile block = std::malloc(5 << 20);
  std::free(block);
  block = std::calloc(1 << 20, 2);
  block = std::realloc(block, 4 << 20);
  std::free(block);
  EXPECT_NEAR(double(stop_counting_heap()), 5 << 20, 1 << 16);
}

// Twice the work is twice the time: what everything else here is for.
TEST(Timing, GivesRatiosOfWork) {
  const auto work = [](int n) {
    for (int i = 0; i < n; ++i) busy = i;
  };
  const std::vector<Task> tasks = {{[&] { work(200000); }, [] {}}, {[&] { work(400000); }, [] {}}};
  const std::vector<Samples> samples = sample_in_turns(tasks, {});
  const Timing once = summary(samples[0]), twice = summary(samples[1]);
  EXPECT_NEAR(twice.quiet / once.quiet, 2, 0.3);
  for (const Timing& t : {once, twice}) {
    EXPECT_EQ(t.samples, 60u);
    EXPECT_LE(t.best, t.quiet);
    EXPECT_LE(t.quiet, t.median);
  }
}

TEST(Timing, SlowTasksSitRoundsOut) {
  int slow_runs = 0;
  const std::vector<Task> tasks = {{[] {
                                      const double start = thread_seconds();
                                      while (thread_seconds() < start + 0.02) {
                                      }
                                    },
                                    [&] { ++slow_runs; }}};
  EXPECT_EQ(sample_in_turns(tasks, {.repeats = 60, .budget = 0.01})[0].size(), 3u);
  EXPECT_EQ(slow_runs, 4) << "and one to warm up";
  EXPECT_EQ(sample_in_turns(tasks, {.repeats = 2, .budget = 0.01})[0].size(), 2u);
}

TEST(Timing, TakesTheFastestQuarter) {
  const Timing t = summary({16, 8, 1, 3, 7, 5, 6, 4, 2, 9, 15, 14, 10, 11, 13, 12});
  EXPECT_EQ(t.quiet, 2.5);
  EXPECT_EQ(t.median, 8.5);
  EXPECT_EQ(t.best, 1);
  EXPECT_EQ(summary({9, 3, 1, 2}).quiet, 2) << "three at least";
  EXPECT_EQ(summary({3}).quiet, 3);
}

// Sleep takes no processor time.
TEST(Timing, CountsProcessorTime) {
  const double before = thread_seconds();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_LT(thread_seconds() - before, 0.02);
}

// What the fitted sampling is said to take is what sampling takes, and no more than allowed.
TEST(Schedule, FitsTheTime) {
  Trial fast, slow;
  fast.encode_seconds = fast.decode_seconds = 0.001;
  slow.encode_seconds = 0.5, slow.decode_seconds = 0.1;
  const std::vector<const Trial*> trials(10, &fast);
  const Sampling all;  // 60 samples and 1 to warm up, twice
  EXPECT_NEAR(seconds_for(fast, all), 0.122, 1e-9);
  EXPECT_EQ(fitted(all, trials, 1.3).budget, all.budget);
  const Sampling tight = fitted(all, trials, 0.5);
  EXPECT_LT(tight.budget, 0.06);
  EXPECT_LE(10 * seconds_for(fast, tight), 0.5);
  EXPECT_GT(10 * seconds_for(fast, tight), 0.45);

  EXPECT_TRUE(is_sampled(slow, all));
  EXPECT_NEAR(seconds_for(slow, all), 0.5 + 3 * 0.5 + 0.1 + 1, 1e-9) << "three samples at least";
  EXPECT_FALSE(is_sampled(slow, fitted(all, {&slow}, 1)))
      << "no time for them: its first run stands";
  EXPECT_FALSE(is_sampled(fast, fitted(all, trials, -1))) << "the time is over";
}

// A mesh and what a codec makes of it, for tables.
Result row(const char* codec, std::uint64_t bytes) {
  Result r;
  r.codec = codec;
  r.mode = Mode::q11;
  r.trial.bytes = bytes;
  return r;
}

TEST(LeastRival, IsTheBestThatGivesTheMeshBack) {
  std::vector<Result> rows = {row("clers-5", 1), row("a", 30), row("b", 20), row("c", 10)};
  rows[3].trial.fidelity.triangles_lost = 1;
  const Result least = least_of(rows);
  EXPECT_EQ(least.codec, least_rival);
  EXPECT_EQ(least.trial.bytes, 20u);
  EXPECT_EQ(least.encode_mtri_s(), 0) << "it has no speed";
  rows[2].trial.failure = "crashes";
  EXPECT_EQ(least_of(rows).trial.bytes, 30u);
  rows[1].trial.fidelity.vertices_lost = 1;  // isolated ones
  EXPECT_EQ(least_of(rows).trial.bytes, 30u);
  rows[1].trial.fidelity.positions_off = 1;
  EXPECT_TRUE(least_of(rows).failed());
}

TEST(Groups, AreThoseOfTheMode) {
  Result r;
  r.mesh = "game-spot-uv";
  r.manifold = true;
  r.draco_connectivity = 500;
  r.vertices = 1000;
  for (const Mode mode : all_modes) {
    r.mode = mode;
    for (const std::string& group : groups_of(r)) {
      const std::vector<std::string> names = group_names(mode);
      EXPECT_NE(std::find(names.begin(), names.end(), group), names.end()) << group;
    }
  }
  r.mode = Mode::q11;
  EXPECT_TRUE(in_group(r, "mirror, grid or copies"));
  r.mesh = "scan-bunny";
  EXPECT_TRUE(in_group(r, "no mirror, grid, copies"));
  r.mode = Mode::file;
  EXPECT_EQ(groups_of(r).size(), 2u);
  r.corner_values = true;
  EXPECT_EQ(groups_of(r).size(), 1u);
  r.vertices = 999;
  EXPECT_TRUE(groups_of(r).empty());
}

TEST(Groups, LeaveOutMeshesThatSayNothing) {
  Result r;
  r.mesh = "scan-bunny-zipper";
  r.manifold = true;
  r.draco_connectivity = 500;
  EXPECT_EQ(groups_of(r).size(), 3u);
  r.draco_connectivity = 499;
  EXPECT_TRUE(groups_of(r).empty());
  r.draco_connectivity = 500;
  r.manifold = false;
  EXPECT_TRUE(groups_of(r).empty());
  r.manifold = true;
  r.mesh = "many-components-plant";
  EXPECT_EQ(groups_of(r), std::vector<std::string>{"manifold"});
}

}  // namespace
}  // namespace clers::bench
