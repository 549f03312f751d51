// Meshes to measure with: files and folders read into plain triangles.
#ifndef CLERS_BENCH_INPUT_H
#define CLERS_BENCH_INPUT_H

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "codec/io/io.h"
#include "codec/mesh.h"

namespace clers::bench {

/// A mesh file. Polygons, further attributes and doubles, which the rivals do not know, are in it
/// alone.
struct InputFile {
  std::vector<std::byte> bytes;  ///< unpacked
  io::Format format = io::Format::ply;
  std::vector<Mesh> meshes;
};

/// A mesh as the codecs get it: triangles with float positions and nothing else. Polygons are
/// fanned from their first corner, the meshes of a file are put together, vertices that no triangle
/// uses are left out.
struct Input {
  std::string name;    ///< file name without extension
  std::string family;  ///< class of the mesh: the first word of the name, less "many-"
  std::uint32_t vertex_count = 0;
  std::vector<std::uint32_t> triangles;  ///< 3 for each triangle
  std::vector<float> positions;          ///< 3 for each vertex
  Mesh mesh;                             ///< the same for clers
  bool fanned = false;                   ///< polygons were cut into triangles
  bool manifold = false;  ///< an oriented manifold: Edgebreaker needs neither cut nor drop a face
  InputFile file;         ///< what it was read from

  std::size_t triangle_count() const { return triangles.size() / 3; }
  /// Does the file hold values of corners?
  bool has_corner_values() const;
};

/// Makes an input of triangles. What only a file tells stays unset, and so does `manifold`.
Input make_input(std::string name, std::uint32_t vertex_count, std::vector<std::uint32_t> triangles,
                 std::vector<float> positions);

/// Reads a mesh file, gzipped or not. Throws std::runtime_error with the reason.
Input read_input(const std::filesystem::path& file);

/// The mesh files named by `arguments`: files as they are, folders by what is in them, sorted.
std::vector<std::filesystem::path> list_files(const std::vector<std::string>& arguments);

/// Is every edge used at most once in either direction, every vertex the centre of one fan, and no
/// vertex twice in a triangle?
bool is_oriented_manifold(std::uint32_t vertex_count, const std::vector<std::uint32_t>& triangles);

}  // namespace clers::bench

#endif
