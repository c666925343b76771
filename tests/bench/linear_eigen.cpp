// SPDX-License-Identifier: MIT
// Compiled twice with other instruction sets. Eigen is given another namespace each time (-DEigen=...), because the
// linker would otherwise keep one of the two copies of every template for both.
#include "linear_eigen.hpp"

#define EIGEN_DONT_PARALLELIZE
#include <Eigen/Core>

void SINEW_EIGEN_LAYER(const float* in, const float* weights, const float* bias, long rows, long ins, long outs,
                       float* out) {
  using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Columns = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic>;
  Eigen::Map<Rows> y(out, rows, outs);
  y.noalias() = Eigen::Map<const Rows>(in, rows, ins) * Eigen::Map<const Columns>(weights, ins, outs);
  if (bias != nullptr) y = (y.rowwise() + Eigen::Map<const Eigen::RowVectorXf>(bias, outs)).cwiseMax(0.0f);
}
