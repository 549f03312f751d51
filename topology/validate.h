// Checks everything that must hold of a surface's arrays.
#ifndef CLERS_TOPOLOGY_VALIDATE_H
#define CLERS_TOPOLOGY_VALIDATE_H

#include <cstddef>
#include <vector>

#include <clers/topology/errors.h>
#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// The invariants that do not hold, with the elements at which they fail, at most `limit` of them
/// in the order of `Invariant`; none for a valid surface. What relies on an invariant that failed
/// is not checked further: fewer faults than there are may be reported, never one that is not
/// there.
///
/// Trusts nothing: reads the raw arrays, every loop bounded by their sizes, whatever they hold.
/// Never asserts. O(F + B log B) time, O(F) memory.
std::vector<Fault> validate(const Surface& surface, std::size_t limit = 16);

}  // namespace clers

#endif
