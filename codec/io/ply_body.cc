// What follows the header of a PLY file, as text or as bytes.
#include <bit>
#include <cstring>

#include "codec/io/formats.h"
#include "codec/io/ply.h"
#include "codec/io/text.h"

namespace clers::io::ply {

namespace {

const char* noun(Scalar scalar) {
  constexpr const char* nouns[scalar_count] = {"an int8",   "a uint8",  "an int16", "a uint16",
                                               "an int32",  "a uint32", "an int64", "a uint64",
                                               "a float32", "a float64"};
  return nouns[static_cast<unsigned>(scalar)];
}

std::string noun_of_index(const Property& p, std::uint32_t vertex_count) {
  return "a vertex index below " + std::to_string(vertex_count) +
         (p.meaning == Meaning::strip_index ? " or -1" : "");
}

// Room for that many more bytes.
std::byte* grow(std::vector<std::byte>& values, std::size_t bytes) {
  values.resize(values.size() + bytes);
  return values.data() + values.size() - bytes;
}

template <class T>
void store(std::vector<std::byte>& values, T value) {
  std::memcpy(grow(values, sizeof value), &value, sizeof value);
}

// An index as stored, or false.
template <class T>
bool as_index(T value, const Property& p, std::uint32_t vertex_count, std::uint32_t& index) {
  index = static_cast<std::uint32_t>(value);
  if (value >= T{0} && static_cast<std::uint64_t>(value) < vertex_count) return true;
  return p.meaning == Meaning::strip_index && value == static_cast<T>(-1) && index == restart;
}

// An element of at least `count` times `least` bytes must fit into what is left.
bool fits(std::uint64_t count, std::uint64_t least, std::uint64_t left) {
  return count == 0 || least == 0 || count <= left / least;
}

std::string too_short(const Element& element, std::uint64_t left) {
  return "expected " + counted(element.count, "entry", "entries") + " of element " +
         quoted(element.name) + ", which " + counted(left, "byte", "bytes") + " cannot hold";
}

// ---- text: values apart by white space, wherever the lines break

class TextBody {
 public:
  TextBody(std::string_view file, std::size_t from, std::uint32_t vertex_count)
      : text_(file), vertex_count_(vertex_count) {
    text_.skip(from);
  }

  std::size_t offset() const { return text_.offset(); }

  Expected<Done> read(const Element& element, std::vector<Column>& columns) {
    text_.skip_space();
    // A digit and a space for each value; the last needs no space.
    if (!fits(element.count, 2 * element.properties.size(), text_.remaining() + 1))
      return text_.malformed(text_.at(), too_short(element, text_.remaining()));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Property& p = element.properties[i];
      if (p.count_type)
        columns[i].sizes.reserve(element.count);
      else
        columns[i].values.reserve(element.count * size_of(p.type));
    }
    for (std::uint64_t entry = 0; entry < element.count; ++entry)
      for (std::size_t i = 0; i < columns.size(); ++i)
        if (!read(element.properties[i], columns[i])) return expected(element, i);
    return Done{};
  }

 private:
  bool read(const Property& p, Column& column) {
    text_.skip_space();
    if (!p.count_type) return value(p, column.values);
    std::uint32_t size = 0;
    in_list_ = false;
    if (!text_.integer(size)) return false;
    in_list_ = true;
    column.sizes.push_back(size);
    for (std::uint32_t i = 0; i < size; ++i) {
      text_.skip_space();
      if (!value(p, column.values)) return false;
    }
    return true;
  }

  bool value(const Property& p, std::vector<std::byte>& values) {
    if (p.meaning != Meaning::value) {
      std::int64_t value = 0;
      std::uint32_t index = 0;
      const Text before = text_;
      if (!text_.integer(value)) return false;
      if (!as_index(value, p, vertex_count_, index)) {
        text_ = before;
        return false;
      }
      store(values, index);
      return true;
    }
    return with_type(p.type, [&]<class T>(T) {
      T value{};
      bool read = false;
      if constexpr (std::is_floating_point_v<T>)
        read = text_.number(value);
      else
        read = text_.integer(value);
      if (read) store(values, value);
      return read;
    });
  }

  Failure<Error> expected(const Element& element, std::size_t property) {
    const Property& p = element.properties[property];
    if (p.count_type && !in_list_) return text_.expected("the length of list " + quoted(p.name));
    if (p.meaning != Meaning::value) return text_.expected(noun_of_index(p, vertex_count_));
    return text_.expected(std::string(noun(p.type)) + " for property " + quoted(p.name));
  }

  Text text_;
  std::uint32_t vertex_count_;
  bool in_list_ = false;  // whether the length of the last list was read
};

// ---- binary

template <class T>
T load(const char* from, bool swap) {
  char bytes[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes[i] = from[swap ? sizeof(T) - 1 - i : i];
  return std::bit_cast<T>(bytes);
}

class BinaryBody {
 public:
  BinaryBody(std::string_view file, std::size_t from, std::uint32_t vertex_count, bool swap)
      : file_(file), at_(from), vertex_count_(vertex_count), swap_(swap) {}

  std::size_t offset() const { return at_; }

  Expected<Done> read(const Element& element, std::vector<Column>& columns) {
    std::size_t least = 0;
    bool lists = false;
    for (const Property& p : element.properties) {
      least += size_of(p.count_type.value_or(p.type));
      lists = lists || p.count_type;
    }
    if (!fits(element.count, least, left())) return malformed(at_, too_short(element, left()));
    if (!lists) {
      read_table(element, least, columns);
      return Done{};
    }
    for (std::size_t i = 0; i < columns.size(); ++i)
      if (element.properties[i].count_type)
        columns[i].sizes.reserve(element.count);
      else
        columns[i].values.reserve(element.count * size_of(element.properties[i].type));
    for (std::uint64_t entry = 0; entry < element.count; ++entry) {
      for (std::size_t i = 0; i < columns.size(); ++i) {
        const Property& p = element.properties[i];
        Expected<Done> done = p.count_type ? list(p, columns[i]) : scalar(p, columns[i]);
        if (!done) return done;
      }
    }
    return Done{};
  }

 private:
  std::size_t left() const { return file_.size() - at_; }
  const char* here() const { return file_.data() + at_; }

  void read_table(const Element& element, std::size_t stride, std::vector<Column>& columns) {
    std::size_t offset = at_;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const Scalar type = element.properties[i].type;
      columns[i].values.resize(element.count * size_of(type));
      with_type(type, [&]<class T>(T) {
        const char* from = file_.data() + offset;
        std::byte* to = columns[i].values.data();
        for (std::uint64_t entry = 0; entry < element.count; ++entry) {
          const T value = load<T>(from + entry * stride, swap_);
          std::memcpy(to + entry * sizeof value, &value, sizeof value);
        }
      });
      offset += size_of(type);
    }
    at_ += element.count * stride;
  }

  Expected<Done> scalar(const Property& p, Column& column) {
    if (left() < size_of(p.type))
      return malformed(at_, "expected " + std::string(noun(p.type)) + " for property " +
                                quoted(p.name) + ", found the end of the file");
    with_type(p.type, [&]<class T>(T) { store(column.values, load<T>(here(), swap_)); });
    at_ += size_of(p.type);
    return Done{};
  }

  Expected<Done> list(const Property& p, Column& column) {
    if (left() < size_of(*p.count_type))
      return malformed(
          at_, "expected the length of list " + quoted(p.name) + ", found the end of the file");
    const auto size = with_type(*p.count_type, [&]<class T>(T) {
      return static_cast<std::int64_t>(load<T>(here(), swap_));
    });
    const std::size_t bytes_left = left() - size_of(*p.count_type);
    if (size < 0 || static_cast<std::uint64_t>(size) > bytes_left / size_of(p.type))
      return malformed(at_, "expected the length of list " + quoted(p.name) + " that " +
                                counted(bytes_left, "byte", "bytes") + " can hold, found " +
                                std::to_string(size));
    at_ += size_of(*p.count_type);
    column.sizes.push_back(static_cast<std::uint32_t>(size));
    return with_type(
        p.type, [&]<class T>(T) { return values<T>(p, column, static_cast<std::size_t>(size)); });
  }

  template <class T>
  Expected<Done> values(const Property& p, Column& column, std::size_t size) {
    if (p.meaning == Meaning::value) {
      std::byte* to = grow(column.values, size * sizeof(T));
      for (std::size_t i = 0; i < size; ++i, at_ += sizeof(T), to += sizeof(T)) {
        const T value = load<T>(here(), swap_);
        std::memcpy(to, &value, sizeof value);
      }
      return Done{};
    }
    std::byte* to = grow(column.values, size * sizeof(std::uint32_t));
    for (std::size_t i = 0; i < size; ++i, at_ += sizeof(T), to += sizeof(std::uint32_t)) {
      const T value = load<T>(here(), swap_);
      std::uint32_t index = 0;
      if (!as_index(value, p, vertex_count_, index))
        return malformed(at_, "expected " + noun_of_index(p, vertex_count_) + ", found " +
                                  std::to_string(value));
      std::memcpy(to, &index, sizeof index);
    }
    return Done{};
  }

  static Failure<Error> malformed(std::size_t byte, std::string what) {
    return fail(ErrorCode::malformed, Place::byte, byte, std::move(what));
  }

  std::string_view file_;
  std::size_t at_;
  std::uint32_t vertex_count_;
  bool swap_;
};

}  // namespace

Expected<std::vector<Column>> Body::next(const Element& element) {
  std::vector<Column> columns(element.properties.size());
  const auto read_with = [&](auto body) -> Expected<std::vector<Column>> {
    if (Expected<Done> done = body.read(element, columns); !done)
      return Failure<Error>{done.error()};
    at_ = body.offset();
    return std::move(columns);
  };
  if (format_ == Format::text) return read_with(TextBody(file_, at_, vertex_count_));
  const bool big = format_ == Format::big_endian;
  return read_with(
      BinaryBody(file_, at_, vertex_count_, big != (std::endian::native == std::endian::big)));
}

Expected<Done> Body::end(Notes& notes) const {
  const std::string_view rest = file_.substr(at_);
  if (format_ == Format::text) {
    Text text(file_);
    text.skip(at_);
    if (!text.at_end()) return text.expected("the end of the file after the last element");
  } else if (!rest.empty()) {
    note_left_out(notes, rest.size(), "byte", "bytes", "after the last element");
  }
  return Done{};
}

}  // namespace clers::io::ply
