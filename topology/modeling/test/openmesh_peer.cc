#include "topology/modeling/test/openmesh_peer.h"

#include <time.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/Sqrt3T.hh>

namespace clers::test {
namespace {

using PeerMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

template <class Subdivider>
void run(PeerMesh& mesh, unsigned times, double* seconds) {
  Subdivider subdivider;
  subdivider.init_weights(10'000);  // by default only valences below 50 have some
  subdivider.attach(mesh);
  const double start = now();
  subdivider(times);
  if (seconds != nullptr) *seconds = now() - start;
  subdivider.detach();
}

}  // namespace

Plain subdivide_by_openmesh(const Plain& plain, PeerScheme scheme, unsigned times,
                            double* seconds) {
  PeerMesh mesh;
  std::vector<PeerMesh::VertexHandle> vertices;
  for (const auto& p : plain.points)
    vertices.push_back(mesh.add_vertex(PeerMesh::Point(p[0], p[1], p[2])));
  for (const auto& t : plain.triangles)
    mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  if (scheme == PeerScheme::loop)
    run<OpenMesh::Subdivider::Uniform::LoopT<PeerMesh, double>>(mesh, times, seconds);
  else
    run<OpenMesh::Subdivider::Uniform::Sqrt3T<PeerMesh, double>>(mesh, times, seconds);

  Plain out;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    out.points.push_back({p[0], p[1], p[2]});
  }
  for (const auto f : mesh.faces()) {
    std::array<std::uint32_t, 3> t{};
    std::size_t i = 0;
    for (const auto v : mesh.fv_range(f)) t[i++] = static_cast<std::uint32_t>(v.idx());
    out.triangles.push_back(t);
  }
  return out;
}

}  // namespace clers::test
