// Random sequences of operators, judged by the oracle.
//
// Short sequences: after every operator the oracle recounts everything, validate() is clean, what a
// refused operator left is what was there, and the operator's inverse gives back an equivalent
// surface. Long sequences: the oracle and validate() every so often, the Euler-Poincaré formula
// always.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "topology/derived.h"
#include "topology/dump.h"
#include "topology/equivalence.h"
#include "topology/test/oracle.h"
#include "topology/validate.h"

namespace clers {
namespace {

using test::Oracle;

/// One random step; what its numbers mean depends on the surface it meets.
struct Op {
  std::uint8_t kind = 0;
  std::uint8_t choice = 0;
  std::uint16_t a = 0, b = 0;
};

void showValue(const Op& op, std::ostream& os) {
  os << "{" << int{op.kind} << ", " << int{op.choice} << ", " << op.a << ", " << op.b << "}";
}

/// A surface and an oracle that live through the same operators.
class Pair {
 public:
  explicit Pair(bool thorough) : thorough_(thorough) {}

  const Surface& surface() const { return surface_; }
  const Oracle& oracle() const { return oracle_; }
  std::uint64_t glued(HandleCase kind) const { return glued_[static_cast<unsigned>(kind)]; }
  std::uint64_t done() const { return done_; }
  std::uint64_t refused() const { return refused_; }

  /// Does the step; empty, or what went wrong.
  std::string step(const Op& op, std::uint32_t target_faces) {
    seed_ = (std::uint64_t{op.a} << 32) ^ (std::uint64_t{op.b} << 8) ^ op.choice;
    const bool crowded = surface_.characteristic().f > std::int64_t{target_faces};
    // kind: a percentage
    const unsigned kind = op.kind % 100;
    if (kind < 10 && !crowded) return create(op);
    if (kind < 15) return destroy(op);
    if (kind < 50) {
      first_ = pick(true);
      return glue(first_, partner(op));
    }
    if (kind < 65) return unglue(pick(false));
    if (kind < 90 && !crowded) return attach(pick(true), Point(op.b));
    return detach(op);
  }

  std::string check() const {
    if (std::string difference = oracle_.compare(surface_); !difference.empty()) return difference;
    const std::vector<Fault> faults = validate(surface_);
    return faults.empty() ? "" : describe(faults[0]);
  }

 private:
  using Handled = Result<HandleCase, Violation>;

  std::uint32_t random(std::uint32_t n) {
    seed_ = seed_ * 6364136223846793005u + 1442695040888963407u;
    return n == 0 ? 0 : static_cast<std::uint32_t>((seed_ >> 33) % n);
  }

  /// Mostly a live half-edge on the boundary or inside; now and then any number at all.
  HalfEdge pick(bool boundary) {
    HalfEdge h;
    for (int tries = 0; tries < 12; ++tries) {
      h = HalfEdge(random(surface_.half_edge_limit() + 2));
      if (surface_.is_live(h) && surface_.is_boundary(h) == boundary) {
        return h;
      }
    }
    return h;
  }

  /// A second half-edge for glue: by its place relative to the first, so that every case comes up.
  HalfEdge partner(const Op& op) {
    const HalfEdge h = pick(true);
    if (!surface_.is_live(first_) || !surface_.is_boundary(first_)) return h;
    switch (op.choice % 8) {
      case 0: return surface_.boundary_next(first_);
      case 1: return surface_.boundary_prev(first_);
      case 2: {
        HalfEdge x = first_;
        for (std::uint32_t i = random(5) + 2; i > 0; --i) x = surface_.boundary_next(x);
        return x;
      }
      case 3: {  // a curve of one edge, if there is one near
        for (int i = 0; i < 8; ++i)
          if (const HalfEdge x = pick(true);
              surface_.is_live(x) && surface_.is_boundary(x) && surface_.boundary_next(x) == x)
            return x;
        return h;
      }
      default: return h;
    }
  }

  std::string refuse(const std::string& before) {
    ++refused_;
    if (thorough_ && dump(surface_) != before) return "a refused operator changed the surface";
    return "";
  }

  std::string create(const Op& op) {
    const Characteristic before = surface_.characteristic();
    const auto f = surface_.create(Point(op.a), Point(op.b), Point(op.a));
    if (!f) return "create was refused";
    oracle_.create(f->index());
    ++done_;
    if (surface_.characteristic() != before + effect_of_create) return "wrong effect of create";
    if (thorough_) {
      Surface undone = surface_;
      const auto points = undone.destroy(*f);
      if (!points || (*points)[1] != Point(op.b) || undone.characteristic() != before)
        return "destroy does not undo create";
    }
    return "";
  }

  std::string destroy(const Op&) {
    const HalfEdge h = pick(true);
    const Face f = left(h);
    const bool alone = surface_.is_live(f) && surface_.is_boundary(half_edge(f, 0)) &&
                       surface_.is_boundary(half_edge(f, 1)) &&
                       surface_.is_boundary(half_edge(f, 2));
    const std::string before = thorough_ ? dump(surface_) : "";
    const auto points = surface_.destroy(f);
    if (points.ok() != alone) return "destroy of " + std::to_string(f.index()) + " misjudged";
    if (!points) return refuse(before);
    oracle_.destroy(f.index());
    ++done_;
    if (thorough_) {
      Surface undone = surface_;
      const auto again = undone.create((*points)[0], (*points)[1], (*points)[2]);
      if (!again || *again != f) return "create does not undo destroy";
      for (unsigned i = 0; i < 3; ++i)
        if (undone.point(undone.org(half_edge(f, i))) != (*points)[i]) return "points were lost";
    }
    return "";
  }

  std::string glue(HalfEdge h0, HalfEdge h1) {
    const bool allowed = surface_.is_live(h0) && surface_.is_live(h1) && h0 != h1 &&
                         surface_.is_boundary(h0) && surface_.is_boundary(h1);
    const std::string text = thorough_ ? dump(surface_) : "";
    const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
    const Characteristic before = surface_.characteristic();
    const Handled kind = surface_.glue(h0, h1);
    if (kind.ok() != allowed) return "glue misjudged";
    if (!kind) return refuse(text);
    ++done_;
    ++glued_[static_cast<unsigned>(*kind)];
    oracle_.glue(h0.index(), h1.index());
    if (surface_.characteristic() != before + effect(*kind)) return "wrong effect of glue";
    if (old) {
      Surface undone = surface_;
      const Handled back = undone.unglue(h0);
      if (!back || *back != *kind) return "unglue does not name the glue it undoes";
      return compare(undone, *old, "unglue does not undo glue");
    }
    return "";
  }

  std::string unglue(HalfEdge h) {
    const bool allowed = surface_.is_live(h) && !surface_.is_boundary(h);
    const std::string text = thorough_ ? dump(surface_) : "";
    const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
    const Characteristic before = surface_.characteristic();
    const HalfEdge twin = allowed ? surface_.sym(h) : HalfEdge();
    const Handled kind = surface_.unglue(h);
    if (kind.ok() != allowed) return "unglue misjudged";
    if (!kind) return refuse(text);
    oracle_.unglue(h.index());
    ++done_;
    if (surface_.characteristic() != before - effect(*kind)) return "wrong effect of unglue";
    if (old) {
      Surface undone = surface_;
      const Handled back = undone.glue(h, twin);
      if (!back || *back != *kind) return "glue is not of the case that unglue named";
      if (std::string wrong = compare(undone, *old, "glue does not undo unglue"); !wrong.empty())
        return wrong;
      for (const Face f : undone.faces())
        for (const HalfEdge x : undone.star(f))
          if (undone.point(undone.org(x)) != old->point(old->org(x))) return "points were lost";
    }
    return "";
  }

  std::string attach(HalfEdge h, Point p) {
    const bool allowed = surface_.is_live(h) && surface_.is_boundary(h);
    const std::string text = thorough_ ? dump(surface_) : "";
    const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
    const Vertex org = allowed ? surface_.org(h) : Vertex();
    const auto f = clers::attach(surface_, h, p);
    if (f.ok() != allowed) return "attach misjudged";
    if (!f) return refuse(text);
    oracle_.create(f->index());
    oracle_.glue(h.index(), 3 * f->index());
    done_ += 2;
    if (surface_.org(h) != org) return "attach renamed a vertex of the gate";
    if (surface_.point(surface_.org(half_edge(*f, 2))) != p) return "the apex is on another point";
    if (old) {
      Surface undone = surface_;
      if (!clers::detach(undone, half_edge(*f, 1))) return "detach was refused";
      return compare(undone, *old, "detach does not undo attach");
    }
    return "";
  }

  std::string detach(const Op& op) {
    const HalfEdge h = pick(op.choice % 2 == 0);
    const bool allowed = surface_.is_live(h);
    const std::string text = thorough_ ? dump(surface_) : "";
    const std::optional<Surface> old = thorough_ ? std::optional(surface_) : std::nullopt;
    const Characteristic before = surface_.characteristic();
    const auto done = clers::detach(surface_, h);
    if (done.ok() != allowed) return "detach misjudged";
    if (!done) return refuse(text);
    Characteristic after = before - effect_of_create;
    for (const Cut& cut : done->cuts()) {
      oracle_.unglue(cut.h.index());
      after -= effect(cut.undone);
    }
    oracle_.destroy(left(h).index());
    done_ += 1 + done->cuts().size();
    if (surface_.characteristic() != after) return "wrong effect of detach";
    if (old) {
      Surface undone = surface_;
      const auto f = undone.create(done->points()[0], done->points()[1], done->points()[2]);
      if (!f || *f != left(h)) return "create does not undo destroy";
      for (std::size_t i = done->cuts().size(); i-- > 0;) {
        const Cut& cut = done->cuts()[i];
        const Handled kind = undone.glue(cut.h, cut.twin);
        if (!kind || *kind != cut.undone) return "glue is not of the case that detach named";
      }
      return compare(undone, *old, "glues do not undo detach");
    }
    return "";
  }

  static std::string compare(const Surface& a, const Surface& b, const char* wrong) {
    const auto map = equivalent(a, b);
    if (!map) return wrong;
    for (const Face f : a.faces())
      for (const HalfEdge h : a.star(f)) {
        const HalfEdge image = map->half_edges[h.index()];
        if (map->vertices[a.org(h).index()] != b.org(image)) return "bad correspondence";
        if (lnext(image) != map->half_edges[lnext(h).index()]) return "bad correspondence";
      }
    return validate(a).empty() ? "" : "an undone operator leaves faults";
  }

  Surface surface_;
  Oracle oracle_;
  bool thorough_;
  std::uint64_t seed_ = 0;
  HalfEdge first_;  // that of the glue under way
  std::uint64_t glued_[handle_case_count] = {};
  std::uint64_t done_ = 0, refused_ = 0;  // counting the parts of attach and detach
};

}  // namespace
}  // namespace clers

namespace rc {
template <>
struct Arbitrary<clers::Op> {
  static Gen<clers::Op> arbitrary() {
    return gen::build<clers::Op>(gen::set(&clers::Op::kind), gen::set(&clers::Op::choice),
                                 gen::set(&clers::Op::a), gen::set(&clers::Op::b));
  }
};
}  // namespace rc

namespace clers {
namespace {

/// The same cases in every run, unless RC_PARAMS says otherwise; CLERS_LONG multiplies their
/// number.
const bool params_set = [] {
  const char* factor = std::getenv("CLERS_LONG");
  const int cases = 100 * (factor ? std::max(1, std::atoi(factor)) : 1);
  setenv("RC_PARAMS", ("seed=2010 max_success=" + std::to_string(cases)).c_str(), 0);
  return true;
}();

/// Runs the steps and checks after every `stride`-th, and at the end.
void run(Pair& pair, const std::vector<Op>& ops, std::uint32_t target_faces, std::size_t stride) {
  const auto fail = [&](std::size_t i, const std::string& wrong) {
    RC_FAIL(wrong + " (step " + std::to_string(i) + ")\n" + dump(pair.surface()) +
            dump_code(pair.surface()));
  };
  for (std::size_t i = 0; i < ops.size(); ++i) {
    if (const std::string wrong = pair.step(ops[i], target_faces); !wrong.empty()) fail(i, wrong);
    if (!pair.surface().characteristic().is_valid()) fail(i, "the formula does not hold");
    if ((i + 1) % stride == 0 || i + 1 == ops.size())
      if (const std::string wrong = pair.check(); !wrong.empty()) fail(i, wrong);
  }
}

/// Up to `length` steps; failing sequences shrink by leaving steps out.
std::vector<Op> sequence(int length) {
  return *rc::gen::resize(
      length, rc::gen::container<std::vector<Op>>(rc::gen::resize(200, rc::gen::arbitrary<Op>())));
}

/// What all the cases of a property did together.
struct Tally {
  std::uint64_t done = 0, refused = 0, kinds[handle_case_count] = {};

  void add(const Pair& pair) {
    done += pair.done();
    refused += pair.refused();
    for (unsigned i = 0; i < handle_case_count; ++i) kinds[i] += pair.glued(HandleCase(i));
  }

  void expect_all_cases() const {
    for (unsigned i = 0; i < handle_case_count; ++i) {
      std::printf("%-26s %llu\n", name(HandleCase(i)), static_cast<unsigned long long>(kinds[i]));
      EXPECT_GT(kinds[i], 0u) << name(HandleCase(i)) << " never happened";
    }
    std::printf("operators done %llu, refused %llu\n", static_cast<unsigned long long>(done),
                static_cast<unsigned long long>(refused));
    EXPECT_GT(refused, 0u);
  }
};

/// Many steps on surfaces that stay small: every one is checked and undone.
void thorough(std::uint32_t target_faces, int length) {
  Tally tally;
  EXPECT_TRUE(rc::check([&] {
    const auto ops = sequence(length);
    Pair pair(true);
    run(pair, ops, target_faces, 1);
    tally.add(pair);
  }));
  tally.expect_all_cases();
}

TEST(Operators, EveryStepOnUpTo4Faces) {
  thorough(4, 300);
}
TEST(Operators, EveryStepOnUpTo12Faces) {
  thorough(12, 400);
}
TEST(Operators, EveryStepOnUpTo40Faces) {
  thorough(40, 200);
}

TEST(Operators, AMillionSteps) {
  Tally tally;
  EXPECT_TRUE(rc::check([&] {
    const auto target = *rc::gen::element<std::uint32_t>(20, 60, 200, 1000, 4000);
    const auto ops = sequence(30'000);
    Pair pair(false);
    run(pair, ops, target, 1000);
    tally.add(pair);
  }));
  tally.expect_all_cases();
  EXPECT_GE(tally.done, 1'000'000u);
}

}  // namespace
}  // namespace clers
