// SPDX-License-Identifier: GPL-3.0-or-later
// What the default costs a vertex, and how long it lets the callback wait, on meshes of every kind: made ones whose
// triangles are no surface, long, unwelded or of mixed sizes, and any PLY files.
//   input_kinds [FILE.ply ...]
// On one thread, in processor time, which the load of the machine changes little.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <random>
#include <string>

#include "integral_invariant/curvature.h"
#include "integral_invariant/error.h"
#include "support/ply_file.h"
#include "support/shapes.h"

using namespace integral_invariant;
using namespace test_support;

namespace {

/// Of the calling thread.
double processor_seconds()
{
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

struct Cost {
  double seconds = 0, longest_wait = 0;
  std::string refusal;
};

Cost cost_of(const TriangleMesh& mesh)
{
  Parameters parameters;
  parameters.threads = 1;
  Cost cost;
  const double start = processor_seconds();
  double last = start;
  const auto tick = [&] {
    const double now = processor_seconds();
    cost.longest_wait = std::max(cost.longest_wait, now - last);
    last = now;
  };
  try {
    compute_curvature(mesh, parameters, [&](int, const char*) { return tick(), true; });
  } catch (const InputError& error) {
    cost.refusal = error.what();
  }
  tick();
  cost.seconds = last - start;
  return cost;
}

void print_row(const std::string& name, const TriangleMesh& mesh)
{
  const Cost cost = cost_of(mesh);
  const double n = double(std::max<std::size_t>(mesh.positions.size(), 1));
  std::printf("| %s | %zu | %zu | %.2f | %.1f | %.3f | %s |\n", name.c_str(), mesh.positions.size(),
              mesh.triangles.size(), cost.seconds, 1e6 * cost.seconds / n, cost.longest_wait,
              cost.refusal.empty() ? "" : "refused");
  std::fflush(stdout);
}

TriangleMesh unwelded(const TriangleMesh& mesh)
{
  TriangleMesh soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = std::int32_t(soup.positions.size());
    for (const std::int32_t corner : t) soup.positions.push_back(mesh.positions[std::size_t(corner)]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

TriangleMesh stretched(TriangleMesh mesh, double factor)
{
  for (Vec3& p : mesh.positions) p.x *= factor;
  return mesh;
}

TriangleMesh randomly_oriented(TriangleMesh mesh)
{
  std::mt19937 random(5);
  for (Triangle& t : mesh.triangles)
    if (random() & 1) std::swap(t[1], t[2]);
  return mesh;
}

/// Triangles that share nothing, half as wide as the cube that they fill.
TriangleMesh random_soup(int triangles)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> share(0, 1);
  const auto point = [&] { return Vec3{share(random), share(random), share(random)}; };
  TriangleMesh mesh;
  for (int i = 0; i < triangles; ++i) {
    const Vec3 place = point();
    for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(place + point() * 0.5);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// A prism whose sides are two triangles each, `length` times as long as its radius.
TriangleMesh prism(int sides, double length)
{
  TriangleMesh mesh;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * 3.14159265358979 * i / sides;
    for (const double z : {0.0, length}) mesh.positions.push_back({std::cos(angle), std::sin(angle), z});
    const int a = 2 * i, b = 2 * ((i + 1) % sides);
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
  return mesh;
}

void print_made_meshes()
{
  const TriangleMesh surface = with_normal_noise(torus(2, 0.6, 300, 90), 0.002);
  print_row("torus", surface);
  print_row("torus, unwelded", unwelded(surface));
  print_row("torus, 30 times as long", stretched(surface, 30));
  print_row("torus, 1000 times as long", stretched(surface, 1000));
  print_row("torus, random orientation", randomly_oriented(surface));
  for (const int triangles : {1000, 4000, 16000}) print_row("random soup", random_soup(triangles));
  for (const int sides : {4000, 16000}) print_row("prism of long triangles", prism(sides, 50));
}

}  // namespace

int main(int argc, char** argv)
{
  std::printf(
      "| mesh | vertices | triangles | CPU s | CPU us/vertex | longest wait s | |\n|---|---|---|---|---|---|---|\n");
  if (argc == 1) print_made_meshes();
  for (int i = 1; i < argc; ++i) print_row(std::filesystem::path(argv[i]).stem().string(), read_ply(argv[i]).mesh());
}
