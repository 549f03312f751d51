// What a comparison of two meshes says.
#ifndef CLERS_CODEC_VERDICT_H
#define CLERS_CODEC_VERDICT_H

#include <string>

#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

enum class Verdict {
  same,       ///< a renumbering was found under which all faces and values agree bit for bit
  different,  ///< no renumbering can exist
  undecided,  ///< neither could be shown within the work allowed, or colours collided
};

struct Comparison {
  Verdict verdict = Verdict::undecided;
  std::string what;  ///< the first difference, for people; empty when same
};

}  // namespace clers

#endif
