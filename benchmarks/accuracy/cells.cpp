// SPDX-License-Identifier: GPL-3.0-or-later
#include "cells.h"

#include <cstdio>

#include "cad_models.h"
#include "shapes.h"

namespace accuracy {

namespace {

constexpr double shape_noise[] = {0, 0.05, 0.1, 0.2, 0.5, 1};
constexpr double cad_noise[] = {0, 0.1};

Meshing meshing_of(const std::string& name)
{
  for (const Meshing m : {Meshing::irregular, Meshing::graded, Meshing::slivers})
    if (name_of(m) == name) return m;
  return Meshing::regular;
}

}  // namespace

std::string Cell::name() const
{
  char noise[16];
  std::snprintf(noise, sizeof noise, "%g", sigma);
  return shape + '/' + meshing + '/' + noise;
}

std::uint32_t Cell::seed() const
{
  std::uint32_t hash = 2166136261u;
  for (const char c : name()) hash = (hash ^ std::uint32_t(c)) * 16777619u;
  return hash;
}

std::vector<Cell> all_cells(const std::string& models)
{
  std::vector<Cell> cells;
  const auto add = [&](const std::string& shape, const std::string& meshing, const auto& levels) {
    for (const double sigma : levels) cells.push_back({shape, meshing, sigma});
  };
  for (const std::string& shape : shape_names()) add(shape, name_of(Meshing::regular), shape_noise);
  for (const char* shape : {"sphere", "ellipsoid", "harmonic"})
    for (const Meshing m : {Meshing::irregular, Meshing::graded, Meshing::slivers}) add(shape, name_of(m), shape_noise);
  if (!models.empty())
    for (const std::string& model : cad_model_names()) add(model, "cad", cad_noise);
  return cells;
}

TruthMesh load(const Cell& cell, const std::string& models)
{
  return cell.meshing == "cad" ? load_cad_model(models, cell.shape) : make_shape(cell.shape, meshing_of(cell.meshing));
}

}  // namespace accuracy
