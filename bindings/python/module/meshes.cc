// Arrays keep their memory in both directions.
#include "meshes.h"

#include <utility>

namespace clers::python {

Domain domain_of(const std::string& word) {
  for (unsigned d = 0; d < domain_count; ++d)
    if (word == name(static_cast<Domain>(d))) return static_cast<Domain>(d);
  throw py::value_error("domain '" + word + "', expected vertex, corner or face");
}

Views::Views(const py::sequence& meshes) {
  for (const py::handle mesh : meshes) views_.push_back(view_of(py::cast<py::tuple>(mesh)));
}

AttributeView Views::attribute_of(const py::tuple& attribute) {
  AttributeView view;
  view.name = names_.emplace_back(py::cast<std::string>(attribute[0]));
  view.domain = domain_of(py::cast<std::string>(attribute[1]));
  const auto values = py::cast<py::array>(attribute[2]);
  kept_.push_back(values);
  view.scalar = scalar_of(values);
  const auto rows = static_cast<std::size_t>(values.shape(0));
  const std::size_t columns = values.ndim() == 1 ? 1 : static_cast<std::size_t>(values.shape(1));
  if (columns < 1 || columns > 255)
    throw py::value_error("attribute '" + std::string(view.name) + "' has " +
                          std::to_string(columns) + " components, expected 1 to 255");
  view.components = static_cast<std::uint8_t>(columns);
  const auto stride = static_cast<std::size_t>(values.strides(0));
  const bool packed = rows <= 1 || stride == view.value_size();
  if (!packed) view.stride = stride;
  if (rows > 0)
    view.data = {static_cast<const std::byte*>(values.data()),
                 (rows - 1) * view.step() + view.value_size()};
  if (!attribute[3].is_none()) {
    const auto indices = py::cast<py::array>(attribute[3]);
    kept_.push_back(indices);
    view.indices = elements_of<std::uint32_t>(indices);
  }
  return view;
}

MeshView Views::view_of(const py::tuple& mesh) {
  MeshView view;
  view.vertex_count = py::cast<std::uint32_t>(mesh[0]);
  const auto corners = py::cast<py::array>(mesh[1]);
  kept_.push_back(corners);
  if (corners.itemsize() == 2)
    view.corners_16 = elements_of<std::uint16_t>(corners);
  else
    view.corners = elements_of<std::uint32_t>(corners);
  if (!mesh[2].is_none()) {
    const auto sizes = py::cast<py::array>(mesh[2]);
    kept_.push_back(sizes);
    view.face_sizes = elements_of<std::uint32_t>(sizes);
  }
  auto& attributes = attributes_.emplace_back();
  for (const py::handle a : py::cast<py::sequence>(mesh[3]))
    attributes.push_back(attribute_of(py::cast<py::tuple>(a)));
  view.attributes = AttributeViews(attributes);
  view.name = names_.emplace_back(py::cast<std::string>(mesh[4]));
  auto& metadata = metadata_.emplace_back();
  for (const py::handle entry : py::cast<py::sequence>(mesh[5])) {
    const auto pair = py::cast<py::tuple>(entry);
    metadata.push_back({py::cast<std::string>(pair[0]), py::cast<std::string>(pair[1])});
  }
  view.metadata = metadata;
  return view;
}

Mesh mesh_of(const MeshView& view) {
  Mesh mesh;
  mesh.vertex_count = view.vertex_count;
  mesh.corners.assign(view.corners.begin(), view.corners.end());
  mesh.corners.insert(mesh.corners.end(), view.corners_16.begin(), view.corners_16.end());
  mesh.face_sizes.assign(view.face_sizes.begin(), view.face_sizes.end());
  for (const AttributeView a : view.attributes) {
    Attribute own{std::string(a.name), a.domain, a.scalar, a.components, {}};
    const std::size_t size = a.value_size();
    own.data.reserve(a.value_count() * size);
    for (std::size_t i = 0; i < a.value_count(); ++i)
      own.data.insert(own.data.end(), a.value(i), a.value(i) + size);
    own.indices.assign(a.indices.begin(), a.indices.end());
    mesh.attributes.push_back(std::move(own));
  }
  mesh.name = view.name;
  mesh.metadata.assign(view.metadata.begin(), view.metadata.end());
  return mesh;
}

py::tuple tuple_of(Mesh mesh) {
  py::list attributes, metadata;
  for (Attribute& a : mesh.attributes) {
    py::object indices = py::none();
    if (!a.indices.empty()) indices = array_of(std::move(a.indices));
    attributes.append(py::make_tuple(a.name, name(a.domain),
                                     array_of(std::move(a.data), dtype_of(a.scalar), a.components),
                                     indices));
  }
  for (const MetadataEntry& entry : mesh.metadata)
    metadata.append(py::make_tuple(entry.key, py::bytes(entry.value)));
  py::object sizes = py::none();
  if (!mesh.face_sizes.empty()) sizes = array_of(std::move(mesh.face_sizes));
  return py::make_tuple(mesh.vertex_count, array_of(std::move(mesh.corners)), sizes, attributes,
                        mesh.name, metadata);
}

py::tuple tuple_of(Permutation order) {
  return py::make_tuple(array_of(std::move(order.vertices)), array_of(std::move(order.faces)),
                        array_of(std::move(order.first_corners)));
}

}  // namespace clers::python
