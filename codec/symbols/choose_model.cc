// A few runs of the symbols, coded by each model of the level; what it learns from is not counted.
#include "codec/symbols/choose_model.h"

#include <algorithm>
#include <cstddef>
#include <new>

#include "codec/entropy/rans.h"
#include "codec/symbols/context_models.h"
#include "codec/symbols/symbol.h"

namespace clers::internal {
namespace {

/// Symbols to judge models by: a few runs from all over, or all of a short string.
struct Sample {
  std::vector<std::uint8_t> contexts;
  /// Symbols of each run that are not counted: what a model has to learn matters less in the whole.
  std::size_t run, uncounted;

  explicit Sample(const std::vector<std::uint8_t>& all) {
    constexpr std::size_t runs = 8, least = 1u << 11, enough = 3u << 11, most = 1u << 15;
    run = std::clamp(all.size() / 12, std::clamp(all.size() / 4, least, enough), most) / runs;
    uncounted = run / 4;
    if (runs * run >= all.size()) {
      contexts = all;
      run = all.size();
      uncounted = 0;
      return;
    }
    contexts.reserve(runs * run);
    for (std::size_t r = 1; r <= runs; ++r) {
      const auto first =
          all.begin() + static_cast<std::ptrdiff_t>((all.size() - run) * r / (runs + 1));
      contexts.insert(contexts.end(), first, first + static_cast<std::ptrdiff_t>(run));
    }
  }

  /// What they cost, in 1/256 bits.
  template <class Model>
  std::uint64_t cost_with(Model model) const {
    if (!model.ok()) throw std::bad_alloc();
    std::uint64_t total = 0;
    for (std::size_t begin = 0; begin < contexts.size(); begin += run)
      for (std::size_t i = 0; i < run; ++i) {
        const std::uint8_t c = contexts[begin + i];
        const rans::Interval symbol = model.encode(static_cast<Clers>(c & 7), c >> 3);
        if (i >= uncounted) total += rans::cost(symbol);
      }
    return total;
  }
};

}  // namespace

SymbolModel choose_model(const std::vector<std::uint8_t>& contexts, int level) {
  using Kind = SymbolModel::Kind;
  if (level < 3) return {Kind::code, 0};
  if (level >= 9) return {Kind::mixing, 0};
  const Kind kind = level < 5 ? Kind::single : Kind::pair;
  SymbolModel best{kind, 3};
  if (contexts.size() < 64) return best;
  const Sample sample(contexts);
  std::uint64_t least = ~std::uint64_t(0);
  const auto judge = [&](SymbolModel m) {
    const std::uint64_t total =
        m.kind == Kind::single ? sample.cost_with(SingleModel(m.history))
                               : sample.cost_with(PairModel(m.history, m.kind == Kind::quick_pair));
    if (total >= least) return;
    least = total;
    best = m;
  };
  // A longer history while it pays, else the shortest where there is little to learn from.
  judge({kind, 3});
  judge({kind, 5});
  if (best.history == 5)
    judge({kind == Kind::pair ? Kind::quick_pair : kind, 8});
  else if (kind == Kind::single && contexts.size() < (1u << 16))
    judge({kind, 1});
  return best;
}

}  // namespace clers::internal
