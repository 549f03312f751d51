// Lengths as somebody types them.
#ifndef CLERS_CODEC_CLI_EXTENT_H
#define CLERS_CODEC_CLI_EXTENT_H

namespace clers::cli {

/// A length in units of the positions, or a share of the diagonal of their bounding box.
struct Extent {
  double value = 0;
  bool of_diagonal = false;

  double in_units(double diagonal) const { return of_diagonal ? value * diagonal : value; }
};

}  // namespace clers::cli

#endif
