// SPDX-License-Identifier: GPL-3.0-or-later
#include "crease_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "integral_invariant/curvature.h"
#include "integral_invariant/support/pi.h"
#include "support/ply_file.h"

namespace accuracy {

using namespace integral_invariant;

namespace {

using EdgeEnds = std::array<int, 2>;

struct Creases {
  std::vector<EdgeEnds> edges;
  std::vector<std::uint32_t> flat;  ///< vertices
};

std::vector<Vec3> face_normals(const TriangleMesh& mesh)
{
  std::vector<Vec3> normals;
  for (const Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.positions[std::size_t(t[0])];
    normals.push_back(normalized(cross(mesh.positions[std::size_t(t[1])] - a, mesh.positions[std::size_t(t[2])] - a)));
  }
  return normals;
}

std::vector<EdgeEnds> crease_edges(const TriangleMesh& mesh, const std::vector<Vec3>& normals)
{
  const double crease_cosine = std::cos(40 * pi / 180);
  std::map<EdgeEnds, std::size_t> first_face;
  std::vector<EdgeEnds> creases;
  for (std::size_t f = 0; f < normals.size(); ++f)
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = mesh.triangles[f][c], b = mesh.triangles[f][(c + 1) % 3];
      const auto [it, is_new] = first_face.try_emplace(EdgeEnds{std::min(a, b), std::max(a, b)}, f);
      if (!is_new && dot(normals[it->second], normals[f]) <= crease_cosine) creases.push_back(it->first);
    }
  return creases;
}

std::vector<std::uint32_t> flat_vertices(const TriangleMesh& mesh, const std::vector<Vec3>& normals)
{
  const double flat_cosine = std::cos(0.5 * pi / 180);
  std::vector<Vec3> first(mesh.positions.size());
  std::vector<bool> bent(mesh.positions.size()), used(mesh.positions.size());
  for (std::size_t f = 0; f < normals.size(); ++f)
    for (const int corner : mesh.triangles[f]) {
      const std::size_t v = std::size_t(corner);
      if (!used[v]) first[v] = normals[f];
      used[v] = true;
      if (dot(first[v], normals[f]) < flat_cosine) bent[v] = true;
    }
  std::vector<std::uint32_t> flat;
  for (std::uint32_t v = 0; v < used.size(); ++v)
    if (used[v] && !bent[v]) flat.push_back(v);
  return flat;
}

Creases creases_of(const TriangleMesh& mesh)
{
  const std::vector<Vec3> normals = face_normals(mesh);
  Creases creases;
  creases.edges = crease_edges(mesh, normals);
  creases.flat = flat_vertices(mesh, normals);
  return creases;
}

/// The curvature of larger size, with its sign.
double dominant(const Result& r, int vertex)
{
  const std::size_t v = std::size_t(vertex);
  return std::abs(r.kappa_max[v]) >= std::abs(r.kappa_min[v]) ? r.kappa_max[v] : r.kappa_min[v];
}

void print_quality(const std::string& mesh, const std::string& method, const Creases& creases, const Result& r)
{
  constexpr double largest_ratio = 2, largest_flat = 0.05, errors = 3;
  std::size_t uneven = 0, wrong = 0, within = 0, wrong_within = 0;
  for (const EdgeEnds& e : creases.edges) {
    const double a = dominant(r, e[0]), b = dominant(r, e[1]);
    uneven += a * b <= 0 || std::max(a / b, b / a) > largest_ratio;
  }
  for (const std::uint32_t v : creases.flat) {
    const bool is_wrong = std::abs(r.kappa_max[v] + r.kappa_min[v]) / 2 * r.average_edge > largest_flat;
    wrong += is_wrong;
    for (const double k : {r.kappa_max[v], r.kappa_min[v]}) {
      // What the rounding of the coordinates makes of a plane is no error.
      const bool is_within = std::abs(k) <= std::max(errors * r.standard_error[v], 1e-4 / r.average_edge);
      within += is_within;
      wrong_within += is_wrong && is_within;
    }
  }
  const double flats = std::max<double>(1, double(creases.flat.size()));
  std::printf("| %s | %s | %zu | %.4f | %zu | %.4f | %.4f | %.4f |\n", mesh.c_str(), method.c_str(),
              creases.edges.size(), double(uneven) / std::max<double>(1, double(creases.edges.size())),
              creases.flat.size(), double(wrong) / flats, double(within) / (2 * flats),
              double(wrong_within) / std::max<double>(1, 2 * double(wrong)));
}

}  // namespace

void print_crease_quality(const std::vector<std::string>& paths)
{
  std::puts(
      "| mesh | method | neighbours along creases | differ by more than 2× | flat vertices | of them \\|H\\| ē > 0.05 "
      "| "
      "errors within 3 s.e. | of those that read wrong |\n|---|---|---|---|---|---|---|---|");
  for (const std::string& path : paths) {
    const TriangleMesh mesh = test_support::read_ply(path).mesh();
    const Creases creases = creases_of(mesh);
    const std::string name = path.substr(path.rfind('/') + 1);
    print_quality(name, "default", creases, compute_curvature(mesh, {}));
    print_quality(name, "published", creases, compute_curvature(mesh, published_method()));
    std::fflush(stdout);
  }
}

}  // namespace accuracy
