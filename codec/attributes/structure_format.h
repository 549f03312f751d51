// What stands before the values of an attribute that are not simply one an element, in order: how
// many there are, and the streams that say which element has which <-> bytes.
#ifndef CLERS_CODEC_ATTRIBUTES_STRUCTURE_FORMAT_H
#define CLERS_CODEC_ATTRIBUTES_STRUCTURE_FORMAT_H

#include <cstdint>
#include <string>

#include "codec/entropy/bytes.h"
#include "codec/entropy/stream.h"
#include "codec/mesh.h"

namespace clers::internal {

/// Which values of an attribute are one. The numbers are the file format's.
enum class Sharing : std::uint8_t {
  none = 0,    ///< every wedge, vertex or face has its own
  equal = 1,   ///< those that are equal, bit for bit
  listed = 2,  ///< a stream says it (sharing.h)
};
inline constexpr unsigned sharing_count = 3;

/// Without a structure there is one value an element, in order; or one a place (points.h).
struct StructureHeader {
  bool any = false;
  bool at_places = false;  ///< vertices at one place have one value; no structure
  bool indexed = false;    ///< elements have values by index (Attribute::indices)
  bool missing = false;    ///< some elements have none
  bool beside = false;     ///< seams are in the context of those of an earlier attribute
  bool numbered = false;   ///< values have the numbers of the input
  bool apart = false;      ///< by index: each element has a value of its own, though many are equal
  Sharing sharing = Sharing::none;
  std::uint64_t values = 0;    ///< that are coded
  std::uint64_t unused = 0;    ///< of them, the last: no element has them
  std::uint64_t distinct = 0;  ///< that come out, the unused ones too
  Stream stream;
  Stream numbering;

  /// The bits that say of an attribute what it has, above those of its domain.
  std::uint32_t bits() const {
    if (!any) return at_places ? 8 : 0;
    return 4u | unsigned(indexed) << 3 | unsigned(missing) << 4 | unsigned(beside) << 5 |
           static_cast<std::uint32_t>(sharing) << 6;
  }

  void put(Bytes& out) const {
    if (!any) return;
    put_varint(out, values);
    if (indexed) {
      put_varint(out, unused << 2 | unsigned(apart) << 1 | unsigned(numbered));
      if (sharing == Sharing::equal || apart) put_varint(out, distinct);
      if (numbered) put_stream(out, numbering);
    }
    put_stream(out, stream);
  }

  void read(ByteReader& in, std::uint32_t bits) {
    any = bits & 4;
    at_places = !any && bits & 8;
    indexed = any && bits & 8;
    missing = bits >> 4 & 1;
    beside = bits >> 5 & 1;
    sharing = static_cast<Sharing>(bits >> 6);
    if (!any) return;
    values = distinct = in.varint();
    if (indexed) {
      const std::uint64_t n = in.varint();
      unused = n >> 2;
      apart = n >> 1 & 1;
      numbered = n & 1;
      if (sharing == Sharing::equal || apart) distinct = in.varint();
      if (numbered) numbering = read_stream(in, {});
    }
    stream = read_stream(in, {});
  }

  /// What keeps an attribute of a domain from having this; empty: nothing.
  std::string fault(Domain domain, std::uint32_t bits) const {
    const char* const none = "an attribute of no structure that is known";
    if (!any)
      return bits >> 2 == (at_places ? 2u : 0u) && (!at_places || domain == Domain::vertex) ? ""
                                                                                            : none;
    if (bits >> 6 >= sharing_count || (beside && domain != Domain::corner)) return none;
    if (!indexed && (missing || sharing == Sharing::equal ||
                     (sharing == Sharing::none && domain != Domain::corner)))
      return none;
    if (apart && (sharing == Sharing::equal || domain != Domain::corner)) return none;
    if (values >= no_value - 1 || distinct >= no_value - 1 || unused > values ||
        unused > distinct || (apart ? distinct < values : distinct > values))
      return std::to_string(values) + " values, " + std::to_string(unused) +
             " of them unused and " + std::to_string(distinct) + " distinct";
    return {};
  }

  /// For people: AttributeInfo::structure.
  std::string in_words(Domain domain) const {
    if (at_places) return "welded";
    std::string words;
    const auto add = [&](bool what, const char* word) {
      if (what) words += (words.empty() ? "" : ", ") + std::string(word);
    };
    add(any && domain == Domain::corner, "wedges");
    add(indexed, "by index");
    add(sharing != Sharing::none, "shared");
    add(apart, "apart");
    add(missing, "some missing");
    add(unused > 0, "some unused");
    return words;
  }

 private:
  static void put_stream(Bytes& out, const Stream& stream) {
    put_varint(out, stream.bytes.size());
    put_bytes(out, stream.bytes);
  }
};

}  // namespace clers::internal

#endif
