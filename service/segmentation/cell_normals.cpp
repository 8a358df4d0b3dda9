#include "segmentation/cell_normals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "segmentation/multiversion.hpp"

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

// So many cells at a time: their sums stay in the nearest cache.
constexpr std::size_t block = 32;
static_assert(block <= std::size_t{2} * CellImage::border,
              "a row's last block must end before the next row");
using Lanes = std::array<float, block>;

// Weighted sums of offsets from the cell in the middle; q = 1/z.
struct Sums {
  Lanes w, u, v, q, uu, uv, vv, uq, vq, qq;
};

// From a block's first cell on.
struct Planes {
  float *a, *b, *c, *variance;
};

// Not inlined: GCC vectorises the loop only when it stands alone.
CLEAVE_MULTIVERSION
void add_neighbour(const float* __restrict u, const float* __restrict v, const float* __restrict q,
                   std::ptrdiff_t offset, float weight, float gate, Sums& __restrict sum) {
  const float* other_u = u + offset;
  const float* other_v = v + offset;
  const float* other_q = q + offset;
  for (std::size_t i = 0; i < block; ++i) {
    const float du = other_u[i] - u[i];
    const float dv = other_v[i] - v[i];
    const float dq = other_q[i] - q[i];
    const float w = std::abs(dq) < gate * q[i] ? weight : 0;
    const float wu = w * du;
    const float wv = w * dv;
    sum.w[i] += w;
    sum.u[i] += wu;
    sum.v[i] += wv;
    sum.q[i] += w * dq;
    sum.uu[i] += wu * du;
    sum.uv[i] += wu * dv;
    sum.vv[i] += wv * dv;
    sum.uq[i] += wu * dq;
    sum.vq[i] += wv * dq;
    sum.qq[i] += w * dq * dq;
  }
}

CLEAVE_MULTIVERSION
void fit_block(const float* u, const float* v, const float* q, const Neighbours& neighbours,
               const Planes& planes) {
  Sums sum{};
  sum.w.fill(own_weight);
  for (const auto& [offset, weight, gate] : neighbours) {
    add_neighbour(u, v, q, offset, weight, gate, sum);
  }

  Lanes a, b, c, variance;
  for (std::size_t i = 0; i < block; ++i) {
    const float share = 1 / sum.w[i];
    const float mean_u = sum.u[i] * share;
    const float mean_v = sum.v[i] * share;
    const float mean_q = sum.q[i] * share;
    const float uu = sum.uu[i] - sum.u[i] * mean_u;
    const float uv = sum.uv[i] - sum.u[i] * mean_v;
    const float vv = sum.vv[i] - sum.v[i] * mean_v;
    const float uq = sum.uq[i] - sum.q[i] * mean_u;
    const float vq = sum.vq[i] - sum.q[i] * mean_v;
    const float qq = sum.qq[i] - sum.q[i] * mean_q;
    const float determinant = uu * vv - uv * uv;
    const float trace = uu + vv;
    const bool spread = determinant > min_spread_ratio * trace * trace;
    const float scale = 1 / (spread ? determinant : 1.0F);
    const float slope_u = (uq * vv - vq * uv) * scale;
    const float slope_v = (vq * uu - uq * uv) * scale;
    const float residual = (qq - slope_u * uq - slope_v * vq) * share;
    // (a, b, c) points away from the sensor; (u, v, 1) is the ray through the cell.
    a[i] = spread ? slope_u : u[i];
    b[i] = spread ? slope_v : v[i];
    c[i] = spread ? q[i] + mean_q - slope_u * (u[i] + mean_u) - slope_v * (v[i] + mean_v) : 1.0F;
    variance[i] = spread ? (residual > 0 ? residual : 0.0F) : no_plane;
  }
  std::copy(a.begin(), a.end(), planes.a);
  std::copy(b.begin(), b.end(), planes.b);
  std::copy(c.begin(), c.end(), planes.c);
  std::copy(variance.begin(), variance.end(), planes.variance);
}

using Steps = std::array<std::ptrdiff_t, 8>;

CLEAVE_MULTIVERSION
void choose_block(const float* u, const float* v, const float* q, const Steps& steps,
                  const Planes& planes, float* __restrict normal_x, float* __restrict normal_y,
                  float* __restrict normal_z) {
  Lanes a, b, c, best;
  for (std::size_t i = 0; i < block; ++i) {
    a[i] = planes.a[i];
    b[i] = planes.b[i];
    c[i] = planes.c[i];
    best[i] = planes.variance[i] + variance_floor;
  }
  for (const std::ptrdiff_t step : steps) {
    const float* other_a = planes.a + step;
    const float* other_b = planes.b + step;
    const float* other_c = planes.c + step;
    const float* other_variance = planes.variance + step;
    for (std::size_t i = 0; i < block; ++i) {
      const float miss = other_a[i] * u[i] + other_b[i] * v[i] + other_c[i] - q[i];
      const float cost = foreign_penalty * (other_variance[i] + miss * miss + variance_floor);
      const bool better = cost < best[i];
      best[i] = better ? cost : best[i];
      a[i] = better ? other_a[i] : a[i];
      b[i] = better ? other_b[i] : b[i];
      c[i] = better ? other_c[i] : c[i];
    }
  }
  for (std::size_t i = 0; i < block; ++i) {
    const float towards = -1 / std::sqrt(a[i] * a[i] + b[i] * b[i] + c[i] * c[i]);
    normal_x[i] = a[i] * towards;
    normal_y[i] = b[i] * towards;
    normal_z[i] = c[i] * towards;
  }
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
