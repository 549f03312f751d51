// Connectivity written symbol by symbol, as codec/format.md says and no encoder does.
#ifndef CLERS_CODEC_TEST_STREAM_WRITER_H
#define CLERS_CODEC_TEST_STREAM_WRITER_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "codec/connectivity/connectivity.h"
#include "codec/connectivity/event_model.h"
#include "codec/entropy/bytes.h"
#include "codec/entropy/rans.h"
#include "codec/symbols/prefix_code.h"
#include "codec/symbols/symbol.h"

namespace clers::internal {

/// Symbols of a prefix code and their answers. Begins after the first triangle. Knows the lengths
/// of boundary curves, since numbers are coded by them, but not whether a face repeats a vertex:
/// that is the caller's to avoid.
class StreamWriter {
 public:
  explicit StreamWriter(std::size_t most_faces) : symbols_(most_faces), answers_(stream_) {}

  std::uint32_t length() const { return n_; }  ///< edges of the gate's curve
  std::size_t pending() const { return pending_.size(); }
  std::size_t waiting() const { return waiting_.size(); }
  std::uint32_t waiting_length(std::size_t recency) const {
    return waiting_[waiting_.size() - 1 - recency];
  }
  std::uint32_t faces() const { return faces_; }

  void c() { put(Clers::C), --n_; }
  void r() { put(Clers::R), ++n_, ++made_; }
  void l() { put(Clers::L), ++n_, ++made_; }
  /// Pushes the gate, or ends the component.
  void e(bool new_component = false, bool closed = false) {
    put(Clers::E);
    if (pending_.empty()) events_.new_component(answers_, n_ == 2, new_component);
    new_component ? end(closed) : pending_.push_back(n_);
    n_ = 3, made_ += 3;
  }
  void s() {
    put_s(false);
    n_ += pending_.back() - 1;
    pending_.pop_back();
  }
  void hole(std::uint32_t d) {
    put_special(SpecialS::hole);
    events_.hole_length(answers_, d);
    n_ -= d + 1;
  }
  void split(std::uint32_t d) {
    put_special(SpecialS::split);
    events_.split_distance(answers_, n_, d);
    waiting_.push_back(d);
    n_ -= d + 1;
  }
  void join(std::uint32_t recency, std::uint32_t position) {
    put_special(SpecialS::join);
    const auto at = waiting_.end() - 1 - static_cast<std::ptrdiff_t>(recency);
    events_.join_curve(answers_, static_cast<std::uint32_t>(waiting_.size()), recency);
    events_.join_position(answers_, *at, position);
    n_ += *at - 1;
    waiting_.erase(at);
  }

  /// Everything there is. Precondition: no gate is pending, no curve waits.
  Bytes finish(bool closed) {
    end(closed);
    const std::vector<std::byte> symbols = symbols_.finish();
    Bytes out;
    put_varint(out, faces_);
    put_signed_varint(out, 2 * std::int64_t(made_ - merges_) - faces_ - 4);
    std::uint32_t room = 0;
    while (room_for_merges(room) < merges_) ++room;
    put_u8(out, room);
    put_u8(out, 0);
    put_varint(out, symbols.size());
    put_bytes(out, symbols);
    stream_.finish(out);
    return out;
  }

 private:
  void put(Clers symbol) {
    symbols_.put(symbol);
    ++faces_;
  }
  void put_s(bool special) {
    put(Clers::S);
    ++merges_;
    if (!pending_.empty()) events_.special(answers_, special);
  }
  void put_special(SpecialS kind) {
    put_s(true);
    events_.kind(answers_, !waiting_.empty(), kind);
  }
  void end(bool closed) {
    if (n_ == 2) events_.closed(answers_, closed);
  }

  SymbolWriter symbols_;
  rans::Encoder stream_;
  EncodeTo answers_;
  EventModel events_;
  std::uint32_t n_ = 3, faces_ = 1, made_ = 3, merges_ = 0;
  std::vector<std::uint32_t> pending_, waiting_;  ///< lengths
};

}  // namespace clers::internal

#endif
