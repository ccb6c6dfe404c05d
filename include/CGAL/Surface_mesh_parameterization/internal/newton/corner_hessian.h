// Copyright (c) 2026  The Hierarchical Parameterization authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CORNER_HESSIAN_H
#define CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CORNER_HESSIAN_H

#include <CGAL/Surface_mesh_parameterization/Distortion_derivatives_2.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/Block.h>
#include <CGAL/Surface_mesh_parameterization/internal/core/flat_types.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Rest_triangle.h>
#include <CGAL/Surface_mesh_parameterization/internal/star/Bounded_energy_2.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Surface_mesh_parameterization::internal {

// Gradient and Hessian of the energy of one triangle VAB, as far as they concern its corner V: a row of 2x2 blocks, of
// which the one for A is minus the sum of the other two, for the energy does not change when the triangle is moved.
struct Corner_hessian
{
  Block_vector gradient;
  Block to_v, to_b;
};

// The Jacobian of a triangle's map.
//
// As complex numbers, with P the images of the corners and G the gradients of their hat functions on the rest shape,
// the map's conformal and anticonformal parts are z = sum P conj(G) / 2 and w = sum P G / 2. Its singular values are
// |z| + |w| and |z| - |w|, so its squared Frobenius norm is 2 (|z|^2 + |w|^2) and its determinant |z|^2 - |w|^2.
struct Jacobian
{
  double zx, zy, wx, wy;
  double determinant;

  double squared_z() const { return zx * zx + zy * zy; }
  double squared_w() const { return wx * wx + wy * wy; }
};

// The derivatives of an energy by |z|^2 and |w|^2. With the energy taken as a function of these two, nothing is
// singular where w vanishes.
struct Energy_derivatives
{
  double a, b;                          // |z|^2 and |w|^2
  Distortion_derivatives_2 given;       // by the squared norm and the determinant

  template <class Energy>
  Energy_derivatives(const Energy& energy, const Jacobian& j)
    : a(j.squared_z()), b(j.squared_w()), given(energy.derivatives(2 * (a + b), j.determinant))
  { }

  double by_a() const { return 2 * given.f + given.d; }
  double by_b() const { return 2 * given.f - given.d; }
  double by_aa() const { return 4 * given.ff + 4 * given.fd + given.dd; }
  double by_ab() const { return 4 * given.ff - given.dd; }
  double by_bb() const { return 4 * given.ff - 4 * given.fd + given.dd; }
};

// The Hessian of an energy in the space of Jacobians, made positive semidefinite but for a part of what makes it
// indefinite, and its gradient.
struct Jacobian_hessian
{
  std::array<double, 4> gradient;                   // in the coordinates Re z, Im z, Re w, Im w
  std::array<std::array<double, 4>, 4> hessian;

  template <class Energy>
  static Jacobian_hessian of(const Energy& energy, const Jacobian& j, double indefinite_part)
  {
    const Energy_derivatives e(energy, j);
    Jacobian_hessian result;
    result.gradient = { 2 * e.by_a() * j.zx, 2 * e.by_a() * j.zy, 2 * e.by_b() * j.wx, 2 * e.by_b() * j.wy };
    if constexpr (Energy::is_scale_invariant) {
      const Beltrami_coefficient mu(j);
      result.set_gauss_newton(e.a * e.by_b(), e.a * e.a * e.by_bb(), mu);
      result.add_second_order_term(indefinite_part * e.a * e.by_b(), mu);
    } else
      result.set_projected(e, j, indefinite_part);
    return result;
  }

  // Each part of the energy has the Hessian that suits it.
  template <class Energy, class Part>
  static Jacobian_hessian of(const Bounded_energy_2<Energy, Part>& sum, const Jacobian& j, double indefinite_part)
  {
    typedef Bounded_energy_2<Energy, Part>   Sum;
    Jacobian_hessian result = of(sum.energy, j, indefinite_part);
    const Jacobian_hessian bound = of(typename Sum::Bound(), j, indefinite_part);
    for (int i = 0; i < 4; ++i) {
      result.gradient[i] += Sum::part * bound.gradient[i];
      for (int k = 0; k < 4; ++k)
        result.hessian[i][k] += Sum::part * bound.hessian[i][k];
    }
    return result;
  }

private:
  // mu = w / z, and d mu = p dw + q dz with p = 1 / z and q = -mu / z.
  struct Beltrami_coefficient
  {
    double mx, my, px, py, qx, qy;

    explicit Beltrami_coefficient(const Jacobian& j)
    {
      const double inverse = 1 / j.squared_z();
      px = j.zx * inverse;
      py = -j.zy * inverse;
      mx = j.wx * px - j.wy * py;
      my = j.wx * py + j.wy * px;
      qx = my * py - mx * px;
      qy = -mx * py - my * px;
    }
  };

  // The Gauss-Newton Hessian in the Beltrami coefficient mu, of which every scale-invariant energy is a function
  // f(|mu|^2), with the derivatives f1 and f2. A conformal map of the plane moves z at random but hardly changes mu,
  // and costs hardly any energy; the projected Hessian makes such moves twice as stiff as they are on average, this one
  // does not, and Newton's method needs a fraction of the steps.
  void set_gauss_newton(double f1, double f2, const Beltrami_coefficient& mu)
  {
    const auto& [mx, my, px, py, qx, qy] = mu;
    const double kxx = 2 * f1 + 4 * f2 * mx * mx, kxy = 4 * f2 * mx * my, kyy = 2 * f1 + 4 * f2 * my * my;
    const std::array<double, 4> dx = { qx, -qy, px, -py }, dy = { qy, qx, py, px };
    for (int i = 0; i < 4; ++i) {
      const double kx = kxx * dx[i] + kxy * dy[i], ky = kxy * dx[i] + kyy * dy[i];
      for (int j = 0; j < 4; ++j)
        hessian[i][j] = kx * dx[j] + ky * dy[j];
    }
  }

  // What the Gauss-Newton Hessian lacks, with f1 of the part that is wanted: the second derivatives of mu,
  //
  //   Re(4 f1 conj(mu) (mu dz^2 - dz dw) / z^2).
  //
  // Without it, Newton's method converges by a factor of 5 to 10 a step, with half of it by 30 to 40. The sum is
  // indefinite; with all of it, the Hessian is the true one.
  void add_second_order_term(double f1, const Beltrami_coefficient& mu)
  {
    // zz = 4 f1 |mu|^2 p^2 and zw = 4 f1 conj(mu) p^2
    const double factor = 4 * f1, x = factor * (mu.px * mu.px - mu.py * mu.py), y = 2 * factor * mu.px * mu.py,
                 squared_mu = mu.mx * mu.mx + mu.my * mu.my;
    const double zz_x = squared_mu * x, zz_y = squared_mu * y, zw_x = mu.mx * x + mu.my * y,
                 zw_y = mu.mx * y - mu.my * x;
    add_symmetric(0, 0, zz_x);
    add_symmetric(1, 1, -zz_x);
    add_symmetric(0, 1, -zz_y);
    add_symmetric(0, 2, -0.5 * zw_x);
    add_symmetric(1, 3, 0.5 * zw_x);
    add_symmetric(0, 3, 0.5 * zw_y);
    add_symmetric(1, 2, 0.5 * zw_y);
  }

  void add_symmetric(int i, int j, double value)
  {
    hessian[i][j] += value;
    if (i != j)
      hessian[j][i] += value;
  }

  // The Hessian with its negative eigenvalues replaced by 0. They are known in closed form (Smith, De Goes, Kim 2019,
  // in other variables): twice the first derivatives across z (the twist) and across w (the flip), and those of a 2x2
  // block along z and w (the stretch).
  //
  // The integral of the determinant depends on the border only, so a move of the interior changes |z|^2 and |w|^2 by
  // the same amount in the sum over all triangles: where the twist is negative the flip makes up for it, and the sum
  // stays positive as long as the flip is the greater one of the two. So a negative twist is kept up to the part
  // `indefinite_part` of the flip. Where the two vary from triangle to triangle this is no proof.
  void set_projected(const Energy_derivatives& e, const Jacobian& jacobian, double indefinite_part)
  {
    const double abs_z = std::sqrt(e.a), abs_w = std::sqrt(e.b);
    double zz = 2 * e.by_a() + 4 * e.by_aa() * e.a, zw = 4 * e.by_ab() * abs_z * abs_w,
           ww = 2 * e.by_b() + 4 * e.by_bb() * e.b;
    project(zz, zw, ww);
    const double flip = (std::max)(2 * e.by_b(), 0.), twist = (std::max)(2 * e.by_a(), -indefinite_part * flip);

    const double z[2] = { abs_z > 0 ? jacobian.zx / abs_z : 1, abs_z > 0 ? jacobian.zy / abs_z : 0 },
                 w[2] = { abs_w > 0 ? jacobian.wx / abs_w : 1, abs_w > 0 ? jacobian.wy / abs_w : 0 };
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) {
        hessian[i][j] = (zz - twist) * z[i] * z[j] + (i == j ? twist : 0);
        hessian[i][2 + j] = zw * z[i] * w[j];
        hessian[2 + i][j] = zw * w[i] * z[j];
        hessian[2 + i][2 + j] = (ww - flip) * w[i] * w[j] + (i == j ? flip : 0);
      }
  }

  // Replaces a symmetric matrix by the nearest positive semidefinite one.
  static void project(double& xx, double& xy, double& yy)
  {
    const double mean = 0.5 * (xx + yy), difference = 0.5 * (xx - yy),
                 radius = std::sqrt(difference * difference + xy * xy);
    const double least = mean - radius, greatest = mean + radius;
    if (least >= 0)
      return;
    const double factor = greatest > 0 ? greatest / (2 * radius) : 0;
    xx = factor * (xx - least);
    yy = factor * (yy - least);
    xy = factor * xy;
  }
};

// The Jacobian seen from a corner V. `va` and `vb` lead from its image to those of A and B.
struct Corner_jacobian
  : Jacobian
{
  // Gradients of the hat functions with V over the edge AB, which lies on the axis: V's is (0, g), B's is (bx, by), A's
  // minus their sum.
  double g, bx, by;

  Corner_jacobian(const Rest_corner& corner, const Vector_2& va, const Vector_2& vb)
  {
    const double inverse_base = std::sqrt(0.5 * corner.height * corner.inverse_area);
    g = inverse_base / corner.height;
    bx = inverse_base;
    by = -corner.foot * g;
    const double ax = -bx, ay = -by - g;
    zx = 0.5 * (va.x() * ax + va.y() * ay + vb.x() * bx + vb.y() * by);
    zy = 0.5 * (va.y() * ax - va.x() * ay + vb.y() * bx - vb.x() * by);
    wx = 0.5 * (va.x() * ax - va.y() * ay + vb.x() * bx - vb.y() * by);
    wy = 0.5 * (va.y() * ax + va.x() * ay + vb.y() * bx + vb.x() * by);
    determinant = 0.5 * corner.inverse_area * cross(va, vb);
  }
};

// The gradient for V.
// Precondition: the triangle is positive, or the energy takes others too.
template <class Energy>
Block_vector corner_gradient(const Energy& energy, const Rest_corner& corner, double weight, const Vector_2& va,
                             const Vector_2& vb)
{
  const Corner_jacobian j(corner, va, vb);
  const Energy_derivatives e(energy, j);
  return weight * j.g * Block_vector(e.by_b() * j.wy - e.by_a() * j.zy, e.by_a() * j.zx - e.by_b() * j.wx);
}

// The part `indefinite_part` of what makes the Hessian indefinite is kept.
// Precondition: as above.
template <class Energy>
Corner_hessian corner_hessian(const Energy& energy, const Rest_corner& corner, double weight, const Vector_2& va,
                              const Vector_2& vb, double indefinite_part = 0)
{
  const Corner_jacobian jacobian(corner, va, vb);
  const Jacobian_hessian h = Jacobian_hessian::of(energy, jacobian, indefinite_part);

  // A move (x, y) of V changes z and w by g (y, -x) / 2 and g (-y, x) / 2; one of B by conj(G) (x + iy) / 2 and G (x +
  // iy) / 2.
  const double scale = 0.5 * jacobian.g * weight;
  Corner_hessian result;
  result.gradient = { scale * (h.gradient[3] - h.gradient[1]), scale * (h.gradient[0] - h.gradient[2]) };
  Block_vector to_v[2], to_b[2];      // row by row
  for (int i = 0; i < 2; ++i) {
    double row[4];
    for (int j = 0; j < 4; ++j)
      row[j] = scale * (i == 0 ? h.hessian[3][j] - h.hessian[1][j] : h.hessian[0][j] - h.hessian[2][j]);
    to_v[i] = 0.5 * jacobian.g * Block_vector(row[3] - row[1], row[0] - row[2]);
    to_b[i] = 0.5 * Block_vector(jacobian.bx * (row[0] + row[2]) + jacobian.by * (row[3] - row[1]),
                                 jacobian.bx * (row[1] + row[3]) + jacobian.by * (row[0] - row[2]));
  }
  result.to_v = Block(to_v[0].x, to_v[0].y, to_v[1].x, to_v[1].y);
  result.to_b = Block(to_b[0].x, to_b[0].y, to_b[1].x, to_b[1].y);
  return result;
}

} // namespace CGAL::Surface_mesh_parameterization::internal

#endif // CGAL_SURFACE_MESH_PARAMETERIZATION_INTERNAL_NEWTON_CORNER_HESSIAN_H
