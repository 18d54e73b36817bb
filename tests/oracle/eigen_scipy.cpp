// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <cstdlib>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "quadcut/spectral/eigensolver.hpp"
#include "quadcut/spectral/silhouette.hpp"
#include "tests/unit/io/scratch.hpp"
#include "tests/unit/spectral/test_graphs.hpp"
#include "tests/unit/spectral/test_samples.hpp"

// Eigenvalues against SciPy, silhouettes against scikit-learn: tests/oracle/spectral_oracle.py.

namespace quadcut {
namespace {

/// The numbers that the script prints; nothing when it cannot run here.
std::optional<std::vector<double>> ask_python(const io::test::ScratchFolder& folder,
                                              const std::string& question,
                                              const std::string& input) {
    const auto path = folder.write("input.txt", input);
    const std::string command = std::string(QUADCUT_PYTHON) +
                                " -B " QUADCUT_SOURCE_DIR "/tests/oracle/spectral_oracle.py " +
                                question + " " + path.string() + " > " +
                                (folder.path() / "answer.txt").string() + " 2> " +
                                (folder.path() / "errors.txt").string();
    if (std::system(command.c_str()) != 0) return std::nullopt;
    std::istringstream answer(io::read_file(folder.path() / "answer.txt"));
    std::vector<double> numbers;
    for (double number = 0.0; answer >> number;) numbers.push_back(number);
    return numbers;
}

std::string describe(const Graph& graph, const std::string& kind, std::size_t count) {
    std::ostringstream text;
    text << std::setprecision(17) << kind << ' ' << count << '\n';
    for (const double area : graph.area_m2) text << area << ' ';
    text << '\n';
    for (std::size_t i = 0; i < graph.num_nodes(); ++i) {
        const auto columns = graph.neighbours(i);
        const auto weights = graph.neighbour_weights(i);
        for (std::size_t k = 0; k < columns.size(); ++k) {
            if (columns[k] >= i) text << i << ' ' << columns[k] << ' ' << weights[k] << '\n';
        }
    }
    return text.str();
}

TEST(EigenScipyOracle, EigenvaluesOfAllKinds) {
    Random random(71);
    const io::test::ScratchFolder folder;
    const Graph graphs[] = {test::floor_graph(test::room_plan(4, 2, 8, test::Doors::none), 0.01),
                            test::floor_graph(test::room_plan(5, 4, 15, test::Doors::open), 0.0025),
                            test::random_graph(random, 600, 1.5),
                            test::random_graph(random, 1500, 0.2)};
    for (const Graph& graph : graphs) {
        for (const auto& [kind, name] : {std::pair(LaplacianKind::degree, "degree"),
                                         std::pair(LaplacianKind::unweighted, "unweighted"),
                                         std::pair(LaplacianKind::area, "area")}) {
            constexpr std::size_t kCount = 40;
            const auto expected = ask_python(folder, "eigenvalues", describe(graph, name, kCount));
            if (!expected) {
                GTEST_SKIP() << QUADCUT_PYTHON << " cannot run the oracle: "
                             << io::read_file(folder.path() / "errors.txt");
            }
            ASSERT_EQ(expected->size(), kCount);
            const Eigenpairs pairs = smallest_eigenpairs(graph, kind, kCount);
            ASSERT_EQ(pairs.size(), kCount);
            const double norm = Laplacian(graph, kind).norm_bound();
            for (std::size_t j = 0; j < kCount; ++j) {
                EXPECT_NEAR(pairs.values[j], (*expected)[j], 1e-9 * norm)
                    << name << ", pair " << j << ", " << graph.num_nodes() << " nodes";
            }
        }
    }
}

TEST(EigenScipyOracle, SilhouettesOfScikitLearn) {
    Random random(72);
    const io::test::ScratchFolder folder;
    const Embedding samples = test::blobs(300, 5, 4, 0.3, random);
    Clustering clusters{test::blob_labels(300, 5), 6};
    clusters.labels[17] = 5;  // alone in its cluster
    std::ostringstream text;
    text << std::setprecision(17);
    for (std::size_t i = 0; i < samples.num_samples; ++i) {
        text << clusters.labels[i];
        for (const double value : samples.row(i)) text << ' ' << value;
        text << '\n';
    }
    const auto expected = ask_python(folder, "silhouettes", text.str());
    if (!expected) {
        GTEST_SKIP() << QUADCUT_PYTHON
                     << " cannot run the oracle: " << io::read_file(folder.path() / "errors.txt");
    }
    const auto values = silhouettes(samples, clusters);
    ASSERT_EQ(values.size(), expected->size());
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], (*expected)[i], 1e-9);
}

}  // namespace
}  // namespace quadcut
