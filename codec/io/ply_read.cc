// Reads PLY.
#include <algorithm>
#include <cstring>
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
  return with_type(scalar, [&](auto value) {
    std::memcpy(&value, from, sizeof value);
    return static_cast<To>(value);
  });
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

// How many values each corner has in a list; 0 if the lists do not follow the faces. Where there
// are no corners it is any number. A list may be empty: its corners have no values.
std::size_t values_per_corner(const Column& lists, const std::vector<std::uint32_t>& face_sizes,
                              std::size_t any) {
  std::size_t k = none;
  for (std::size_t f = 0; f < face_sizes.size(); ++f) {
    if (lists.sizes[f] == 0) continue;
    if (k == none && face_sizes[f] > 0) k = lists.sizes[f] / face_sizes[f];
    if (lists.sizes[f] != (face_sizes[f] > 0 ? k * face_sizes[f] : 0)) return 0;
  }
  if (k == none) return any;
  return k <= 255 ? k : 0;
}

// How long all of the lists are; 0 if they are not of one length from 1 to 255.
std::size_t values_per_entry(const Column& lists) {
  if (lists.sizes.empty()) return 1;
  const std::uint32_t size = lists.sizes[0];
  const bool one = std::all_of(lists.sizes.begin(), lists.sizes.end(),
                               [&](std::uint32_t n) { return n == size; });
  return one && size <= 255 ? size : 0;
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
        attributes(element, *columns);
      else if (element.name == "face")
        done = faces(element, *columns);
      else if (element.name == "tristrips")
        done = strips(element, *columns);
      else if (element.count > 0 && elements_.insert(element.name).second)
        entries_ += element.count;
      if (!done) return Failure<Error>{done.error()};
    }
    if (Expected<Done> done = body.end(notes_); !done) return Failure<Error>{done.error()};
    note_left_out(
        notes_, elements_.size(), "element", "elements",
        "not part of a mesh: " + some(elements_) + ", of " + counted(entries_, "entry", "entries"));
    note_left_out(notes_, lists_.size(), "list", "lists",
                  "their lengths do not fit the corners, or differ very much: " + some(lists_));
    if (header_.comments.count() > 0) set_metadata(mesh_, comment_key, header_.comments.take());
    if (header_.obj_infos.count() > 0) set_metadata(mesh_, obj_info_key, header_.obj_infos.take());
    if (std::string names = names_.text(); !names.empty())
      set_metadata(mesh_, properties_key, std::move(names));
    set_metadata(mesh_, source_key,
                 header_.format == ply::Format::text            ? "ply ascii"
                 : header_.format == ply::Format::little_endian ? "ply binary_little_endian"
                                                                : "ply binary_big_endian");
    // Vertex attributes first, whichever element came first.
    std::stable_partition(mesh_.attributes.begin(), mesh_.attributes.end(),
                          [](const Attribute& a) { return a.domain == Domain::vertex; });
    ReadResult result;
    result.meshes.push_back(std::move(mesh_));
    result.notes = std::move(notes_);
    return result;
  }

 private:
  // Scalars become attributes of the domain; lists too if they are of one length, and corner
  // attributes if they are known to be that.
  void attributes(const Element& element, std::vector<Column>& columns) {
    for (Entry& entry : plan(element)) {
      const std::size_t first = entry.members[0];
      const Property& p = element.properties[first];
      Attribute a;
      if (!p.count_type) {
        const bool mixed =
            std::any_of(entry.members.begin(), entry.members.end(),
                        [&](std::size_t i) { return element.properties[i].type != p.type; });
        a = interleaved(entry.attribute, entry.domain, entry.members, element, columns);
        if (mixed) note_remark(notes_, 1, label(a), "comes from properties of several types");
      } else {
        const std::size_t any = std::max(1u, entry.claimed);
        const std::size_t components = entry.domain == Domain::corner
                                           ? values_per_corner(columns[first], face_sizes_, any)
                                           : values_per_entry(columns[first]);
        if (components == 0 || (entry.claimed == 0 && entry.domain == Domain::corner &&
                                components != 2 && components != 3 && components != 4)) {
          if (entry.domain == Domain::corner || !lists_of_lengths(entry, p, columns[first]))
            lists_.insert(p.name);
          continue;
        }
        a = {entry.attribute, entry.domain, p.type, static_cast<std::uint8_t>(components),
             std::move(columns[first].values)};
        if (entry.domain == Domain::corner) a.indices = indices_of_lists(columns[first].sizes);
      }
      remember_names(element, entry, a);
      mesh_.attributes.push_back(std::move(a));
    }
  }

  // Number i of all lists is an attribute, which those that are shorter have no value of. False if
  // that might take much more memory than the file.
  bool lists_of_lengths(const Entry& entry, const Property& p, const Column& lists) {
    const std::size_t count = lists.sizes.size(), size = size_of(p.type);
    const std::uint32_t longest = *std::max_element(lists.sizes.begin(), lists.sizes.end());
    if (longest == 0 || longest > 255 || count * longest > 16 * (count + lists.values.size()))
      return false;
    const std::size_t first = mesh_.attributes.size();
    for (std::uint32_t i = 0; i < longest; ++i) {
      Attribute a{part_of_lists(entry.attribute, i), entry.domain, p.type, 1, {}};
      if (a.name.size() > 255) return mesh_.attributes.resize(first), false;
      a.indices.assign(count, no_value);
      mesh_.attributes.push_back(std::move(a));
    }
    const std::byte* from = lists.values.data();
    for (std::size_t e = 0; e < count; ++e)
      for (std::uint32_t i = 0; i < lists.sizes[e]; ++i, from += size) {
        Attribute& a = mesh_.attributes[first + i];
        a.indices[e] = static_cast<std::uint32_t>(a.value_count());
        a.data.insert(a.data.end(), from, from + size);
      }
    for (std::size_t i = first; i < mesh_.attributes.size(); ++i)
      if (Attribute& a = mesh_.attributes[i]; a.value_count() == count) a.indices = {};
    names_.add({entry.domain,
                PropertyNames::Form::lists,
                entry.attribute,
                {p.name, std::to_string(longest)}});
    return true;
  }

  // Which value each corner has, if those of some faces have none.
  std::vector<std::uint32_t> indices_of_lists(std::span<const std::uint32_t> sizes) const {
    std::vector<std::uint32_t> indices;
    std::uint32_t value = 0;
    bool all = true;
    for (std::size_t f = 0; f < sizes.size(); ++f) all &= sizes[f] > 0 || face_sizes_[f] == 0;
    if (all) return indices;
    for (std::size_t f = 0; f < sizes.size(); ++f)
      for (std::uint32_t i = 0; i < face_sizes_[f]; ++i)
        indices.push_back(sizes[f] == 0 ? no_value : value++);
    return indices;
  }

  // Unless they are what a writer would call them anyway.
  void remember_names(const Element& element, const Entry& entry, const Attribute& a) {
    PropertyNames::Line line{a.domain,
                             element.properties[entry.members[0]].count_type
                                 ? PropertyNames::Form::list
                                 : PropertyNames::Form::scalars,
                             a.name,
                             {}};
    for (const std::size_t i : entry.members) line.properties.push_back(element.properties[i].name);
    const Convention* convention = convention_of(a.name, a.components);
    const bool list_of_entries =
        line.form == PropertyNames::Form::list && a.domain != Domain::corner;
    const bool usual = !list_of_entries &&
                       (entry.claimed > 0 ||
                        (convention && a.domain != Domain::corner
                             ? std::equal(line.properties.begin(), line.properties.end(),
                                          convention->names().begin(), convention->names().end())
                             : line.properties.size() == 1 && line.properties[0] == a.name));
    if (!usual) names_.add(std::move(line));
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
    if (indices != none && element.properties[indices].name != usual_indices)
      names_.indices = element.properties[indices].name;
    attributes(element, columns);
    set_face_sizes(mesh_, std::move(face_sizes_));
    return Done{};
  }

  // Vertices a b c d e ... of a strip are the faces abc, cbd, cde, ...: each but the first shares
  // an edge with the one before, and every second one is reversed to face the same way. A repeated
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
    note_remark(notes_, element.count, counted(element.count, "triangle strip", "triangle strips"),
                "became " + counted(mesh_.corners.size() / 3, "face", "faces"));
    if (joins)
      note_remark(notes_, joins, counted(joins, "place", "places"),
                  "of a strip that repeat a vertex became no face");
    std::set<std::string> others;
    for (std::size_t i = 0; i < element.properties.size(); ++i)
      if (i != property) others.insert(element.properties[i].name);
    note_left_out(notes_, others.size(), "property of triangle strips",
                  "properties of triangle strips", some(others));
    return Done{};
  }

  static void copy_indices(const Column& column, std::vector<std::uint32_t>& indices) {
    indices.resize(column.values.size() / sizeof(std::uint32_t));
    if (!indices.empty()) std::memcpy(indices.data(), column.values.data(), column.values.size());
  }

  Header header_;
  Mesh mesh_;
  Notes notes_;
  PropertyNames names_;
  std::set<std::string> elements_, lists_;  // left out
  std::uint64_t entries_ = 0;               // of these elements
  std::vector<std::uint32_t> face_sizes_;
};

}  // namespace

Expected<ReadResult> read_ply(std::string_view file) {
  Expected<Header> header = read_header(file);
  if (!header) return Failure<Error>{header.error()};
  return Reader(std::move(*header)).read(file);
}

}  // namespace clers::io
