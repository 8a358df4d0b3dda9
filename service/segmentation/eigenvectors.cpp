#include "segmentation/eigenvectors.hpp"

#include <Spectra/SymEigsShiftSolver.h>

#include <Eigen/CholmodSupport>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <algorithm>

namespace cleave::segmentation {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

// Measured crossings: below the first the dense solver is fastest, above the second CHOLMOD is.
constexpr std::size_t max_dense_vertices = 40;
constexpr std::size_t min_cholmod_vertices = 300;

// L is singular; L + shift I is not, and its inverse turns small eigenvalues into large ones.
constexpr double shift = 1e-3;
constexpr double tolerance = 1e-3;
constexpr Eigen::Index max_restarts = 300;

Matrix shifted_laplacian(std::size_t vertices, const std::vector<WeightedEdge>& edges) {
  std::vector<Eigen::Triplet<double, int>> lower;
  lower.reserve(3 * edges.size() + vertices);
  const auto add = [&](std::uint32_t row, std::uint32_t column, double value) {
    lower.emplace_back(static_cast<int>(row), static_cast<int>(column), value);
  };
  for (const WeightedEdge& edge : edges) {
    add(std::max(edge.first, edge.second), std::min(edge.first, edge.second), -edge.weight);
    add(edge.first, edge.first, edge.weight);
    add(edge.second, edge.second, edge.weight);
  }
  for (std::uint32_t v = 0; v < vertices; ++v) add(v, v, shift);
  Matrix matrix(static_cast<Eigen::Index>(vertices), static_cast<Eigen::Index>(vertices));
  matrix.setFromTriplets(lower.begin(), lower.end());
  return matrix;
}

// y = (L + shift I)^-1 x, in the form that Spectra asks for.
template <typename Factorisation>
class ShiftInverse {
 public:
  using Scalar = double;

  ShiftInverse(const Factorisation& factorisation, Eigen::Index size)
      : factorisation_(factorisation), size_(size) {}
  [[nodiscard]] Eigen::Index rows() const { return size_; }
  [[nodiscard]] Eigen::Index cols() const { return size_; }
  void set_shift(double) {}  // it is in the factorisation
  void perform_op(const double* x, double* y) const {
    Eigen::Map<Eigen::VectorXd>(y, size_) =
        factorisation_.solve(Eigen::Map<const Eigen::VectorXd>(x, size_));
  }

 private:
  const Factorisation& factorisation_;
  Eigen::Index size_;
};

// Any vector will do that is not orthogonal to one that is sought; a fixed one repeats the result.
Eigen::VectorXd start_vector(Eigen::Index size) {
  return Eigen::VectorXd::LinSpaced(size, -1, 1).array().sin() + 0.01;
}

template <typename Factorisation>
Eigen::MatrixXd lanczos(const Factorisation& factorisation, Eigen::Index size,
                        Eigen::Index wanted) {
  ShiftInverse<Factorisation> inverse(factorisation, size);
  const Eigen::Index basis = std::min(size, std::max<Eigen::Index>(2 * wanted + 1, 20));
  Spectra::SymEigsShiftSolver solver(inverse, wanted, basis, -shift);
  const Eigen::VectorXd start = start_vector(size);
  solver.init(start.data());
  solver.compute(Spectra::SortRule::LargestMagn, max_restarts, tolerance,
                 Spectra::SortRule::SmallestAlge);
  return solver.eigenvectors();
}

Eigen::MatrixXd sparse_eigenvectors(const Matrix& lower, Eigen::Index wanted) {
  if (lower.rows() < static_cast<Eigen::Index>(min_cholmod_vertices)) {
    return lanczos(Eigen::SimplicialLDLT<Matrix>(lower), lower.rows(), wanted);
  }
  Eigen::CholmodSimplicialLLT<Matrix> factorisation;
  // One ordering, and it is deterministic; by default CHOLMOD tries several.
  factorisation.cholmod().nmethods = 1;
  factorisation.cholmod().method[0].ordering = CHOLMOD_AMD;
  factorisation.compute(lower);
  return lanczos(factorisation, lower.rows(), wanted);
}

}  // namespace

Eigen::MatrixXd laplacian_eigenvectors(std::size_t vertices, const std::vector<WeightedEdge>& edges,
                                       std::uint32_t wanted) {
  const Matrix lower = shifted_laplacian(vertices, edges);
  const Eigen::Index with_trivial = Eigen::Index{wanted} + 1;
  if (vertices <= max_dense_vertices || with_trivial >= lower.rows()) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver{Eigen::MatrixXd(lower)};
    return solver.eigenvectors().middleCols(1, std::min(with_trivial, lower.rows()) - 1);
  }
  // The trivial vector has by far the largest eigenvalue of the inverse and is found first.
  const Eigen::MatrixXd found = sparse_eigenvectors(lower, with_trivial);
  return found.rightCols(std::max<Eigen::Index>(found.cols() - 1, 0));
}

}  // namespace cleave::segmentation
