// SPDX-License-Identifier: GPL-3.0-or-later
#include "classic.h"

#include <Eigen/Dense>
#include <cmath>

#include "integral_invariant/ball_curvature/curvature_tensor.h"
#include "integral_invariant/drawing/local_regression.h"
#include "integral_invariant/features/topology.h"

namespace line_benchmark {

using namespace integral_invariant;

namespace {

using Tensor = std::array<double, 3>;  // uu, uv, vv

class Classic {
 public:
  Classic(const Surface& surface, double smoothing)
      : surface_(surface), smoothing_(smoothing), areas_([&] {
          Execution execution;
          return vertex_areas(surface, execution);
        }())
  {
  }

  DifferentiatedField field()
  {
    find_normals();
    const std::size_t n = surface_.vertex_count();
    for (std::size_t v = 0; v < n; ++v) frames_.push_back(frame_at(normals_[v], any_orthogonal(normals_[v])));
    tensors_ = smoothed(at_vertices<3>([&](const Triangle& t, const TangentFrame& f) { return curvature_of(t, f); }));
    DifferentiatedField field;
    resize(field, n);
    for (std::size_t v = 0; v < n; ++v) set_curvature(field, v);
    derivatives_ =
        smoothed(at_vertices<4>([&](const Triangle& t, const TangentFrame& f) { return derivative_of(t, f); }));
    field.derivative = derivatives_;
    return field;
  }

 private:
  static TangentFrame frame_at(const Vec3& n, const Vec3& u) { return {n, u, cross(n, u)}; }

  void find_normals()
  {
    normals_.assign(surface_.vertex_count(), {});
    for (const Triangle& t : surface_.triangles()) {
      const TriangleFrame frame(t, surface_.positions());
      for (int i = 0; i < 3; ++i) {  // by the angle at the vertex
        const Vec3& p = surface_.positions()[t[i]];
        const Vec3 a = normalized(surface_.positions()[t[(i + 1) % 3]] - p);
        const Vec3 b = normalized(surface_.positions()[t[(i + 2) % 3]] - p);
        normals_[t[i]] += frame.normal * std::acos(std::clamp(dot(a, b), -1.0, 1.0));
      }
    }
    for (Vec3& n : normals_) n = normalized(n);
    if (!(smoothing_ > 0)) return;
    NeighbourhoodWalk walk(surface_, normals_);
    std::vector<Vec3> smooth(normals_.size());
    for (std::size_t v = 0; v < normals_.size(); ++v)
      for (const std::int32_t q : walk.around(std::int32_t(v), 2 * smoothing_)) smooth[v] += normals_[q] * weight(v, q);
    for (std::size_t v = 0; v < normals_.size(); ++v) normals_[v] = normalized(smooth[v], normals_[v]);
  }

  double weight(std::size_t v, std::int32_t q) const
  {
    const double d2 = squared_norm(surface_.positions()[q] - surface_.positions()[v]);
    return areas_[q] * std::exp(-d2 / (2 * smoothing_ * smoothing_));
  }

  /// Components in the vertex's frame of what is given in another, for forms of degree 2 or 3.
  static Tensor turned_form(const Tensor& k, double x, double y)
  {
    return {k[0] * x * x + 2 * k[1] * x * y + k[2] * y * y, (k[2] - k[0]) * x * y + k[1] * (x * x - y * y),
            k[0] * y * y - 2 * k[1] * x * y + k[2] * x * x};
  }
  static CurvatureDerivative turned_form(const CurvatureDerivative& c, double x, double y)
  {
    const auto form = [&](std::array<double, 2> a, std::array<double, 2> b, std::array<double, 2> d) {
      return a[0] * (b[0] * (d[0] * c[0] + d[1] * c[1]) + b[1] * (d[0] * c[1] + d[1] * c[2])) +
             a[1] * (b[0] * (d[0] * c[1] + d[1] * c[2]) + b[1] * (d[0] * c[2] + d[1] * c[3]));
    };
    const std::array<double, 2> u{x, y}, v{-y, x};
    return {form(u, u, u), form(u, u, v), form(u, v, v), form(v, v, v)};
  }

  template <class Form>
  static Form moved(const Form& form, const TangentFrame& from, const TangentFrame& to)
  {
    const Vec3 u = rotate_to(to.u, to.normal, from.normal);
    return turned_form(form, dot(u, from.u), dot(u, from.v));
  }

  /// Weighted means at the vertices of what `of_triangle(t, frame of t)` gives.
  template <std::size_t size, class OfTriangle>
  std::vector<std::array<double, size>> at_vertices(const OfTriangle& of_triangle) const
  {
    std::vector<std::array<double, size>> sums(surface_.vertex_count());
    std::vector<double> weights(surface_.vertex_count(), 0);
    for (const Triangle& t : surface_.triangles()) {
      const TriangleFrame triangle(t, surface_.positions());
      if (!(triangle.doubled_area > 0)) continue;
      const Vec3 u = normalized(surface_.positions()[t[1]] - surface_.positions()[t[0]]);
      const TangentFrame frame = frame_at(triangle.normal, u);
      const auto form = of_triangle(t, frame);
      for (const std::int32_t v : t) {
        const auto here = moved(form, frame, frames_[v]);
        for (std::size_t i = 0; i < size; ++i) sums[v][i] += here[i] * triangle.doubled_area;
        weights[v] += triangle.doubled_area;
      }
    }
    for (std::size_t v = 0; v < sums.size(); ++v)
      for (double& value : sums[v]) value /= std::max(weights[v], 1e-300);
    return sums;
  }

  Tensor curvature_of(const Triangle& t, const TangentFrame& f) const
  {
    Eigen::Matrix<double, 6, 3> a;
    Eigen::Matrix<double, 6, 1> b;
    for (int i = 0; i < 3; ++i) {
      const std::int32_t p = t[(i + 1) % 3], q = t[(i + 2) % 3];
      const Vec3 e = surface_.positions()[q] - surface_.positions()[p], dn = normals_[q] - normals_[p];
      const double x = dot(e, f.u), y = dot(e, f.v);
      a.row(2 * i) << x, y, 0;
      a.row(2 * i + 1) << 0, x, y;
      b(2 * i) = dot(dn, f.u);
      b(2 * i + 1) = dot(dn, f.v);
    }
    const Eigen::Vector3d k = a.colPivHouseholderQr().solve(b);
    return {k(0), k(1), k(2)};
  }

  CurvatureDerivative derivative_of(const Triangle& t, const TangentFrame& f) const
  {
    Eigen::Matrix<double, 9, 4> a;
    Eigen::Matrix<double, 9, 1> b;
    for (int i = 0; i < 3; ++i) {
      const std::int32_t p = t[(i + 1) % 3], q = t[(i + 2) % 3];
      const Vec3 e = surface_.positions()[q] - surface_.positions()[p];
      const double x = dot(e, f.u), y = dot(e, f.v);
      const Tensor kp = moved(tensors_[p], frames_[p], f), kq = moved(tensors_[q], frames_[q], f);
      a.row(3 * i) << x, y, 0, 0;
      a.row(3 * i + 1) << 0, x, y, 0;
      a.row(3 * i + 2) << 0, 0, x, y;
      for (int k = 0; k < 3; ++k) b(3 * i + k) = kq[k] - kp[k];
    }
    const Eigen::Vector4d c = a.colPivHouseholderQr().solve(b);
    return {c(0), c(1), c(2), c(3)};
  }

  template <class Form>
  std::vector<Form> smoothed(const std::vector<Form>& forms) const
  {
    if (!(smoothing_ > 0)) return forms;
    NeighbourhoodWalk walk(surface_, normals_);
    std::vector<Form> result(forms.size());
    for (std::size_t v = 0; v < forms.size(); ++v) {
      double weights = 0;
      Form sum{};
      for (const std::int32_t q : walk.around(std::int32_t(v), 2 * smoothing_)) {
        const Form here = moved(forms[q], frames_[q], frames_[v]);
        const double w = weight(v, q);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += w * here[i];
        weights += w;
      }
      for (std::size_t i = 0; i < sum.size(); ++i) result[v][i] = sum[i] / weights;
    }
    return result;
  }

  static void resize(DifferentiatedField& field, std::size_t n)
  {
    CurvatureField& k = field.curvature;
    k.kappa_max.resize(n);
    k.kappa_min.resize(n);
    for (auto* directions : {&k.dir_max, &k.dir_min, &k.normal}) directions->resize(n);
    field.error.assign(n, 0);
    field.derivative_error.assign(n, 1);
    field.derivative_noise.assign(n, 1);
    field.correlation.assign(n, 1);
    field.width.assign(n, 1);
  }

  /// Turns the vertex's frame to the principal directions.
  void set_curvature(DifferentiatedField& field, std::size_t v)
  {
    const TangentFrame f = frames_[v];
    const Tensor& t = tensors_[v];
    const Symmetric3 k = outer(f.u) * t[0] + symmetric_outer(f.u, f.v) * t[1] + outer(f.v) * t[2];
    const PrincipalCurvatures p = principal_curvatures({k, f.normal, 1});
    frames_[v] = frame_at(f.normal, p.dir_max);
    tensors_[v] = {p.kappa_max, 0, p.kappa_min};
    field.curvature.kappa_max[v] = p.kappa_max;
    field.curvature.kappa_min[v] = p.kappa_min;
    field.curvature.dir_max[v] = frames_[v].u;
    field.curvature.dir_min[v] = frames_[v].v;
    field.curvature.normal[v] = f.normal;
    field.position = surface_.positions();
  }

  const Surface& surface_;
  double smoothing_;
  std::vector<double> areas_;
  std::vector<Vec3> normals_;
  std::vector<TangentFrame> frames_;
  std::vector<Tensor> tensors_;
  std::vector<CurvatureDerivative> derivatives_;
};

}  // namespace

DifferentiatedField classic_field(const Surface& surface, double smoothing)
{
  return Classic(surface, smoothing).field();
}

}  // namespace line_benchmark
