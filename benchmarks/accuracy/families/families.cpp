// SPDX-License-Identifier: GPL-3.0-or-later
#include "families/families.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "cad_models.h"
#include "families/base_meshes.h"
#include "families/mesh_processing.h"
#include "families/surface_noise.h"
#include "families/vcg_processing.h"
#include "families/volume.h"
#include "support/shapes.h"

namespace accuracy {

namespace {

constexpr int usual_vertices = 10000;
constexpr int coarse_vertices = 3500;  ///< before subdivision
constexpr int fine_vertices = 25000;   ///< before decimation
constexpr int peer_vertices = 41000;   ///< much larger than balls of 40 edges, which other estimators are tried at

using Make = std::function<TriangleMesh(const FamilyCell&)>;

/// A mesh on the exact surface with its normals, ready for noise.
NoisyMesh on_surface(const ExactShape& shape, TriangleMesh mesh, std::mt19937& generator)
{
  NoisyMesh m;
  m.mesh = std::move(mesh);
  for (const Vec3& p : m.mesh.positions) m.normal.push_back(normalized(gradient_of(shape.field, p)));
  m.edge = test_support::average_edge_length(m.mesh);
  m.generator = &generator;
  return m;
}

/// A mesh of `vertices` vertices on the surface, to which `add` adds the noise.
Make noisy(int vertices, std::function<void(NoisyMesh&, double level)> add)
{
  return [=](const FamilyCell& cell) {
    std::mt19937 generator(cell.seed);
    NoisyMesh m = on_surface(cell.shape, cell.shape.mesh(vertices), generator);
    add(m, cell.level);
    return std::move(m.mesh);
  };
}

Make white(int vertices = usual_vertices)
{
  return noisy(vertices, [](NoisyMesh& m, double level) { add_white(m, level); });
}

/// White noise, and what is then done to the mesh.
Make processed(int vertices, std::function<TriangleMesh(TriangleMesh)> process)
{
  const Make make = white(vertices);
  return [=](const FamilyCell& cell) { return process(make(cell)); };
}

Make smoothed(int passes)
{
  constexpr double umbrella = 0.5;
  return processed(usual_vertices, [=](TriangleMesh mesh) {
    for (int i = 0; i < passes; ++i) smooth(mesh, umbrella);
    return mesh;
  });
}

/// Taubin's λ|μ smoothing with his factors.
TriangleMesh taubin_smoothed(TriangleMesh mesh)
{
  constexpr int passes = 10;
  for (int i = 0; i < passes; ++i) {
    smooth(mesh, 0.5);
    smooth(mesh, -0.53);
  }
  return mesh;
}

Make correlated(double length)
{
  return noisy(usual_vertices, [=](NoisyMesh& m, double level) { add_correlated(m, level, length); });
}

/// Some white noise, and few vertices far off.
Make spiked(double share)
{
  constexpr double height = 2;  // average edges
  return noisy(usual_vertices, [=](NoisyMesh& m, double level) {
    add_white(m, level);
    add_spikes(m, share, height);
  });
}

/// A volume whose voxels are as wide as the edges of the usual mesh, changed by `change`, and its zero set.
Make marched(const Vec3& voxel, std::function<void(Volume&, double level, std::mt19937&)> change)
{
  return [=](const FamilyCell& cell) {
    std::mt19937 generator(cell.seed);
    const double edge = test_support::average_edge_length(cell.shape.mesh(usual_vertices));
    Volume volume = sample(cell.shape, voxel * edge, generator);
    change(volume, cell.level, generator);
    return marching_cubes(volume);
  };
}

void binary(Volume& volume, double, std::mt19937&) { make_binary(volume); }

/// Variance 1.5 voxels squared.
void blurred_binary(Volume& volume, double, std::mt19937&)
{
  make_binary(volume);
  for (int pass = 0; pass < 3; ++pass) blur(volume);
}

/// Stands for Screened Poisson reconstruction: marching cubes of an implicit moving least squares distance to the
/// noisy cloud, whose normals are exact.
TriangleMesh reconstructed(const FamilyCell& cell)
{
  constexpr double width = 1.5, voxel = 0.8;  // average edges
  std::mt19937 generator(cell.seed);
  NoisyMesh m = on_surface(cell.shape, cell.shape.mesh(usual_vertices), generator);
  add_white(m, cell.level);
  const Vec3 spacing = Vec3{1, 1, 1} * (voxel * m.edge);
  const Volume exact = sample(cell.shape, spacing, generator);
  return marching_cubes(distance_to_points(m.mesh.positions, m.normal, width * m.edge, exact));
}

TriangleMesh with_rounded_coordinates(const FamilyCell& cell)
{
  TriangleMesh mesh = cell.shape.mesh(usual_vertices);
  round_coordinates(mesh, cell.level * test_support::average_edge_length(mesh));
  return mesh;
}

TriangleMesh with_rounded_heights(const FamilyCell& cell)
{
  TriangleMesh mesh = cell.shape.mesh(usual_vertices);
  round_heights(mesh, cell.level * test_support::average_edge_length(mesh));
  return mesh;
}

/// A scanner's lines, three times as far apart as the points of one, each line with an offset of its own.
TriangleMesh scanned_in_lines(const FamilyCell& cell)
{
  constexpr double ratio = 3;
  std::mt19937 generator(cell.seed);
  const auto height = [&](double x, double y) {
    // Height fields are z − height(x, y).
    return -cell.shape.field({x, y, 0});
  };
  NoisyMesh m = on_surface(cell.shape, line_mesh(height, usual_vertices, ratio), generator);
  add_white(m, cell.level);
  add_line_offsets(m, cell.level / 2);
  return std::move(m.mesh);
}

struct Family {
  std::string name;
  double least, largest;  ///< level, drawn between them geometrically
  Make make;
  bool height_fields_only = false;
};

std::vector<Family> noise_families()
{
  // Varying: the level is the least one, the largest is 25 times as much.
  const auto varying = [](NoisyMesh& m, double level) { add_varying(m, level, 25); };
  const auto jitter = [](NoisyMesh& m, double level) { add_jitter(m, level); };
  return {{"white", 0.05, 0.5, white()},
          {"white_fine", 0.1, 1, white(fine_vertices)},
          {"smoothed_1", 0.1, 0.5, smoothed(1)},
          {"smoothed_3", 0.1, 0.5, smoothed(3)},
          {"smoothed_10", 0.1, 0.5, smoothed(10)},
          {"taubin", 0.1, 0.5, processed(usual_vertices, taubin_smoothed)},
          {"correlated_1", 0.05, 0.3, correlated(1)},
          {"correlated_3", 0.05, 0.3, correlated(3)},
          {"correlated_6", 0.05, 0.3, correlated(6)},
          {"jitter", 0.05, 0.3, noisy(usual_vertices, jitter)},
          {"varying", 0.01, 0.03, noisy(usual_vertices, varying)},
          {"spikes_0.24", 0.03, 0.1, spiked(0.0024)},
          {"spikes_1", 0.03, 0.1, spiked(0.01)},
          {"scan_lines", 0.03, 0.2, scanned_in_lines, true},
          {"height_steps", 0.5, 3, with_rounded_heights, true},
          {"coordinate_steps", 0.2, 0.6, with_rounded_coordinates}};
}

std::vector<Family> meshing_families()
{
  const auto to_usual = [](TriangleMesh mesh) { return decimated(mesh, usual_vertices); };
  const auto remeshed = [](TriangleMesh mesh) {
    return isotropically_remeshed(mesh, test_support::average_edge_length(mesh));
  };
  const auto unchanged = [](Volume&, double, std::mt19937&) {};
  const auto with_noise = [](Volume& v, double level, std::mt19937& g) { add_white(v, level, g); };
  return {{"reconstructed", 0.1, 0.5, reconstructed},
          {"midpoint", 0.1, 0.4, processed(coarse_vertices, midpoint_subdivided)},
          {"loop", 0.1, 0.4, processed(coarse_vertices, loop_subdivided)},
          {"decimated", 0.1, 0.4, processed(fine_vertices, to_usual)},
          {"remeshed", 0.1, 0.4, processed(usual_vertices, remeshed)},
          {"mask", 1, 1, marched({1, 1, 1}, binary)},
          {"mask_anisotropic", 1, 1, marched({0.8, 0.8, 1.6}, binary)},
          {"mask_blurred", 1, 1, marched({1, 1, 1}, blurred_binary)},
          {"field_exact", 1, 1, marched({1, 1, 1}, unchanged)},
          {"field_noisy", 0.05, 0.3, marched({1, 1, 1}, with_noise)}};
}

/// Numbers that differ from one name and seed to the next.
std::uint32_t mixed(const std::string& name, std::uint32_t seed)
{
  std::uint32_t hash = 2166136261u ^ seed;
  for (const char c : name) hash = (hash ^ std::uint32_t(c)) * 16777619u;
  std::mt19937 generator(hash);
  return std::uint32_t(generator());
}

FamilyCell drawn(const Family& family, ExactShape shape, std::uint32_t seed)
{
  const Make make = family.make;
  FamilyCell cell{family.name, std::move(shape), 0, 0,
                  [make](const FamilyCell& c) { return judge_at_projections(c.shape, make(c)); }};
  std::mt19937 generator(mixed(cell.name(), seed));
  const double t = std::uniform_real_distribution<double>(0, 1)(generator);
  cell.level = family.least * std::pow(family.largest / family.least, t);
  cell.seed = std::uint32_t(generator());
  return cell;
}

FamilyCell cad_model(const std::string& family, const std::string& folder, const std::string& name, double sigma,
                     std::uint32_t seed)
{
  FamilyCell cell{family, {name, "cad", {}, {}, {}, {}, false}, sigma, mixed(family + name, seed), {}};
  cell.make = [folder](const FamilyCell& c) {
    TruthMesh truth = load_cad_model(folder, c.shape.name);
    truth.mesh = with_noise(truth, c.level, c.seed);
    return truth;
  };
  return cell;
}

void add_weakly_noisy_cad(const std::vector<ExactShape>& shapes, const std::string& models, std::uint32_t seed,
                          std::vector<FamilyCell>& cells)
{
  for (const char* level : {"0.01", "0.03", "0.05", "0.07", "0.1"}) {
    const double sigma = std::stod(level);
    const std::string family = std::string("cad_") + level;
    for (const ExactShape& shape : shapes)
      if (shape.group == "cad") cells.push_back(drawn({family, sigma, sigma, white()}, shape, seed));
    if (models.empty()) continue;
    for (const char* name : {"cad_block_fillet", "cad_pump_topcover"})
      cells.push_back(cad_model(family, models, name, sigma, seed));
  }
}

void add_textures(std::uint32_t seed, std::vector<FamilyCell>& cells)
{
  const Make exact = [](const FamilyCell& cell) { return cell.shape.mesh(usual_vertices); };
  for (const int edges : {6, 8, 12}) {
    const std::string name = "texture_" + std::to_string(edges);
    std::mt19937 generator(mixed(name, seed));
    for (ExactShape& shape : textured_shapes(edges, usual_vertices, generator))
      cells.push_back(drawn({name, 1, 1, exact}, std::move(shape), seed));
  }
}

}  // namespace

std::vector<FamilyCell> draw_cells(Half half, std::uint32_t seed, const std::string& models)
{
  std::mt19937 generator(mixed("shapes", seed));
  const std::vector<ExactShape> shapes = draw_shapes(half, generator);
  std::vector<Family> families = noise_families();
  for (Family& family : meshing_families()) families.push_back(std::move(family));
  std::vector<FamilyCell> cells;
  for (const Family& family : families)
    for (const ExactShape& shape : shapes)
      if (!family.height_fields_only || shape.is_height_field) cells.push_back(drawn(family, shape, seed));
  add_weakly_noisy_cad(shapes, half == Half::tuning ? models : "", seed, cells);
  add_textures(seed, cells);
  return cells;
}

std::vector<FamilyCell> draw_peer_cells(std::uint32_t seed)
{
  std::mt19937 generator(mixed("shapes", seed));
  const std::vector<ExactShape> shapes = draw_shapes(Half::tuning, generator);
  std::vector<FamilyCell> cells;
  for (const char* level : {"0.05", "0.1", "0.2", "0.5", "1"})
    for (const ExactShape& shape : shapes)
      cells.push_back(drawn({std::string("white_") + level, std::stod(level), std::stod(level), white(peer_vertices)},
                            shape, seed));
  for (const FamilyCell& cell : draw_cells(Half::tuning, seed, ""))
    for (const char* family : {"smoothed_3", "correlated_3", "mask", "reconstructed", "remeshed", "coordinate_steps"})
      if (cell.family == family && (cell.shape.name == "torus" || cell.shape.name == "bumpy_sphere"))
        cells.push_back(cell);
  return cells;
}

}  // namespace accuracy
