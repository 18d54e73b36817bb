// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers

// The product of a sparse matrix and a block of vectors: what Laplacian::apply() does, in the same
// order and without fused operations, so the same bits.
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF

// A work-item makes the entry of one row and one vector.
__kernel void multiply(__global const double* diagonal, __global const ulong* row_begin,
                       __global const uint* row_length, __global const uint* columns,
                       __global const double* values, __global const double* block, __global double* result, uint num_rows) {
    const uint row = (uint)get_global_id(0);
    if (row >= num_rows) return;
    const size_t vector = get_global_id(1) * num_rows;
    double sum = diagonal[row] * block[vector + row];
    const ulong end = row_begin[row] + row_length[row];
    for (ulong k = row_begin[row]; k < end; ++k) {
        sum += values[k] * block[vector + columns[k]];
    }
    result[vector + row] = sum;
}
