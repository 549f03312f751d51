// The five symbols of Edgebreaker (CAGD 2010, §7.2, Fig. 14) and how a handle or a hole shows among
// them.
#ifndef CLERS_CODEC_SYMBOLS_SYMBOL_H
#define CLERS_CODEC_SYMBOLS_SYMBOL_H

#include <cstdint>
#include <type_traits>

#include "codec/base/portable.h"

namespace clers::internal {

/// How the triangle behind the gate meets what is already visited (#; topology/figures has a
/// drawing). A symbol names the side that is visited: L, left visited, and the walk goes right. The
/// printed algorithm says so, the text beside it the contrary (topology/errata.md). The numbers are
/// the file format's.
///
///           v              v              v             #v#              v
///          / \            / \ #        # / \            / \          # / \ #
///         /   \          /   \ #      # /   \          /   \        # /   \ #
///        a ==> b        a ==> b        a ==> b        a ==> b        a ==> b
///        #######        #######        #######        #######        #######
///           C              R              L              S              E
///       v is new      right visited  left visited   v visited, but    all visited
///                                                   neither side
enum class Clers : std::uint8_t { C = 0, R = 1, L = 2, S = 3, E = 4 };

/// A symbol as a type, for code that is generated for each.
template <Clers symbol>
using Symbol = std::integral_constant<Clers, symbol>;

/// then(Symbol<symbol>()).
template <class Then>
CLERS_ALWAYS_INLINE auto with_symbol(Clers symbol, Then&& then) {
  switch (symbol) {
    case Clers::C: return then(Symbol<Clers::C>());
    case Clers::R: return then(Symbol<Clers::R>());
    case Clers::L: return then(Symbol<Clers::L>());
    case Clers::S: return then(Symbol<Clers::S>());
    default: return then(Symbol<Clers::E>());
  }
}

/// What the glue of an S means when it is not the usual join of two components (1a).
enum class SpecialS : std::uint8_t {
  hole = 0,   ///< splits a curve off that stays a boundary (1b)
  split = 1,  ///< splits a curve off that a later S joins: one end of a handle (1b)
  join = 2,   ///< joins a curve split off before: the other end (1c)
};

}  // namespace clers::internal

#endif
