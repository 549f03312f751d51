// A surface as text.
#ifndef CLERS_TOPOLOGY_DUMP_H
#define CLERS_TOPOLOGY_DUMP_H

#include <string>

#include <clers/topology/export.h>
#include <clers/topology/surface.h>

namespace CLERS_VISIBLE clers {

/// All that a surface's queries return, one line for each element: counts, faces with their
/// origins, twins and component, vertices, curves. For people, and to compare before and after.
std::string dump(const Surface& surface);

/// C++ that makes the surface by Surface::from_twins under the name `surface`: for a test. Dead ids
/// stay dead, though they may be reused in another order.
std::string dump_code(const Surface& surface);

}  // namespace clers

#endif
