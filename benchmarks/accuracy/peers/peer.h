// SPDX-License-Identifier: GPL-3.0-or-later
// The interface through which the benchmark runs other estimators.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "estimate.h"

namespace accuracy {

/// One estimator, prepared for one mesh.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual std::string name() const = 0;
  /// An estimator without a radius is run once.
  virtual bool takes_radius() const = 0;
  /// Estimates at `vertices`. \param normals true normals there; they only decide the sign
  virtual std::vector<Estimate> estimate(const std::vector<std::uint32_t>& vertices, const std::vector<Vec3>& normals,
                                         double radius) = 0;
};

using PeerList = std::vector<std::unique_ptr<Peer>>;

/// VCG's estimators of principal directions that MeshLab offers: [Taubin], normal cycle, fit of a quadric to the
/// 1-ring.
void add_vcg_ring_peers(const TriangleMesh& mesh, PeerList& peers);
/// VCG's fit of a quadric to the vertices within a radius (MeshLab: scale dependent quadric fitting).
void add_vcg_quadric_peer(const TriangleMesh& mesh, PeerList& peers);
/// VCG's principal component analysis, which MeshLab offers as an implementation of [Yang06].
void add_vcg_pca_peer(const TriangleMesh& mesh, PeerList& peers);
/// CGAL's jets of degree 2 to 4 through the vertices within a radius.
void add_cgal_jet_peers(const TriangleMesh& mesh, PeerList& peers);
/// Interpolated corrected curvature measures over a radius and over half of it, on normals of planes fitted within it.
void add_corrected_current_peers(const TriangleMesh& mesh, PeerList& peers);
/// Algebraic point set surfaces of a radius.
void add_algebraic_sphere_peer(const TriangleMesh& mesh, PeerList& peers);

}  // namespace accuracy
