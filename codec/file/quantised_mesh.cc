// Attribute by attribute; views of what is not quantised stay as they are.
#include "codec/file/quantised_mesh.h"

#include <algorithm>
#include <string>
#include <utility>

#include "codec/base/parallel.h"
#include "codec/file/recomputed_normals.h"
#include "codec/numbers/quantise.h"

namespace clers::internal {
namespace {

bool names(const AttributePrecision& asked, const AttributeView& a) {
  return asked.name == a.name && (!asked.domain || asked.domain == a.domain);
}

std::string title(const AttributePrecision& asked) {
  return (asked.domain ? std::string(name(*asked.domain)) + " " : "") + "attribute '" + asked.name +
         "'";
}

Warning warning_of(const MeshView& mesh, const AttributeView& a, const Outliers& outliers,
                   int bits) {
  std::string what = "'" + std::string(a.name) + "' has values far from all others";
  if (a.domain == Domain::vertex) {
    what += ", farthest that of vertex " + std::to_string(outliers.farthest);
    if (std::find(mesh.corners.begin(), mesh.corners.end(), outliers.farthest) ==
        mesh.corners.end())
      what += ", which no face uses";
  } else {
    what += ", farthest that of " + std::string(name(a.domain)) + " " +
            std::to_string(outliers.farthest);
  }
  what += ": without them " + std::to_string(outliers.bits) + " instead of " +
          std::to_string(bits) + " bits would do";
  return {WarningCode::wasted_bits, 0, std::string(a.name), a.domain, outliers.farthest,
          std::move(what)};
}

}  // namespace

Expected<Done> check_precisions(std::span<const MeshView> meshes, const EncodeOptions& options,
                                std::span<const Array> arrays) {
  const std::vector<AttributePrecision>& all = options.precisions;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (const std::string fault = precision_fault(all[i].precision); !fault.empty())
      return fail(ErrorCode::bad_option, title(all[i]) + ": " + fault);
    for (std::size_t j = 0; j < i; ++j)
      if (all[j].name == all[i].name &&
          (!all[j].domain || !all[i].domain || all[j].domain == all[i].domain))
        return fail(ErrorCode::bad_option, title(all[i]) + ": its precision is given twice");
    bool known = false;
    for (const MeshView& mesh : meshes)
      for (const AttributeView a : mesh.attributes) known = known || names(all[i], a);
    for (const Array& a : arrays)
      known = known || (a.name == all[i].name && !all[i].domain && !a.vertices_of);
    if (!known) return fail(ErrorCode::bad_option, title(all[i]) + ": there is none of that name");
  }
  return Done{};
}

Expected<QuantisedMesh> quantise(const MeshView& mesh, const EncodeOptions& options,
                                 unsigned threads) {
  QuantisedMesh out;
  out.mesh = mesh;
  const std::size_t count = mesh.attributes.size();
  if (options.precisions.empty() || count == 0) return out;
  // Others may be predicted from positions.
  const auto is_needed = [&](const AttributeView& a) {
    return count > 1 && a.domain == Domain::vertex && a.name == position_name;
  };
  std::vector<Expected<QuantisedValues>> quantised(count, QuantisedValues{});
  for_each_item(count, threads, [&](std::size_t i, unsigned) {
    const AttributeView a = mesh.attributes[i];
    const Precision& precision = options.precision_of(a.name, a.domain);
    if (precision.kind != Precision::Kind::recomputed)
      quantised[i] = quantise(a, precision, is_needed(a));
  });
  out.values.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!quantised[i]) return Failure{quantised[i].error()};
    AttributeView a = mesh.attributes[i];
    if (quantised[i]->outliers)
      out.warnings.push_back(warning_of(mesh, a, *quantised[i]->outliers,
                                        options.precision_of(a.name, a.domain).bits));
    out.plans.push_back(std::move(quantised[i]->plan));
    if (out.plans.back().error > 0) {
      out.values[i] = std::move(quantised[i]->values);
      a.data = out.values[i];
      a.stride = 0;
      if (out.plans.back().integers_of) a.scalar = Scalar::int32;
    }
    out.attributes.push_back(a);
  }
  out.mesh.attributes = AttributeViews(out.attributes);
  for (std::size_t i = 0; i < count; ++i) {
    AttributeView& a = out.attributes[i];
    const Precision& precision = options.precision_of(a.name, a.domain);
    if (precision.kind != Precision::Kind::recomputed) continue;
    auto recomputed = recompute_normals(out.mesh, a, precision.size);
    if (!recomputed) return Failure{recomputed.error()};
    out.plans[i] = std::move(recomputed->plan);
    out.values[i] = std::move(recomputed->values);
    if (out.plans[i].error == 0) continue;
    a.data = out.values[i];
    a.stride = 0;
  }
  return out;
}

}  // namespace clers::internal
