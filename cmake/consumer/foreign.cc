// What others compressed, by the libraries that need theirs.
#include <clers/draco.h>
#include <clers/meshopt.h>

int main() {
  const auto mesh = clers::draco::read({});
  const auto bytes = clers::meshopt::decode_for_gltf({}, 0, 4, "NO MODE", "NONE");
  return !mesh && mesh.error().code == clers::ErrorCode::malformed && !bytes &&
                 bytes.error().code == clers::ErrorCode::unsupported
             ? 0
             : 1;
}
