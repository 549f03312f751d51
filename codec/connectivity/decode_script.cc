// A pass over the symbols in the order of decoding, with no more than the lengths of curves.
#include "codec/connectivity/decode_script.h"

#include <utility>

namespace clers::internal {
namespace {

/// Goes through the symbols as a decoder will. Of the surface it follows but the lengths of its
/// boundary curves.
class Recording {
 public:
  explicit Recording(Traversal& traversal)
      : traversal_(traversal),
        next_start_(traversal.starts.size()),
        next_special_(traversal.specials.size()) {}

  DecodeScript run() {
    const std::vector<std::uint8_t>& contexts = traversal_.contexts;
    const std::uint32_t faces = static_cast<std::uint32_t>(contexts.size());
    if (faces == 0) return {};
    // Most symbols are C, R and L. They are counted, C below and R above, without a branch on
    // which it is: it would be mispredicted.
    static constexpr std::uint64_t one[8] = {1, std::uint64_t(1) << 32};
    std::uint64_t counts = 0;
    for (std::uint32_t i = 1; i < faces; ++i) {
      const Clers symbol = static_cast<Clers>(contexts[i] & 7);
      counts += one[static_cast<unsigned>(symbol)];
      if (symbol < Clers::S) continue;
      go_on(i, static_cast<std::uint32_t>(counts));
      const std::uint32_t index = faces - 1 - i;
      if (symbol == Clers::E)
        begin_curve(i, index);
      else if (next_special_ > 0 && traversal_.specials[next_special_ - 1].index == index)
        special(i);
      else
        join_to_aside(i);
    }
    const std::uint32_t closings = static_cast<std::uint32_t>(counts);
    go_on(faces, closings);
    end_component(faces - 1);
    const std::uint32_t rights = static_cast<std::uint32_t>(counts >> 32);
    script_.symbols = {closings, rights, symbols_ - closings - rights,
                       faces - 1 - symbols_ - begun_, 1 + begun_};
    script_.contexts = std::move(traversal_.contexts);
    script_.vertices = std::move(traversal_.vertices);
    return std::move(script_);
  }

 private:
  /// Up to a symbol: since the last S or E each C took an edge away, each R and L added one.
  void go_on(std::uint32_t symbol, std::uint32_t closings) {
    const std::uint32_t symbols = symbol - after_;
    length_ += symbols - 2 * (closings - closings_);
    symbols_ += symbols;
    after_ = symbol + 1;
    closings_ = closings;
  }

  void begin_curve(std::uint32_t symbol, std::uint32_t index) {
    ++begun_;
    bool ends = false;
    if (pending_.empty()) {
      // Symbols come last to first: a component ends where the one decoded before it started.
      ends = traversal_.starts[next_start_ - 1].index == index + 1;
      script_.events.push_back({symbol, Event::Kind::new_component, ends, length_ == 2});
    }
    if (ends)
      end_component(symbol);
    else
      pending_.push_back(length_);
    length_ = 3;
  }

  void end_component(std::uint32_t symbol) {
    --next_start_;
    if (length_ == 2)
      script_.events.push_back(
          {symbol, Event::Kind::closed, traversal_.starts[next_start_].closed});
  }

  void join_to_aside(std::uint32_t symbol) {
    script_.events.push_back({symbol, Event::Kind::special, false});
    length_ += pending_.back() - 1;
    pending_.pop_back();
  }

  void special(std::uint32_t symbol) {
    if (!pending_.empty()) script_.events.push_back({symbol, Event::Kind::special, true});
    const Traversal::Special& s = traversal_.specials[--next_special_];
    Event e{symbol, Event::Kind::hole};
    e.distance = s.distance;
    e.length = s.length;
    e.recency = s.recency;
    if (s.kind == SpecialS::join) {
      e.kind = Event::Kind::join;
      length_ += s.length - 1;
    } else {
      if (s.kind == SpecialS::split) e.kind = Event::Kind::split;
      length_ -= 1 + s.distance;
    }
    script_.events.push_back(e);
  }

  Traversal& traversal_;
  DecodeScript script_;
  std::size_t next_start_, next_special_;
  std::vector<std::uint32_t> pending_;        ///< lengths of the curves of pending gates
  std::uint32_t length_ = 3;                  ///< of the gate's curve
  std::uint32_t begun_ = 0;                   ///< curves, the first excepted
  std::uint32_t after_ = 1;                   ///< the last S or E, it goes on here
  std::uint32_t closings_ = 0, symbols_ = 0;  ///< C until there; C, R and L
};

}  // namespace

DecodeScript script_of(Traversal& traversal) {
  return Recording(traversal).run();
}

}  // namespace clers::internal
