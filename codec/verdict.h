// What a comparison of two meshes says.
#ifndef CLERS_CODEC_VERDICT_H
#define CLERS_CODEC_VERDICT_H

#include <optional>
#include <string>
#include <vector>

#include <clers/mesh.h>
#include <clers/precision.h>
#include <clers/topology/export.h>

namespace CLERS_VISIBLE clers {

enum class Verdict {
  same,       ///< a renumbering was found under which all faces agree, and all values: bit for bit,
              ///< or within a tolerance
  different,  ///< no renumbering can exist
  undecided,  ///< neither could be shown within the work allowed, or colours collided
};

/// How far the components of an attribute's values may be apart, or their directions.
struct Tolerance {
  std::string name;
  double error = 0;                   ///< at least 0
  std::optional<Domain> domain = {};  ///< not set: any
  /// angle: for attributes of three components.
  ErrorMeasure measure = ErrorMeasure::difference;
};

/// The largest difference of any component of an attribute, or the largest angle.
struct FoundError {
  std::string attribute;
  Domain domain = Domain::vertex;
  double error = 0;
  ErrorMeasure measure = ErrorMeasure::difference;
};

struct Comparison {
  Verdict verdict = Verdict::undecided;
  std::string what;  ///< the first difference, for people; empty when same
  /// Of the attributes that are compared within a tolerance, under the renumbering that was found.
  std::vector<FoundError> errors = {};
};

}  // namespace clers

#endif
