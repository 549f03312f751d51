// The numbers of a text format that does not say how wide they are.
#ifndef CLERS_CODEC_IO_NUMBERS_H
#define CLERS_CODEC_IO_NUMBERS_H

#include <cstdint>
#include <string>
#include <vector>

#include "codec/io/text.h"
#include "codec/mesh.h"

namespace clers::io {

/// Collects numbers as float32 for as long as each of them can be a float32 in decimal: its nearest
/// float32 rounds, in decimal, to the text, or the text is the shortest that reads as it. One
/// number for which neither holds makes all of them float64.
///
/// So what a program wrote from float32, with however many digits, becomes these float32 (with six
/// or fewer digits: the nearest), what it wrote from float64 stays float64, and what
/// print_untyped() writes reads back with the same value, bit for bit.
class Numbers {
 public:
  /// Reads one number; on false nothing is kept.
  bool read(Text& text);
  /// 0.0 where a file leaves a value to its default.
  void push_zero();

  std::size_t size() const { return wide_.size(); }
  /// Precondition: there is one.
  double last() const { return wide_.back(); }

  /// The values as an attribute's data; leaves nothing behind.
  Attribute take(std::string name, Domain domain, unsigned components);

 private:
  std::vector<double> wide_;
  std::vector<float> narrow_;  // as many as in wide_, while all_narrow_
  bool all_narrow_ = true;
};

/// Prints one number of an attribute with the fewest digits that read back bit for bit (NaN: its
/// sign only).
void print(Output& out, const Attribute& attribute, std::size_t index);

/// The same for Numbers to read: a float64 that reads as float32 with its fewest digits but is none
/// gets all 17 digits, to say so.
void print_untyped(Output& out, const Attribute& attribute, std::size_t index);

/// Colours between 0 and 1 <-> bytes. The first gives bytes if each of the values is the float32 of
/// k / 255, bit for bit, else the attribute as it is; the second is its inverse.
Attribute of_255ths(Attribute colors);
Attribute as_255ths(const Attribute& bytes);

/// NaNs whose bits a text cannot hold.
std::size_t count_lost_nans(const Attribute& attribute);

}  // namespace clers::io

#endif
