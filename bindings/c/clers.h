// clers from C: meshes compressed without loss, unless less is asked for. C99 and C++.
//
//     clers_attribute position = {sizeof position, "position"};
//     position.scalar = CLERS_FLOAT32;
//     position.components = 3;
//     position.data = places;
//     position.data_size = sizeof places;
//     clers_mesh mesh = {sizeof mesh};
//     mesh.vertex_count = vertices;
//     mesh.corners = indices;
//     mesh.corner_count = 3 * triangles;
//     mesh.attributes = &position;
//     mesh.attribute_count = 1;
//     size_t size = clers_bound(&mesh, 1, NULL);
//     void* bytes = malloc(size);
//     clers_error error = {sizeof error};
//     if (clers_encode(&mesh, 1, NULL, bytes, size, &size, &error)) puts(error.text);
//
// Structs. Each begins with its size, which the caller sets; 0 in any other field is the default.
// A later version may add fields at the end: a program that was compiled before it goes on as it
// was, and one that sets fields which a library does not know yet gets CLERS_BAD_OPTION. In an
// array of structs all have the same size.
//
// Errors are values: what can fail returns a clers_code, CLERS_OK (0) or why not, and says more in
// `error`, which may be NULL. Nothing prints, aborts or keeps globals; running out of memory is an
// error too.
//
// Threads: all functions may run at the same time, also on one clers_decoder, but for clers_close.
// All memory is the caller's: it is used during the call alone, but for the bytes of a decoder.
//
// Names and texts are UTF-8 and end with a 0. Values and indices have the machine's byte order.
// Not here: metadata, scenes and files of other formats (C++: <clers/scene.h>, <clers/io.h>).
#ifndef CLERS_H
#define CLERS_H

#include <stddef.h>
#include <stdint.h>

#if defined(_WIN32) && defined(CLERS_C_STATIC)
#define CLERS_C_API
#elif defined(_WIN32) && defined(CLERS_C_BUILD)
#define CLERS_C_API __declspec(dllexport)
#elif defined(_WIN32)
#define CLERS_C_API __declspec(dllimport)
#elif defined(__GNUC__)
#define CLERS_C_API __attribute__((visibility("default")))
#else
#define CLERS_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// The version of the library that runs: "0.1.0".
CLERS_C_API const char* clers_version(void);

// ---- Errors

/// Why something failed. The numbers never change.
typedef int32_t clers_code;
enum {
  CLERS_OK = 0,
  // The mesh cannot be coded.
  CLERS_INCONSISTENT_MESH = 1,   ///< sizes of the arrays disagree, or an index is out of range
  CLERS_DUPLICATE_FACE = 2,      ///< a face on the same vertices as another
  CLERS_DEGENERATE_FACE = 3,     ///< a face that uses a vertex twice, or has fewer than 3 corners
  CLERS_NONMANIFOLD_EDGE = 4,    ///< an edge of more than two faces
  CLERS_NONMANIFOLD_VERTEX = 5,  ///< a vertex whose faces form more than one fan
  CLERS_NONORIENTABLE = 6,       ///< an edge that two faces run along the same way
  CLERS_TOO_LARGE = 7,           ///< more elements than ids
  CLERS_BAD_OPTION = 8,          ///< an option out of its range, memory of another size than is
                                 ///< needed, an index of what is not there, NULL for what is needed
  CLERS_NOT_ON_GRID = 9,         ///< a value that no point of a grid is near: NaN, an infinity
  // The bytes cannot be decoded.
  CLERS_NOT_CLERS = 20,            ///< the magic number is missing
  CLERS_UNSUPPORTED_VERSION = 21,  ///< made by another version of the format
  CLERS_TRUNCATED = 22,            ///< the bytes end too early
  CLERS_TRAILING_BYTES = 23,       ///< bytes after the end
  CLERS_CORRUPT = 24,              ///< a checksum does not match
  CLERS_INVALID = 25,              ///< a rule of the format is broken
  // A limit.
  CLERS_LIMIT = 40,             ///< the caller's limits do not allow this input
  CLERS_OUT_OF_MEMORY = 41,     ///< allocation failed
  CLERS_UNSUPPORTED = 62,       ///< a feature of a mesh that is not supported here
  CLERS_BUFFER_TOO_SMALL = 80,  ///< memory for bytes is too small; clers_error::needed would do
  CLERS_INTERNAL = 99           ///< a fault of this library
};

/// What clers_error::at counts.
enum {
  CLERS_AT_NOWHERE = 0,
  CLERS_AT_BYTE = 1,
  CLERS_AT_LINE = 2,
  CLERS_AT_FACE = 3,
  CLERS_AT_VERTEX = 4,
  CLERS_AT_EDGE = 5,
  CLERS_AT_MESH = 6,
  CLERS_AT_SYMBOL = 7,
  CLERS_AT_CORNER = 8
};

/// Which limit of clers_decode_options does not allow an input.
enum {
  CLERS_LIMITED_BY_NOTHING = 0,
  CLERS_LIMITED_BY_MESHES = 1,
  CLERS_LIMITED_BY_VERTICES = 2,
  CLERS_LIMITED_BY_FACES = 3,
  CLERS_LIMITED_BY_MEMORY = 4
};

typedef struct clers_error {
  size_t size;      ///< sizeof(clers_error)
  clers_code code;  ///< what the function returned; the rest is out too
  int32_t place;    ///< CLERS_AT_..: what `at` counts
  uint64_t at;      ///< offset of a byte, or index of an element, from 0
  int32_t limited;  ///< of CLERS_LIMIT: CLERS_LIMITED_BY_.., which limit to raise
  uint64_t needed;  ///< .. and to what at least; of CLERS_BUFFER_TOO_SMALL: bytes
  char text[512];   ///< a line for people: "face 17: has vertex 9, expected one below 9"; "" if
                    ///< CLERS_OK; cut where it is longer
} clers_error;

/// The name of a code in small letters: "invalid", "ok"; "unknown" for other numbers.
CLERS_C_API const char* clers_code_name(clers_code code);

// ---- Meshes

/// In clers_attribute::indices: an element without a value. In clers_target::opposites: a half-edge
/// without one. For clers_encode_options::piece_faces: never in pieces.
#define CLERS_NONE 0xffffffffu

/// What an attribute has one value for.
enum { CLERS_VERTEX = 0, CLERS_CORNER = 1, CLERS_FACE = 2 };

/// How one component of a value is stored.
enum {
  CLERS_INT8 = 0,
  CLERS_UINT8 = 1,
  CLERS_INT16 = 2,
  CLERS_UINT16 = 3,
  CLERS_INT32 = 4,
  CLERS_UINT32 = 5,
  CLERS_INT64 = 6,
  CLERS_UINT64 = 7,
  CLERS_FLOAT32 = 8,
  CLERS_FLOAT64 = 9
};

/// How exactly the values of an attribute come back. By how much they were moved at most is in the
/// file: clers_attribute_info::error.
enum {
  CLERS_LOSSLESS = 0,
  CLERS_BITS = 1,        ///< a grid of 2^bits points along the longest side of the bounding box
  CLERS_STEP = 2,        ///< multiples of `amount`: the same grid for all meshes
  CLERS_ERROR = 3,       ///< no component is off by more than `amount`
  CLERS_GRID = 4,        ///< `origin` + k * `amount`: tiles that share it share their border
  CLERS_DIRECTIONS = 5,  ///< three floats, as one of about 4^bits directions of length 1
  CLERS_RECOMPUTED = 6   ///< directions that follow from positions and faces, where these are no
                         ///< more than `amount` degrees away; else others within that
};

/// Values of the vertices, corners or faces of a mesh, each of `components` scalars. The vertex
/// attribute "position" is that by which others are predicted.
typedef struct clers_attribute {
  size_t size;              ///< sizeof(clers_attribute)
  const char* name;         ///< at most 255 bytes; NULL: none
  int32_t domain;           ///< CLERS_VERTEX, CLERS_CORNER or CLERS_FACE
  int32_t scalar;           ///< CLERS_INT8 .. CLERS_FLOAT64
  uint32_t components;      ///< 1 to 255
  const void* data;         ///< the first value
  size_t data_size;         ///< bytes from there to the end of the last value, or of its stride
  size_t stride;            ///< bytes from one value to the next; 0: packed
  const uint32_t* indices;  ///< NULL: one value an element, in their order. Else which value each
                            ///< element has (not for positions); CLERS_NONE: none
  int32_t precision;        ///< CLERS_LOSSLESS ..; the same for all attributes of this name and
                            ///< domain in a file
  int32_t bits;             ///< CLERS_BITS: 1 to 30; CLERS_DIRECTIONS: 2 to 20
  double amount;            ///< of the precisions that name it
  const double* origin;     ///< CLERS_GRID: one number, or one a component
  size_t origin_count;      ///< how many
} clers_attribute;

/// Faces are cycles of vertices, counterclockwise seen from outside. Any are taken: polygons,
/// non-manifold, degenerate and duplicate ones, vertices that no face uses; all come back.
typedef struct clers_mesh {
  size_t size;                 ///< sizeof(clers_mesh)
  uint32_t vertex_count;       ///< vertices are 0 .. vertex_count - 1
  const uint32_t* corners;     ///< the vertices of all faces, one face after the other
  const uint16_t* corners_16;  ///< or these: one of the two is NULL
  size_t corner_count;         ///< elements of that array
  const uint32_t* face_sizes;  ///< corners of each face; NULL: all are triangles
  size_t face_count;           ///< elements of face_sizes; ignored if all are triangles
  const clers_attribute* attributes;
  size_t attribute_count;
  const char* name;  ///< NULL: none
  // Out, each if it is not NULL: where the elements of the decoded mesh were in this one.
  uint32_t* old_vertices;   ///< of vertex_count: old_vertices[new] = old
  uint32_t* old_faces;      ///< one a face
  uint32_t* first_corners;  ///< one a face: the corner of the old face that comes first now
} clers_mesh;

// ---- Encoding

enum { CLERS_ORDER_FREE = 0, CLERS_ORDER_KEEP = 1 };
enum { CLERS_KEEP = 0, CLERS_REJECT = 1 };
#define CLERS_EVERY_CORE 0xffffffffu

typedef struct clers_encode_options {
  size_t size;             ///< sizeof(clers_encode_options)
  int32_t level;           ///< 1 fastest .. 9 smallest; 0: 5
  int32_t order;           ///< CLERS_ORDER_FREE: vertices and faces come back in the codec's order,
                           ///< which costs nothing; CLERS_ORDER_KEEP: in that of the input
  uint32_t threads;        ///< 0: one; CLERS_EVERY_CORE. The bytes do not depend on it
  uint32_t piece_faces;    ///< a mesh of more faces is coded in pieces of about so many, which
                           ///< decode alone; 0: about 2^18 from 2^20 faces on; CLERS_NONE: never
  int32_t on_nonmanifold;  ///< CLERS_KEEP: such edges and vertices are coded; CLERS_REJECT: the
                           ///< first is an error
  int32_t on_degenerate;   ///< the same of faces that use a vertex twice
  int32_t on_duplicate;    ///< the same of faces on the vertices of another
} clers_encode_options;

/// Bytes that are enough for what clers_encode makes of these meshes: twice their arrays and some
/// more. It looks at counts and names alone, in time linear in meshes and attributes. 0: the
/// structs are not what clers_encode takes, or SIZE_MAX would not do. `options`: NULL for none.
/// No proof stands behind it, but a test; clers_encode never writes beyond what it is given.
CLERS_C_API size_t clers_bound(const clers_mesh* meshes, size_t mesh_count,
                               const clers_encode_options* options);

/// Encodes meshes, mostly one, into a .clers file at `bytes`, of which at most `capacity` are
/// written; `*size` takes how many. Equal input gives equal bytes on all machines and compilers, by
/// one version of this library and of zstd.
/// Errors: CLERS_INCONSISTENT_MESH .. CLERS_NOT_ON_GRID, CLERS_OUT_OF_MEMORY,
/// CLERS_BUFFER_TOO_SMALL (`needed` says what it takes; nothing is written then).
/// Cost: linear in faces and values; encode in <clers/encode.h> says what memory it takes, and
/// besides that the file is in memory twice.
CLERS_C_API clers_code clers_encode(const clers_mesh* meshes, size_t mesh_count,
                                    const clers_encode_options* options, void* bytes,
                                    size_t capacity, size_t* size, clers_error* error);

// ---- Decoding: open, look at sizes, allocate, decode, close. No byte is trusted.

/// Limits: what a file may cost; 0 is the default.
typedef struct clers_decode_options {
  size_t size;            ///< sizeof(clers_decode_options)
  uint64_t max_meshes;    ///< 0: 2^20
  uint64_t max_vertices;  ///< in one mesh; 0: no limit
  uint64_t max_faces;     ///< in one mesh; 0: no limit
  uint64_t max_memory;    ///< bytes that a call may take at any time, besides memory of the caller;
                          ///< 0: 1 GiB, or 4096 times the file, whichever is more
  uint32_t threads;       ///< 0: one; CLERS_EVERY_CORE
} clers_decode_options;

/// A file whose headers were read. Never changes: threads may share one.
typedef struct clers_decoder clers_decoder;

/// Reads headers and checksums; `*decoder` is what the other functions take, or NULL on error. The
/// bytes must stay as they are until clers_close.
/// Errors: CLERS_NOT_CLERS .. CLERS_OUT_OF_MEMORY, CLERS_BAD_OPTION. Cost: a pass over the bytes.
CLERS_C_API clers_code clers_open(const void* bytes, size_t size,
                                  const clers_decode_options* options, clers_decoder** decoder,
                                  clers_error* error);

/// Frees a decoder, and with it the names that infos point to. NULL is allowed. No call may be
/// using it.
CLERS_C_API void clers_close(clers_decoder* decoder);

// Infos: the caller sets `size` alone, all else is out. Their names live until clers_close.

typedef struct clers_file_info {
  size_t size;  ///< sizeof(clers_file_info)
  uint64_t mesh_count;
  uint64_t piece_count;  ///< of all meshes; a mesh that is not in pieces is one
  uint64_t bytes;        ///< of the file
  uint32_t format_major, format_minor;
  int32_t level;  ///< that it was made with
} clers_file_info;

typedef struct clers_mesh_info {
  size_t size;  ///< sizeof(clers_mesh_info)
  const char* name;
  uint64_t vertex_count, face_count, corner_count;  ///< elements of arrays to decode into
  uint64_t attribute_count;
  uint64_t first_piece, piece_count;  ///< its pieces, as clers_decode_piece counts them
  int32_t triangles_only;             ///< 0: there are, or may be, other faces
  uint64_t connectivity_bytes;        ///< that faces take in the file
  uint64_t attribute_bytes;           ///< and values
} clers_mesh_info;

/// CLERS_DIFFERENCE: of a component; CLERS_ANGLE: between directions, in degrees.
enum { CLERS_DIFFERENCE = 0, CLERS_ANGLE = 1 };

typedef struct clers_attribute_info {
  size_t size;  ///< sizeof(clers_attribute_info)
  const char* name;
  int32_t domain;       ///< as in clers_attribute
  int32_t scalar;       ///< the same
  uint32_t components;  ///< the same
  uint64_t count;       ///< elements of its domain: values to decode
  uint64_t value_size;  ///< bytes of one, packed
  uint64_t bytes;       ///< that they take in the file
  double error;         ///< by how much values were changed at most; 0: they come back bit for bit
  int32_t measure;      ///< what the error is
} clers_attribute_info;

typedef struct clers_piece_info {
  size_t size;                                      ///< sizeof(clers_piece_info)
  uint64_t mesh, index;                             ///< of its mesh, and among that one's pieces
  uint64_t vertex_count, face_count, corner_count;  ///< elements of arrays to decode into
  uint64_t first_vertex;  ///< in the mesh: vertices that no piece before has have numbers from here
  uint64_t first_face;    ///< and its faces
  int32_t triangles_only;
} clers_piece_info;

/// What is known without decoding. Indices count from 0. Error: CLERS_BAD_OPTION. Constant time.
CLERS_C_API clers_code clers_inspect(const clers_decoder* decoder, clers_file_info* info,
                                     clers_error* error);
CLERS_C_API clers_code clers_inspect_mesh(const clers_decoder* decoder, size_t mesh,
                                          clers_mesh_info* info, clers_error* error);
CLERS_C_API clers_code clers_inspect_attribute(const clers_decoder* decoder, size_t mesh,
                                               size_t attribute, clers_attribute_info* info,
                                               clers_error* error);
CLERS_C_API clers_code clers_inspect_piece(const clers_decoder* decoder, size_t piece,
                                           clers_piece_info* info, clers_error* error);

/// Memory for the values of an attribute, one for each element. Where an element has no value, the
/// memory stays as it was.
typedef struct clers_attribute_target {
  size_t size;          ///< sizeof(clers_attribute_target)
  const char* name;     ///< of several of one name and domain, the first
  int32_t domain;       ///< that of the attribute
  int32_t scalar;       ///< that of the attribute: nothing is converted
  uint32_t components;  ///< as stored, too
  void* data;           ///< for the first value
  size_t data_size;     ///< bytes from there to the end of the last value, or of its stride
  size_t stride;  ///< bytes from one value to the next; 0: packed. Those between two values are
                  ///< left alone
} clers_attribute_target;

/// Memory for a mesh, or for a part of it: what is NULL is left out. Counts are those of the info.
typedef struct clers_target {
  size_t size;           ///< sizeof(clers_target)
  uint32_t* corners;     ///< of corner_count
  uint16_t* corners_16;  ///< or these, for at most 65536 vertices
  uint32_t*
      opposites;  ///< of corner_count: of the half-edge from corner h to the next of its face,
                  ///< the one that runs the other way; CLERS_NONE: there is not just one
  size_t corner_count;
  uint32_t* face_sizes;  ///< of face_count; needed with corners unless all faces are triangles
  size_t face_count;
  const clers_attribute_target* attributes;
  size_t attribute_count;
} clers_target;

/// Decodes faces of a mesh, some of its attributes, or both; what is asked for in one call is
/// decoded once, and values are predicted along faces, so that any call decodes these. Corners are
/// below vertex_count, whatever the bytes are. On error the memory may hold anything. Errors:
/// CLERS_BAD_OPTION, of what does not fit the file (which is said), CLERS_INVALID, CLERS_LIMIT,
/// CLERS_OUT_OF_MEMORY. Cost: linear; memory besides: that of a piece a thread.
CLERS_C_API clers_code clers_decode(const clers_decoder* decoder, size_t mesh,
                                    const clers_target* target, clers_error* error);

/// The same of one attribute, packed, as clers_inspect_attribute says that it is: `size` is
/// count * value_size. Error besides: CLERS_UNSUPPORTED, for one whose name and domain an attribute
/// before it has.
CLERS_C_API clers_code clers_decode_attribute(const clers_decoder* decoder, size_t mesh,
                                              size_t attribute, void* data, size_t size,
                                              clers_error* error);

/// The same of one piece (no opposites), whose vertices have numbers of its own; `numbers`, if it
/// is not NULL, takes for each its number in the mesh: below clers_piece_info::first_vertex, it is
/// one of a piece before. Where the order of the input was kept, numbers in a mesh of several
/// pieces are those of the codec's order all the same. Cost: linear in the piece, which is in
/// memory twice.
CLERS_C_API clers_code clers_decode_piece(const clers_decoder* decoder, size_t piece,
                                          const clers_target* target, uint32_t* numbers,
                                          clers_error* error);

#ifdef __cplusplus
}
#endif

#endif
