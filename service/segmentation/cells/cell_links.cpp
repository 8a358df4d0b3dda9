// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/cells/cell_links.hpp"

#include <cmath>

#include "segmentation/math/multiversion.hpp"

namespace cleave::segmentation {
namespace {

constexpr float gate = 0.01F;          // of 1/z
constexpr float grazing_gate = 0.04F;  // of 1/z
constexpr float plane_gate = 0.005F;   // of z

// Bits of the neighbours `step` away.
CLEAVE_MULTIVERSION
void link_row(const CellImage& cells, std::size_t begin, std::ptrdiff_t step, std::uint8_t bit,
              std::uint8_t* __restrict links) {
  const auto first = static_cast<std::ptrdiff_t>(begin);
  const float* x = cells.x.data() + first;
  const float* y = cells.y.data() + first;
  const float* z = cells.z.data() + first;
  const float* q = cells.inverse_depth.data() + first;
  const float* normal_x = cells.normal_x.data() + first;
  const float* normal_y = cells.normal_y.data() + first;
  const float* normal_z = cells.normal_z.data() + first;
  const auto count = static_cast<std::ptrdiff_t>(cells.columns);
  for (std::ptrdiff_t i = 0; i < count; ++i) {
    const std::ptrdiff_t j = i + step;
    const float dx = x[j] - x[i];
    const float dy = y[j] - y[i];
    const float dz = z[j] - z[i];
    const float off_own = std::abs(dx * normal_x[i] + dy * normal_y[i] + dz * normal_z[i]);
    const float off_other = std::abs(dx * normal_x[j] + dy * normal_y[j] + dz * normal_z[j]);
    const float dq = std::abs(q[j] - q[i]);
    const float mean_q = (q[j] + q[i]) / 2;  // negative where a cell is empty: no gate lets it in
    const float plane_gate_m = plane_gate * z[i];
    const int close = dq < gate * mean_q ? 1 : 0;
    const int on_own = off_own < plane_gate_m ? 1 : 0;
    const int on_other = off_other < plane_gate_m ? 1 : 0;
    const int grazing = dq < grazing_gate * mean_q ? on_own & on_other : 0;
    links[i] = static_cast<std::uint8_t>(links[i] | ((close | grazing) != 0 ? bit : 0));
  }
}

}  // namespace

void link_cells(const CellImage& cells, CellLinks& links) {
  links.assign(cells.size(), 0);
  const auto steps = cells.steps();
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    const std::size_t begin = cells.row_begin(row);
    for (std::size_t k = 0; k < steps.size(); ++k) {
      link_row(cells, begin, steps[k], static_cast<std::uint8_t>(1U << k), &links[begin]);
    }
  }
}

}  // namespace cleave::segmentation
