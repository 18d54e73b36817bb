# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
"""Reference answers for the spectral stage, from SciPy and scikit-learn.

    spectral_oracle.py eigenvalues FILE     FILE: kind count / areas / edges (a b weight), a line each
    spectral_oracle.py silhouettes FILE     FILE: samples, each its label and its coordinates

Prints one number a line. Exit code 3: a package is missing.
"""

import sys

try:
    import numpy as np
    import scipy.sparse as sparse
    import scipy.sparse.linalg as sparse_linalg
except ImportError as error:
    print(error, file=sys.stderr)
    sys.exit(3)


def laplacian(kind, area_m2, edges):
    n = len(area_m2)
    a, b, w = edges[:, 0].astype(int), edges[:, 1].astype(int), edges[:, 2]
    loop = a == b
    if kind == "unweighted":
        a, b, w, loop = a[~loop], b[~loop], np.ones(np.count_nonzero(~loop)), loop[~loop]
    W = sparse.coo_matrix((w, (a, b)), shape=(n, n)).tocsr()
    W = W + sparse.coo_matrix((w[~loop], (b[~loop], a[~loop])), shape=(n, n)).tocsr()
    d = np.asarray(W.sum(axis=1)).ravel()
    scale = sparse.diags(1.0 / np.sqrt(np.asarray(area_m2) if kind == "area" else d))
    return (scale @ (sparse.diags(d) - W) @ scale).tocsc()


def eigenvalues(path):
    with open(path, encoding="ascii") as file:
        kind, count = file.readline().split()
        area_m2 = [float(value) for value in file.readline().split()]
        edges = np.loadtxt(file, ndmin=2)
    matrix = laplacian(kind, area_m2, edges)
    # The shift lies below the spectrum, so that the matrix is definite; dense where that is quick.
    if matrix.shape[0] <= 800:
        values = np.linalg.eigvalsh(matrix.toarray())[: int(count)]
    else:
        norm = abs(matrix).sum(axis=1).max()
        values = sparse_linalg.eigsh(matrix, int(count), sigma=-1e-6 * norm,
                                     return_eigenvectors=False, tol=1e-12)
    return np.sort(values)


def silhouettes(path):
    try:
        from sklearn.metrics import silhouette_samples
    except ImportError as error:
        print(error, file=sys.stderr)
        sys.exit(3)
    table = np.loadtxt(path, ndmin=2)
    return silhouette_samples(table[:, 1:], table[:, 0].astype(int), metric="sqeuclidean")


if __name__ == "__main__":
    for number in {"eigenvalues": eigenvalues, "silhouettes": silhouettes}[sys.argv[1]](sys.argv[2]):
        print(repr(float(number)))
