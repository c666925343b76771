// SPDX-License-Identifier: MIT
// Eigen's float product for one instruction set; one file per set, see CMakeLists.txt.
#ifndef SINEW_TESTS_BENCH_LINEAR_EIGEN_HPP
#define SINEW_TESTS_BENCH_LINEAR_EIGEN_HPP

// out [rows x outs] = in [rows x ins] * weights [ins x outs], row-major inputs, column-major weights. The product
// alone: neither bias nor activation, which the int16 kernels do have inside.
void eigen_avx2_product(const float* in, const float* weights, long rows, long ins, long outs, float* out);
void eigen_avx512_product(const float* in, const float* weights, long rows, long ins, long outs, float* out);

#endif
