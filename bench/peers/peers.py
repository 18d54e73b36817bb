#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""One solver of SciPy's or scikit-learn's on a graph that the program `peers` wrote.

  peers.py METHOD GRAPH COUNT       one line of JSON; only the solve is timed
"""

import json
import sys
import time
import warnings

import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as linalg

# Just below zero, where L - sigma I can be factorised.
SIGMA = -1e-6


def read_graph(path):
    with open(path, "rb") as file:
        num_nodes, num_entries = (int(n) for n in np.fromfile(file, np.uint64, 2))
        row_begin = np.fromfile(file, np.uint64, num_nodes + 1).astype(np.int32)
        columns = np.fromfile(file, np.uint32, num_entries).astype(np.int32)
        weights = np.fromfile(file, np.float64, num_entries)
    return sp.csr_matrix((weights, columns, row_begin), shape=(num_nodes, num_nodes))


def laplacian(weights):
    """I - D^-1/2 W D^-1/2"""
    scale = sp.diags(1.0 / np.sqrt(np.asarray(weights.sum(axis=1)).ravel()))
    return (sp.identity(weights.shape[0]) - scale @ weights @ scale).tocsc()


def arpack(matrix, count):
    """eigsh as its documentation has it; SuperLU orders by COLAMD."""
    return linalg.eigsh(matrix, count, sigma=SIGMA)


def arpack_minimum_degree(matrix, count):
    """The same with a symmetric minimum-degree ordering, which eigsh cannot be asked for."""
    size = matrix.shape[0]
    shifted = matrix - SIGMA * sp.identity(size, format="csc")
    factor = linalg.splu(shifted, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                         options={"SymmetricMode": True})
    inverse = linalg.LinearOperator((size, size), factor.solve)
    return linalg.eigsh(matrix, count, sigma=SIGMA, OPinv=inverse)


def spectral_clustering(weights, count):
    from sklearn.cluster import SpectralClustering
    solver = SpectralClustering(count, affinity="precomputed", random_state=0)
    return lambda: solver.fit(weights)


def timed(work):
    wall, cpu = time.perf_counter(), time.process_time()
    answer = work()
    return answer, {"wall_s": time.perf_counter() - wall, "cpu_s": time.process_time() - cpu}


def main():
    method, path, count = sys.argv[1], sys.argv[2], int(sys.argv[3])
    warnings.simplefilter("ignore")
    weights = read_graph(path)
    if method == "sklearn":
        _, report = timed(spectral_clustering(weights, count))
    else:
        solve = {"arpack": arpack, "arpack-mmd": arpack_minimum_degree}[method]
        matrix = laplacian(weights)
        (values, vectors), report = timed(lambda: solve(matrix, count))
        residuals = np.linalg.norm(matrix @ vectors - vectors * values, axis=0)
        report["values"] = sorted(values.tolist())
        report["largest_residual"] = float(residuals.max())
    print(json.dumps(report))


if __name__ == "__main__":
    main()
