// Draco has points, of which faces are made, and each attribute says which value a point has:
//
//     face         attribute "position"   attribute "texcoord"
//     (0, 1, 2)    0 1 2 0                 0 1 2 3              <- by point
//     (2, 1, 3)
//
// Points 0 and 3 are one vertex here, that a seam parts.
#include "codec/draco/mesh_of.h"

#include <cstring>
#include <set>
#include <utility>
#include <vector>

#include "codec/base/utf8.h"

namespace clers::draco {
namespace {

Scalar scalar_of(::draco::DataType type) {
  switch (type) {
    case ::draco::DT_INT8: return Scalar::int8;
    case ::draco::DT_INT16: return Scalar::int16;
    case ::draco::DT_UINT16: return Scalar::uint16;
    case ::draco::DT_INT32: return Scalar::int32;
    case ::draco::DT_UINT32: return Scalar::uint32;
    case ::draco::DT_INT64: return Scalar::int64;
    case ::draco::DT_UINT64: return Scalar::uint64;
    case ::draco::DT_FLOAT32: return Scalar::float32;
    case ::draco::DT_FLOAT64: return Scalar::float64;
    default: return Scalar::uint8;  // and DT_BOOL
  }
}

Attribute kind_of(const ::draco::PointAttribute& from, std::string name) {
  Attribute a;
  a.name = std::move(name);
  a.scalar = scalar_of(from.data_type());
  a.components = from.num_components();
  return a;
}

void append_value(const ::draco::PointAttribute& from, std::uint32_t value, Attribute& a) {
  const std::size_t at = a.data.size();
  a.data.resize(at + a.stride());
  std::memcpy(a.data.data() + at, from.GetAddress(::draco::AttributeValueIndex(value)), a.stride());
}

class Builder {
 public:
  explicit Builder(const Decoded& decoded)
      : points_(*decoded.points), mesh_(decoded.mesh), count_(points_.num_points()) {
    if (mesh_ == nullptr) return;
    corners_.reserve(std::size_t(3) * mesh_->num_faces());
    for (::draco::FaceIndex f(0); f < mesh_->num_faces(); ++f)
      for (const ::draco::PointIndex& p : mesh_->face(f)) corners_.push_back(p.value());
  }

  Mesh points() {
    Mesh mesh;
    mesh.vertex_count = count_;
    for (std::int32_t i = 0; i < points_.num_attributes(); ++i) {
      const ::draco::PointAttribute& from = *points_.attribute(i);
      Attribute a = kind_of(from, std::to_string(from.unique_id()));
      by_point(from, a);
      mesh.attributes.push_back(std::move(a));
    }
    mesh.corners = std::move(corners_);
    return mesh;
  }

  Mesh surface() {
    Mesh mesh;
    choose_vertices();
    mesh.vertex_count = vertices_;
    std::set<std::string> taken;
    for (std::int32_t i = 0; i < points_.num_attributes(); ++i) {
      const ::draco::PointAttribute& from = *points_.attribute(i);
      Attribute a = kind_of(from, name_of(from, taken));
      if (a.name == position_name && &from == position_ && !as_points_)
        all_values(from, a);
      else if (a.name == position_name)
        by_point(from, a);
      else
        by_index(from, a);
      mesh.attributes.push_back(std::move(a));
    }
    for (const std::uint32_t p : corners_) mesh.corners.push_back(vertex_of(p));
    return mesh;
  }

 private:
  static std::uint32_t value_at(const ::draco::PointAttribute& a, std::uint32_t point) {
    return a.mapped_index(::draco::PointIndex(point)).value();
  }
  static void all_values(const ::draco::PointAttribute& from, Attribute& a) {
    for (std::uint32_t v = 0; v < from.size(); ++v) append_value(from, v, a);
  }
  void by_point(const ::draco::PointAttribute& from, Attribute& a) const {
    for (std::uint32_t p = 0; p < count_; ++p) append_value(from, value_at(from, p), a);
  }

  std::uint32_t vertex_of(std::uint32_t point) const {
    return as_points_ ? point : value_at(*position_, point);
  }

  /// Positions are vertices, unless nothing is shared.
  void choose_vertices() {
    position_ = points_.GetNamedAttribute(::draco::GeometryAttribute::POSITION);
    as_points_ = mesh_ == nullptr || position_ == nullptr || position_->is_mapping_identity();
    vertices_ = as_points_ ? count_ : static_cast<std::uint32_t>(position_->size());
  }

  /// Which value each vertex has; false if it has several.
  bool by_vertex(const ::draco::PointAttribute& from, std::vector<std::uint32_t>& values) const {
    values.assign(vertices_, no_value);
    for (std::uint32_t p = 0; p < count_; ++p) {
      std::uint32_t& value = values[vertex_of(p)];
      if (value != no_value && value != value_at(from, p)) return false;
      value = value_at(from, p);
    }
    return true;
  }
  /// Is a value the same at all corners of each face? Draco has it three times there.
  bool is_of_faces(const ::draco::PointAttribute& from, std::size_t size) const {
    const auto value = [&](std::size_t corner) {
      return from.GetAddress(::draco::AttributeValueIndex(value_at(from, corners_[corner])));
    };
    for (std::size_t c = 0; c < corners_.size(); c += 3)
      for (std::size_t k = 1; k < 3; ++k)
        if (std::memcmp(value(c), value(c + k), size) != 0) return false;
    return true;
  }

  void by_index(const ::draco::PointAttribute& from, Attribute& a) const {
    const bool generic = from.attribute_type() == ::draco::GeometryAttribute::GENERIC;
    if (!by_vertex(from, a.indices)) {
      a.indices.clear();
      if (generic && is_of_faces(from, a.stride())) {
        a.domain = Domain::face;
        for (std::size_t c = 0; c < corners_.size(); c += 3)
          append_value(from, value_at(from, corners_[c]), a);
        return;
      }
      a.domain = Domain::corner;
      for (const std::uint32_t p : corners_) a.indices.push_back(value_at(from, p));
    }
    all_values(from, a);
    bool in_turn = a.indices.size() == from.size();
    for (std::size_t i = 0; i < a.indices.size() && in_turn; ++i) in_turn = a.indices[i] == i;
    if (in_turn) a.indices.clear();
  }

  /// A name that no other attribute has.
  std::string name_of(const ::draco::PointAttribute& a, std::set<std::string>& taken) const {
    std::string name = plain_name(a);
    for (int i = 1; !taken.insert(name).second; ++i) name = plain_name(a) + "." + std::to_string(i);
    return name;
  }
  std::string plain_name(const ::draco::PointAttribute& a) const {
    switch (a.attribute_type()) {
      case ::draco::GeometryAttribute::POSITION: return position_name;
      case ::draco::GeometryAttribute::NORMAL: return "normal";
      case ::draco::GeometryAttribute::COLOR: return "color";
      case ::draco::GeometryAttribute::TEX_COORD: return "texcoord";
      default: break;
    }
    const ::draco::GeometryMetadata* all = points_.GetMetadata();
    const ::draco::AttributeMetadata* said =
        all == nullptr
            ? nullptr
            : all->GetAttributeMetadataByUniqueId(static_cast<std::int32_t>(a.unique_id()));
    std::string name;
    const bool good = said != nullptr && said->GetEntryString("name", &name) && !name.empty() &&
                      name.size() < 240 && name != position_name && internal::is_utf8(name);
    return good ? name : "generic";
  }

  const ::draco::PointCloud& points_;
  const ::draco::Mesh* mesh_;
  std::uint32_t count_;                 ///< of points
  std::vector<std::uint32_t> corners_;  ///< points
  const ::draco::PointAttribute* position_ = nullptr;
  bool as_points_ = true;
  std::uint32_t vertices_ = 0;
};

}  // namespace

Mesh points_of(const Decoded& decoded) {
  return Builder(decoded).points();
}

Mesh surface_of(const Decoded& decoded) {
  return Builder(decoded).surface();
}

}  // namespace clers::draco
