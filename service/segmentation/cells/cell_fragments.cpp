// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation/cells/cell_fragments.hpp"

#include <cmath>
#include <limits>

#include "segmentation/cells/cell_clustering.hpp"

namespace cleave::segmentation {
namespace {

constexpr std::uint32_t none = CellClusterer::no_owner;
constexpr std::uint32_t min_own_supervoxel = 3;  // cells

float distance(const CellImage& cells, std::size_t i, std::size_t j,
               const SupervoxelOptions& options) {
  const float dx = cells.x[i] - cells.x[j];
  const float dy = cells.y[i] - cells.y[j];
  const float dz = cells.z[i] - cells.z[j];
  const float cosine = cells.normal_x[i] * cells.normal_x[j] +
                       cells.normal_y[i] * cells.normal_y[j] +
                       cells.normal_z[i] * cells.normal_z[j];
  return options.normal_weight * (1 - cosine) +
         options.spatial_weight / options.seed_spacing_m * std::sqrt(dx * dx + dy * dy + dz * dz);
}

}  // namespace

// One pass over the image: a cell joins the pieces of the neighbours before it, which may turn out
// to be one piece.
void CellFragmentMender::find_pieces(const CellImage& cells, const CellLinks& links,
                                     const std::vector<std::uint32_t>& owner) {
  const auto steps = cells.steps();
  pieces_.clear();
  joined_.reset(0);
  piece_of_cell_.assign(cells.size(), none);
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    const std::size_t begin = cells.row_begin(row);
    for (std::size_t i = begin; i < begin + cells.columns; ++i) {
      if (!cells.occupied(i)) continue;
      std::uint32_t piece = none;
      for (std::size_t k = 0; k < steps.size(); ++k) {
        const std::size_t before = i - static_cast<std::size_t>(steps[k]);
        if ((links[before] >> k & 1) == 0 || owner[before] != owner[i]) continue;
        const std::uint32_t other = piece_of_cell_[before];
        if (piece == none) {
          piece = other;
        } else if (piece != other) {
          joined_.join(piece, other);
        }
      }
      if (piece == none) {
        piece = joined_.add();
        pieces_.push_back({.owner = owner[i], .cells = 0, .stays = false});
      }
      piece_of_cell_[i] = piece;
      ++pieces_[piece].cells;
    }
  }
  for (auto p = static_cast<std::uint32_t>(pieces_.size()); p-- > 0;) {
    const std::uint32_t r = joined_.root(p);
    if (r != p) pieces_[r].cells += pieces_[p].cells;
  }
}

void CellFragmentMender::decide_who_stays(std::uint32_t owners) {
  largest_piece_.assign(owners, none);
  for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
    Piece& piece = pieces_[p];
    if (joined_.root(p) != p) continue;
    piece.stays = piece.cells >= min_own_supervoxel;
    if (piece.owner == none) continue;
    std::uint32_t& largest = largest_piece_[piece.owner];
    if (largest == none || piece.cells > pieces_[largest].cells) largest = p;
  }
  for (const std::uint32_t p : largest_piece_) {
    if (p != none) pieces_[p].stays = true;
  }
}

// Cells of pieces that do not stay, from the outside in; each pass judges by the state before it.
void CellFragmentMender::settle_loose_cells(const CellImage& cells, const CellLinks& links,
                                            const SupervoxelOptions& options,
                                            std::vector<std::uint32_t>& supervoxel) {
  const auto steps = cells.steps();
  do {
    moves_.clear();
    still_loose_.clear();
    for (const std::uint32_t i : loose_) {
      float nearest = std::numeric_limits<float>::infinity();
      std::uint32_t home = none;
      const auto consider = [&](std::size_t j, bool linked) {
        if (!linked || !pieces_[supervoxel[j]].stays) return;
        const float d = distance(cells, i, j, options);
        if (d < nearest) {
          nearest = d;
          home = supervoxel[j];
        }
      };
      for (std::size_t k = 0; k < steps.size(); ++k) {
        const std::size_t after = i + static_cast<std::size_t>(steps[k]);
        const std::size_t before = i - static_cast<std::size_t>(steps[k]);
        consider(after, (links[i] >> k & 1) != 0);
        consider(before, (links[before] >> k & 1) != 0);
      }
      if (home == none) {
        still_loose_.push_back(i);
      } else {
        moves_.push_back({i, home});
      }
    }
    for (const Move& move : moves_) supervoxel[move.cell] = move.piece;
    loose_.swap(still_loose_);
  } while (!moves_.empty());
}

std::uint32_t CellFragmentMender::mend(const CellImage& cells, const CellLinks& links,
                                       const std::vector<std::uint32_t>& owner,
                                       std::uint32_t owners, const SupervoxelOptions& options,
                                       std::vector<std::uint32_t>& supervoxel) {
  find_pieces(cells, links, owner);
  decide_who_stays(owners);
  supervoxel.assign(cells.size(), none);
  loose_.clear();
  for (std::uint32_t row = 0; row < cells.rows; ++row) {
    const auto begin = static_cast<std::uint32_t>(cells.row_begin(row));
    for (std::uint32_t i = begin; i < begin + cells.columns; ++i) {
      if (!cells.occupied(i)) continue;
      supervoxel[i] = joined_.root(piece_of_cell_[i]);
      if (!pieces_[supervoxel[i]].stays) loose_.push_back(i);
    }
  }
  still_loose_.reserve(loose_.size());  // the two change places
  settle_loose_cells(cells, links, options, supervoxel);

  std::uint32_t count = 0;
  number_.assign(pieces_.size(), none);
  for (std::uint32_t& s : supervoxel) {
    if (s == none) continue;
    std::uint32_t& number = number_[s];
    if (number == none) number = count++;
    s = number;
  }
  return count;
}

}  // namespace cleave::segmentation
