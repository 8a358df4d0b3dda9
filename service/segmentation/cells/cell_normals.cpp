// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/cells/cell_normals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "segmentation/math/multiversion.hpp"
#include "segmentation/math/simd.hpp"

namespace cleave::segmentation {
namespace {

constexpr int radius = 2;                // cells
constexpr float gate_per_cell = 0.012F;  // of 1/z
constexpr float own_weight = 4;
// Of the covariance of (u, v), determinant to squared trace: below, the cells lie on a line.
constexpr float min_spread_ratio = 1e-3F;
constexpr float no_plane = 1;  // variance of 1/z: far above any plane's
// Half of the variance of a structured-light camera's 1/z: differences below it are chance.
constexpr float variance_floor = 4e-6F;
constexpr float foreign_penalty = 1.5F;  // a neighbour's plane must be clearly better

struct Neighbour {
  std::ptrdiff_t offset = 0;
  float weight = 0;
  float gate = 0;
};
using Neighbours = std::array<Neighbour, (2 * radius + 1) * (2 * radius + 1) - 1>;

Neighbours neighbours_of_a_cell(std::uint32_t stride) {
  Neighbours neighbours;
  auto next = neighbours.begin();
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      if (dx == 0 && dy == 0) continue;
      const int near = (radius + 1 - std::abs(dx)) * (radius + 1 - std::abs(dy));
      const int distance = std::max(std::abs(dx), std::abs(dy));
      *next++ = {.offset = dy * static_cast<std::ptrdiff_t>(stride) + dx,
                 .weight = own_weight * static_cast<float>(near) / ((radius + 1) * (radius + 1)),
                 .gate = gate_per_cell * static_cast<float>(distance)};
    }
  }
  return neighbours;
}

constexpr std::size_t block = 8;  // cells at a time
static_assert(block <= std::size_t{2} * CellImage::border,
              "a row's last block must end before the next row");

// From a block's first cell on.
struct Planes {
  float *a, *b, *c, *variance;
};

// Weighted sums of offsets from the cell in the middle; q = 1/z.
CLEAVE_MULTIVERSION
void fit_block(const float* u, const float* v, const float* q, const Neighbours& neighbours,
               const Planes& planes) {
  Float8 own_u, own_v, own_q;
  load(u, own_u);
  load(v, own_v);
  load(q, own_q);
  const Float8 zero = {};
  Float8 sum_w = zero + own_weight;
  Float8 sum_u = zero, sum_v = zero, sum_q = zero, sum_uu = zero, sum_uv = zero, sum_vv = zero;
  Float8 sum_uq = zero, sum_vq = zero, sum_qq = zero;
  for (const auto& [offset, weight, gate] : neighbours) {
    Float8 du, dv, dq;
    load(u + offset, du);
    load(v + offset, dv);
    load(q + offset, dq);
    du -= own_u;
    dv -= own_v;
    dq -= own_q;
    const Float8 limit = gate * own_q;
    const Float8 w = (dq < limit) & (dq > -limit) ? zero + weight : zero;
    const Float8 wu = w * du;
    const Float8 wv = w * dv;
    sum_w += w;
    sum_u += wu;
    sum_v += wv;
    sum_q += w * dq;
    sum_uu += wu * du;
    sum_uv += wu * dv;
    sum_vv += wv * dv;
    sum_uq += wu * dq;
    sum_vq += wv * dq;
    sum_qq += w * dq * dq;
  }

  const Float8 share = 1 / sum_w;
  const Float8 mean_u = sum_u * share;
  const Float8 mean_v = sum_v * share;
  const Float8 mean_q = sum_q * share;
  const Float8 uu = sum_uu - sum_u * mean_u;
  const Float8 uv = sum_uv - sum_u * mean_v;
  const Float8 vv = sum_vv - sum_v * mean_v;
  const Float8 uq = sum_uq - sum_q * mean_u;
  const Float8 vq = sum_vq - sum_q * mean_v;
  const Float8 qq = sum_qq - sum_q * mean_q;
  const Float8 determinant = uu * vv - uv * uv;
  const Float8 trace = uu + vv;
  const Int8 spread = determinant > min_spread_ratio * trace * trace;
  const Float8 scale = 1 / (spread ? determinant : zero + 1);
  const Float8 slope_u = (uq * vv - vq * uv) * scale;
  const Float8 slope_v = (vq * uu - uq * uv) * scale;
  const Float8 residual = (qq - slope_u * uq - slope_v * vq) * share;
  const Float8 at_sensor = own_q + mean_q - slope_u * (own_u + mean_u) - slope_v * (own_v + mean_v);
  // (a, b, c) points away from the sensor; (u, v, 1) is the ray through the cell.
  const Float8 a = spread ? slope_u : own_u;
  const Float8 b = spread ? slope_v : own_v;
  const Float8 c = spread ? at_sensor : zero + 1;
  const Float8 variance = spread ? (residual > 0 ? residual : zero) : zero + no_plane;
  store(a, planes.a);
  store(b, planes.b);
  store(c, planes.c);
  store(variance, planes.variance);
}

using Steps = std::array<std::ptrdiff_t, 8>;

CLEAVE_MULTIVERSION
void choose_block(const float* from_u, const float* from_v, const float* from_q, const Steps& steps,
                  const Planes& planes, float* normal_x, float* normal_y, float* normal_z) {
  Float8 u, v, q, a, b, c, best;
  load(from_u, u);
  load(from_v, v);
  load(from_q, q);
  load(planes.a, a);
  load(planes.b, b);
  load(planes.c, c);
  load(planes.variance, best);
  best += variance_floor;
  for (const std::ptrdiff_t step : steps) {
    Float8 other_a, other_b, other_c, other_variance;
    load(planes.a + step, other_a);
    load(planes.b + step, other_b);
    load(planes.c + step, other_c);
    load(planes.variance + step, other_variance);
    const Float8 miss = other_a * u + other_b * v + other_c - q;
    const Float8 cost = foreign_penalty * (other_variance + miss * miss + variance_floor);
    const Int8 better = cost < best;
    best = better ? cost : best;
    a = better ? other_a : a;
    b = better ? other_b : b;
    c = better ? other_c : c;
  }
  Float8 length = a * a + b * b + c * c;
  square_root(length);
  const Float8 towards = -1 / length;
  store(Float8(a * towards), normal_x);
  store(Float8(b * towards), normal_y);
  store(Float8(c * towards), normal_z);
}

}  // namespace

void CellNormalEstimator::estimate(CellImage& cells) {
  for (auto* component : {&a_, &b_, &c_, &cells.normal_x, &cells.normal_y, &cells.normal_z}) {
    component->resize(cells.size());
  }
  variance_.assign(cells.size(), no_plane);
  const auto for_blocks = [&](auto&& work) {
    for (std::uint32_t row = 0; row < cells.rows; ++row) {
      for (std::uint32_t column = 0; column < cells.columns; column += block) {
        const std::size_t i = cells.row_begin(row) + column;
        work(i, Planes{&a_[i], &b_[i], &c_[i], &variance_[i]});
      }
    }
  };
  const Neighbours neighbours = neighbours_of_a_cell(cells.stride);
  for_blocks([&](std::size_t i, const Planes& planes) {
    fit_block(&cells.u[i], &cells.v[i], &cells.inverse_depth[i], neighbours, planes);
  });

  const auto [east, south_west, south, south_east] = cells.steps();
  const Steps steps = {-south_east, -south,     -south_west, -east,
                       east,        south_west, south,       south_east};
  for_blocks([&](std::size_t i, const Planes& planes) {
    choose_block(&cells.u[i], &cells.v[i], &cells.inverse_depth[i], steps, planes,
                 &cells.normal_x[i], &cells.normal_y[i], &cells.normal_z[i]);
  });
}

}  // namespace cleave::segmentation
