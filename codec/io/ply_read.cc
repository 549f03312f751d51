#include <algorithm>
#include <cstring>
#include <map>
#include <set>

#include "codec/io/formats.h"
#include "codec/io/ply.h"

namespace clers::io {

namespace {

using namespace ply;

constexpr std::size_t none = static_cast<std::size_t>(-1);

// The float that x, y and z of different types become: float64 where one of them needs it.
Scalar widest_float(std::span<const std::size_t> members, const Element& element) {
  for (const std::size_t i : members)
    if (const Scalar s = element.properties[i].type; s != Scalar::float32 && size_of(s) >= 4)
      return Scalar::float64;
  return Scalar::float32;
}

template <class To>
To converted(Scalar scalar, const std::byte* from) {
  const auto as = [&]<class From>(From value) {
    std::memcpy(&value, from, sizeof value);
    return static_cast<To>(value);
  };
  switch (scalar) {
    case Scalar::int8: return as(std::int8_t{});
    case Scalar::uint8: return as(std::uint8_t{});
    case Scalar::int16: return as(std::int16_t{});
    case Scalar::uint16: return as(std::uint16_t{});
    case Scalar::int32: return as(std::int32_t{});
    case Scalar::uint32: return as(std::uint32_t{});
    case Scalar::float32: return as(float{});
    default: return as(double{});
  }
}

// Interleaves columns into the values of one attribute.
Attribute interleaved(std::string name, Domain domain, std::span<const std::size_t> members,
                      const Element& element, std::vector<Column>& columns) {
  const Scalar first = element.properties[members[0]].type;
  const bool agree = std::all_of(members.begin(), members.end(), [&](std::size_t i) {
    return element.properties[i].type == first;
  });
  Attribute a{std::move(name),
              domain,
              agree ? first : widest_float(members, element),
              static_cast<std::uint8_t>(members.size()),
              {}};
  if (agree && members.size() == 1) {
    a.data = std::move(columns[members[0]].values);
    return a;
  }
  const std::size_t size = size_of(a.scalar);
  a.data.resize(element.count * a.stride());
  for (std::size_t c = 0; c < members.size(); ++c) {
    const Scalar type = element.properties[members[c]].type;
    for (std::size_t i = 0; i < element.count; ++i) {
      const std::byte* from = columns[members[c]].values.data() + i * size_of(type);
      std::byte* to = a.data.data() + i * a.stride() + c * size;
      if (type == a.scalar) {
        std::memcpy(to, from, size);
      } else if (a.scalar == Scalar::float32) {
        const auto value = converted<float>(type, from);
        std::memcpy(to, &value, size);
      } else {
        const auto value = converted<double>(type, from);
        std::memcpy(to, &value, size);
      }
    }
    columns[members[c]] = {};
  }
  return a;
}

// Which properties of an element make which attribute.
struct Plan {
  struct Entry {
    std::string attribute;
    std::vector<std::size_t> members;  // properties, in the order of the components
    unsigned claimed = 1;              // components, if a claim says so
  };
  std::map<std::size_t, Entry> entries;  // by first property
};

bool claim_holds(const Claim& claim, const Element& element) {
  const std::span properties = element.properties;
  if (claim.first >= properties.size()) return false;
  const Property& first = properties[claim.first];
  if (first.count_type) return first.meaning == Meaning::value;
  if (properties.size() - claim.first < claim.components) return false;
  const std::span members = properties.subspan(claim.first, claim.components);
  return std::all_of(members.begin(), members.end(),
                     [&](const Property& p) { return !p.count_type && p.type == first.type; });
}

Plan plan(const Element& element) {
  Plan plan;
  std::vector<bool> taken(element.properties.size());
  const auto take = [&](std::string name, std::vector<std::size_t> members, unsigned claimed) {
    for (const std::size_t i : members) taken[i] = true;
    const std::size_t first = *std::min_element(members.begin(), members.end());
    plan.entries[first] = {std::move(name), std::move(members), claimed};
  };

  for (const Claim& claim : element.claims) {
    if (!claim_holds(claim, element)) continue;
    std::vector<std::size_t> members{claim.first};
    if (!element.properties[claim.first].count_type)
      while (members.size() < claim.components) members.push_back(members.back() + 1);
    if (std::none_of(members.begin(), members.end(), [&](std::size_t i) { return taken[i]; }))
      take(claim.name, std::move(members), claim.components);
  }

  std::map<std::string_view, std::size_t> scalars;
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (const Property& p = element.properties[i]; !p.count_type && !taken[i]) scalars[p.name] = i;
  std::set<std::string_view> found;
  for (const Convention& convention : conventions) {
    if (found.contains(convention.attribute)) continue;
    std::vector<std::size_t> members;
    for (const std::string_view name : convention.names())
      if (const auto at = scalars.find(name); at != scalars.end()) members.push_back(at->second);
    if (members.size() != convention.components) continue;
    const auto other_type = [&](std::size_t i) {
      return element.properties[i].type != element.properties[members[0]].type;
    };
    if (convention.attribute != position_name &&
        std::any_of(members.begin(), members.end(), other_type))
      continue;
    found.insert(convention.attribute);
    take(std::string(convention.attribute), std::move(members), 1);
  }

  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (const Property& p = element.properties[i]; p.meaning == Meaning::value && !taken[i])
      take(p.name, {i}, 1);
  return plan;
}

// How many values each corner has in a list; 0 if the lists do not follow the faces. Where there
// are no corners it is any number.
std::size_t values_per_corner(const Column& lists, const std::vector<std::uint32_t>& face_sizes,
                              std::size_t any) {
  std::size_t k = none;
  for (std::size_t f = 0; f < face_sizes.size(); ++f) {
    if (k == none && face_sizes[f] > 0) k = lists.sizes[f] / face_sizes[f];
    if (lists.sizes[f] != (face_sizes[f] > 0 ? k * face_sizes[f] : 0)) return 0;
  }
  if (k == none) return any;
  return k <= 255 ? k : 0;
}

class Reader {
 public:
  explicit Reader(Header header) : header_(std::move(header)) {}

  Expected<ReadResult> read(std::string_view file) {
    mesh_.vertex_count = header_.vertex_count();
    mesh_.name = header_.mesh_name;
    Body body(file, header_);
    for (const Element& element : header_.elements) {
      Expected<std::vector<Column>> columns = body.next(element);
      if (!columns) return Failure<Error>{columns.error()};
      Expected<Done> done = Done{};
      if (element.name == "vertex")
        done = attributes(element, *columns, Domain::vertex);
      else if (element.name == "face")
        done = faces(element, *columns);
      else if (element.name == "tristrips")
        done = strips(element, *columns);
      else
        note("element " + quoted(element.name) + " (" + counted(element.count, "entry", "entries") +
             ") is not part of a mesh and was left out");
      if (!done) return Failure<Error>{done.error()};
    }
    if (Expected<Done> done = body.end(notes_); !done) return Failure<Error>{done.error()};
    if (header_.comments)
      note(counted(header_.comments, "comment was", "comments were") + " left out");
    if (header_.obj_infos)
      note(counted(header_.obj_infos, "line obj_info was", "lines obj_info were") + " left out");
    // Vertex attributes first, whichever element came first.
    std::stable_partition(mesh_.attributes.begin(), mesh_.attributes.end(),
                          [](const Attribute& a) { return a.domain == Domain::vertex; });
    ReadResult result;
    result.meshes.push_back(std::move(mesh_));
    result.notes = std::move(notes_);
    return result;
  }

 private:
  // Scalars become attributes of the domain, lists of a face corner attributes.
  Expected<Done> attributes(const Element& element, std::vector<Column>& columns, Domain domain) {
    std::set<std::pair<Domain, std::string>> names;
    Plan planned = plan(element);
    for (auto& [first, entry] : planned.entries) {
      const Property& p = element.properties[first];
      Attribute a;
      if (!p.count_type) {
        a = interleaved(std::move(entry.attribute), domain, entry.members, element, columns);
      } else {
        const std::size_t components =
            domain == Domain::face ? values_per_corner(columns[first], face_sizes_, entry.claimed)
                                   : 0;
        if (components == 0) {
          note("list " + quoted(p.name) + " of element " + quoted(element.name) +
               " does not have one value or tuple for each corner and was left out");
          continue;
        }
        a = {std::move(entry.attribute), Domain::corner, p.type,
             static_cast<std::uint8_t>(components), std::move(columns[first].values)};
      }
      if (!names.insert({a.domain, a.name}).second)
        return fail(ErrorCode::unsupported, "two properties of element " + quoted(element.name) +
                                                " are both the attribute " + quoted(a.name));
      mesh_.attributes.push_back(std::move(a));
    }
    return Done{};
  }

  static std::size_t index_property(const Element& element) {
    for (std::size_t i = 0; i < element.properties.size(); ++i)
      if (element.properties[i].meaning != Meaning::value) return i;
    return none;
  }

  Expected<Done> faces(const Element& element, std::vector<Column>& columns) {
    if (element.count == 0 && !mesh_.corners.empty()) return Done{};  // strips came before
    const std::size_t indices = index_property(element);
    if (indices != none) {
      face_sizes_ = std::move(columns[indices].sizes);
      copy_indices(columns[indices], mesh_.corners);
    }
    if (Expected<Done> done = attributes(element, columns, Domain::face); !done) return done;
    set_face_sizes(mesh_, std::move(face_sizes_));
    return Done{};
  }

  // Vertices a b c d e ... of a strip are the faces abc, cbd, cde, ...: each but the first shares
  // an edge with the one before, and every second one is turned to lie the same way up. A repeated
  // vertex joins two strips into one and is no face.
  //
  //     a---c---e
  //      \ / \ / \      restart: a new strip
  //       b---d---f
  Expected<Done> strips(const Element& element, std::vector<Column>& columns) {
    if (element.count == 0) return Done{};
    // Of an element 'face' without entries, which had no values.
    std::erase_if(mesh_.attributes, [](const Attribute& a) { return a.domain != Domain::vertex; });
    const std::size_t property = index_property(element);
    std::vector<std::uint32_t> indices;
    copy_indices(columns[property], indices);
    std::uint64_t joins = 0;
    const std::uint32_t* strip = indices.data();
    for (const std::uint32_t size : columns[property].sizes) {
      std::size_t start = 0;
      for (std::size_t i = 0; i < size; ++i) {
        if (strip[i] == restart) {
          start = i + 1;
        } else if (i >= start + 2) {
          const bool turned = (i - start) % 2 != 0;
          const std::uint32_t a = strip[i - (turned ? 1 : 2)], b = strip[i - (turned ? 2 : 1)];
          if (a == b || b == strip[i] || strip[i] == a)
            ++joins;
          else
            mesh_.corners.insert(mesh_.corners.end(), {a, b, strip[i]});
        }
      }
      strip += size;
    }
    note(counted(element.count, "triangle strip", "triangle strips") + " became " +
         counted(mesh_.corners.size() / 3, "face", "faces"));
    if (joins)
      note(counted(joins, "place", "places") + " of a strip that repeat a vertex became no face");
    for (std::size_t i = 0; i < element.properties.size(); ++i)
      if (i != property)
        note("property " + quoted(element.properties[i].name) + " of triangle strips was left out");
    return Done{};
  }

  static void copy_indices(const Column& column, std::vector<std::uint32_t>& indices) {
    indices.resize(column.values.size() / sizeof(std::uint32_t));
    if (!indices.empty()) std::memcpy(indices.data(), column.values.data(), column.values.size());
  }

  void note(std::string line) { note_line(notes_, std::move(line)); }

  Header header_;
  Mesh mesh_;
  Notes notes_;
  std::vector<std::uint32_t> face_sizes_;
};

}  // namespace

Expected<ReadResult> read_ply(std::string_view file) {
  Expected<Header> header = read_header(file);
  if (!header) return Failure<Error>{header.error()};
  return Reader(std::move(*header)).read(file);
}

}  // namespace clers::io
