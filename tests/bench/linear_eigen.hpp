// SPDX-License-Identifier: MIT
// Eigen's float layer for one instruction set; one file per set, see CMakeLists.txt.
#ifndef SINEW_TESTS_BENCH_LINEAR_EIGEN_HPP
#define SINEW_TESTS_BENCH_LINEAR_EIGEN_HPP

// out [rows x outs] = in [rows x ins] * weights [ins x outs], row-major rows, column-major weights; with `bias` (or
// null: the product alone) max(out + bias, 0).
void eigen_avx2_layer(const float* in, const float* weights, const float* bias, long rows, long ins, long outs,
                      float* out);
void eigen_avx512_layer(const float* in, const float* weights, const float* bias, long rows, long ins, long outs,
                        float* out);

#endif
