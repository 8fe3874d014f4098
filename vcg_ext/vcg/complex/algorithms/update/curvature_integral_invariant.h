// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCGLIB_UPDATE_CURVATURE_INTEGRAL_INVARIANT
#define VCGLIB_UPDATE_CURVATURE_INTEGRAL_INVARIANT

#include <vcg/complex/complex.h>
#include <wrap/callback.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "integral_invariant/curvature.h"
#include "vcg/complex/algorithms/update/vertex_attribute_transaction.h"

namespace vcg {
namespace tri {

/// \ingroup trimesh
/// \headerfile curvature_integral_invariant.h vcg/complex/algorithms/update/curvature_integral_invariant.h

/** \brief Principal curvatures and directions by integral invariants with a feature-adapted radius.

Robust against noise: reads the curvatures from the part of the solid inside a ball around each vertex (Yang et al.,
SGP 2006; Pottmann et al., CAGD 2007), whose radius follows the size of the local feature (Lai, Hu and Fang, GPM 2009).

Needs the library target integral_invariant (no MeshLab, no Qt). Works on any TriMesh; deleted vertices and faces are
skipped, nothing is renumbered, and no adjacency or normals are needed.
*/
template <class MeshType>
class UpdateCurvatureIntegralInvariant {
 public:
  typedef typename MeshType::VertexType VertexType;
  typedef typename MeshType::CoordType CoordType;
  typedef typename MeshType::ScalarType ScalarType;
  typedef typename MeshType::template PerVertexAttributeHandle<ScalarType> ScalarHandle;
  typedef typename MeshType::template PerVertexAttributeHandle<CoordType> VectorHandle;

  typedef integral_invariant::Parameters Params;
  typedef integral_invariant::Result Result;

  /// Computes and writes: K1 >= K2 and the unit directions PD1, PD2 (K1, PD1: largest signed curvature, positive where
  /// the solid is convex), the radius where vertices have one, and the per-vertex attributes that WriteAttributes()
  /// names.
  ///
  /// \pre vertices have a curvature direction component, faces are triangles oriented outward
  /// \param cb called with a percentage and the stage; returning false cancels
  /// \return everything computed, and how: scales, converged vertices, seconds per stage
  /// \throw vcg::MissingComponentException without PerVertexCurvatureDir
  /// \throw integral_invariant::InputError (and its kinds) with a sentence for the user; integral_invariant::Cancelled.
  /// \throw std::bad_alloc. The mesh is unchanged after any of them.
  static Result Compute(MeshType& m, const Params& params = Params(), vcg::CallBackPos* cb = nullptr)
  {
    tri::RequirePerVertexCurvatureDir(m);
    integral_invariant::ProgressCallback progress;
    if (cb) progress = [cb](int percent, const char* stage) { return cb(percent, stage); };
    Result result = integral_invariant::compute_curvature(CopyMesh(m), params, progress);
    Write(m, result);
    return result;
  }

  /// The vertices and faces of m that are not deleted, in order; indices count them alone.
  static integral_invariant::TriangleMesh CopyMesh(const MeshType& m)
  {
    integral_invariant::TriangleMesh copy;
    copy.positions.reserve(size_t(m.VN()));
    copy.triangles.reserve(size_t(m.FN()));
    std::vector<int> index(m.vert.size(), -1);
    for (size_t i = 0; i < m.vert.size(); ++i)
      if (!m.vert[i].IsD()) {
        const CoordType& p = m.vert[i].cP();
        index[i] = int(copy.positions.size());
        copy.positions.push_back({double(p[0]), double(p[1]), double(p[2])});
      }
    for (const auto& f : m.face)
      if (!f.IsD())
        copy.triangles.push_back(
            {index[tri::Index(m, f.cV(0))], index[tri::Index(m, f.cV(1))], index[tri::Index(m, f.cV(2))]});
    return copy;
  }

  /// Writes the result of a run on CopyMesh(m) to m: see Compute(). All of it, or nothing where memory runs out.
  static void Write(MeshType& m, const Result& result)
  {
    tri::RequirePerVertexCurvatureDir(m);
    WriteAttributes(m, result);  // first: nothing after it can fail
    ForEachVertexWithIndex(m, [&](VertexType& v, size_t i) {
      v.K1() = Representable<typename VertexType::CurScalarType>(result.kappa_max[i]);
      v.K2() = Representable<typename VertexType::CurScalarType>(result.kappa_min[i]);
      v.PD1().Import(Vector(result.dir_max[i]));
      v.PD2().Import(Vector(result.dir_min[i]));
    });
    if (tri::HasPerVertexRadius(m))
      ForEachVertexWithIndex(m, [&](VertexType& v, size_t i) {
        v.R() = Representable<typename VertexType::RadiusType>(result.radius[i]);
      });
  }

  /// Per-vertex attributes: ii_kmax, ii_kmin, ii_radius, ii_error, ii_confidence (scalar), ii_dirmax, ii_dirmin
  /// (point).
  static void WriteAttributes(MeshType& m, const Result& result)
  {
    VertexAttributeTransaction<MeshType> attributes(m, 7);
    const auto scalar = [&](const char* name) { return attributes.template Attribute<ScalarType>(name); };
    const auto vector = [&](const char* name) { return attributes.template Attribute<CoordType>(name); };
    ScalarHandle kmax = scalar("ii_kmax"), kmin = scalar("ii_kmin"), radius = scalar("ii_radius");
    ScalarHandle error = scalar("ii_error"), confidence = scalar("ii_confidence");
    VectorHandle dirmax = vector("ii_dirmax"), dirmin = vector("ii_dirmin");
    attributes.Commit();
    ForEachVertexWithIndex(m, [&](VertexType& v, size_t i) {
      kmax[v] = Representable(result.kappa_max[i]);
      kmin[v] = Representable(result.kappa_min[i]);
      radius[v] = Representable(result.radius[i]);
      error[v] = Representable(result.standard_error[i]);
      confidence[v] = Representable(result.confidence[i]);
      dirmax[v] = Vector(result.dir_max[i]);
      dirmin[v] = Vector(result.dir_min[i]);
    });
  }

  /// Calls visit(vertex, i) for each vertex that is not deleted, i counting those alone: the index into a Result.
  template <class Visit>
  static void ForEachVertexWithIndex(MeshType& m, const Visit& visit)
  {
    size_t i = 0;
    for (auto& v : m.vert)
      if (!v.IsD()) visit(v, i++);
  }

  /// The value in the precision of a field; what that cannot hold becomes its largest finite value.
  template <class Scalar = ScalarType>
  static Scalar Representable(double value)
  {
    const double largest = double(std::numeric_limits<Scalar>::max());
    return Scalar(std::min(std::max(value, -largest), largest));
  }

 private:
  static CoordType Vector(const integral_invariant::Vec3& v)
  {
    return CoordType(ScalarType(v.x), ScalarType(v.y), ScalarType(v.z));
  }
};

}  // namespace tri
}  // namespace vcg

#endif
