// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "bench/data_map.hpp"
#include "opencl/accelerator.hpp"
#include "opencl/trial.hpp"
#include "quadcut/base/random.hpp"
#include "quadcut/map/leaf_table.hpp"
#include "quadcut/segment/options.hpp"
#include "quadcut/segment/segment.hpp"
#include "quadcut/spectral/eigensolver.hpp"
#include "sim/building.hpp"
#include "tests/unit/paper/small_map.hpp"

#ifdef __SANITIZE_ADDRESS__
// Read by the address sanitizer: what PoCL and its compiler keep to the end is not ours.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libpocl\nleak:libLLVM\nleak:libclang\n";
}
#endif

/// The OpenCL device (PoCL, where there is no other) against the CPU, bit for bit.
namespace quadcut::opencl {
namespace {

constexpr std::array<SelfLoops, 3> kLoops{SelfLoops::none, SelfLoops::own_weight,
                                          SelfLoops::largest_weight};

/// Where PoCL keeps what it compiled: never in the home of whoever runs the tests.
const bool kHasCache = ::setenv("POCL_CACHE_DIR", QUADCUT_POCL_CACHE, 0) == 0;

/// Whether there is an OpenCL platform that can be asked for its devices; PoCL aborts without /sys.
/// Asked in another process, so that the driver is not in use when the device is tried.
bool has_platform() {
    try {
        const auto find_or_end = []() noexcept {
            (void)Device::find("libOpenCL.so.1", true, Fault::none);
        };
        try_in_own_process(find_or_end, 60);
        return true;
    } catch (const DeviceError&) {
        return false;
    }
}

/// Skips a test where there is no OpenCL platform.
class OpenClDevice : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(kHasCache);
        static const bool kHasPlatform = has_platform();
        if (!kHasPlatform) GTEST_SKIP() << "no OpenCL platform that works: pocl-opencl-icd, /sys";
    }

    [[nodiscard]] DeviceNote note() {
        return [this](const std::string& reason) { notes.push_back(reason); };
    }

    std::vector<std::string> notes;
    OpenClAccelerator device{{.accept_cpu = true}, note()};
};

/// Failures, each of which has to be noted.
using OpenClFailure = OpenClDevice;

std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint64_t>> bits_of(
    const std::vector<WeightedEdge>& edges) {
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint64_t>> bits;
    bits.reserve(edges.size());
    for (const WeightedEdge& edge : edges) {
        bits.emplace_back(edge.a, edge.b, std::bit_cast<std::uint64_t>(edge.weight));
    }
    return bits;
}

void expect_same_edges(OpenClAccelerator& device, const LeafTable& table,
                       const std::vector<LeafId>& nodes, double resolution_m, SelfLoops loops) {
    const auto found = device.sight_edges(table, nodes, resolution_m, loops);
    ASSERT_TRUE(found.has_value());
    ASSERT_EQ(bits_of(*found), bits_of(sight_edges(table, nodes, resolution_m, loops)));
}

GridMap furnished_building(std::uint64_t seed, int num_rooms) {
    sim::BuildingOptions options;
    options.seed = seed;
    options.num_rooms = num_rooms;
    options.furniture = 0.5;
    options.yaw_rad = seed % 2 == 0 ? 0.0 : 0.3;
    return sim::generate_building(options).map;
}

Graph graph_of(const FreeLeaves& leaves, double resolution_m) {
    return build_graph(sight_edges(leaves.table, leaves.nodes, resolution_m),
                       leaf_areas_m2(leaves.table, leaves.nodes, resolution_m));
}

TEST_F(OpenClDevice, EdgesOfRandomMaps) {
    Random random(161);
    std::size_t num_edges = 0;
    for (int round = 0; round < 300; ++round) {
        const std::int32_t side = std::int32_t{8} << random.below(5);
        const LeafTable table =
            test::table_of(test::random_map(random, side, random.uniform(0.0, 0.2)));
        const std::vector<LeafId> nodes = test::free_leaves(table);
        if (nodes.empty()) continue;
        const double resolution_m = random.uniform(0.01, 0.3);
        expect_same_edges(device, table, nodes, resolution_m, kLoops[random.below(3)]);
        ASSERT_FALSE(HasFatalFailure()) << "round " << round;
        num_edges += nodes.size();
    }
    EXPECT_GT(num_edges, 10'000U);
    EXPECT_EQ(notes, std::vector<std::string>{});
}

TEST_F(OpenClDevice, EdgesOfRegionsOfRandomMaps) {
    Random random(162);
    for (int round = 0; round < 100; ++round) {
        const LeafTable table =
            test::table_of(test::random_map(random, 64, random.uniform(0.0, 0.1)));
        std::vector<LeafId> region = test::free_leaves(table);
        std::erase_if(region, [&](LeafId) { return random.below(3) == 0; });
        if (region.empty()) continue;
        expect_same_edges(device, table, region, 0.05, kLoops[random.below(3)]);
        ASSERT_FALSE(HasFatalFailure()) << "round " << round;
    }
}

TEST_F(OpenClDevice, EdgesThatComeDownInManyParts) {
    Random random(163);
    const LeafTable table = test::table_of(test::random_map(random, 512, 0.05));
    const std::vector<LeafId> nodes = test::free_leaves(table);
    expect_same_edges(device, table, nodes, 0.05, SelfLoops::own_weight);
    // 1 MB a part.
    EXPECT_GT(device.traffic().bytes_down, std::size_t{4} << 20U);
}

TEST_F(OpenClDevice, TrafficIsAsEstimated) {
    Random random(167);
    const LeafTable table = test::table_of(test::random_map(random, 256, 0.05));
    const std::vector<LeafId> nodes = test::free_leaves(table);
    const auto edges = device.sight_edges(table, nodes, 0.05, SelfLoops::own_weight);
    ASSERT_TRUE(edges.has_value());
    const StageWork work = edge_stage({nodes.size(), table.leaves().size(), edges->size(),
                                       table.directory().values.size(), table.tiles().size()});
    EXPECT_EQ(static_cast<double>(device.traffic().bytes_down), work.bytes_down);
    // The table of weights and the map's extent are not in the estimate.
    EXPECT_NEAR(static_cast<double>(device.traffic().bytes_up), work.bytes_up, 8300.0);
}

TEST_F(OpenClDevice, EdgesOfLargeLeavesBesideSmallOnes) {
    test::States states(Cell{-2048, 0}, 2048, 2048, CellState::free);
    Random random(164);
    for (int i = 0; i < 40; ++i) {
        states.values[random.below(states.values.size())] = CellState::occupied;
    }
    const LeafTable table = test::table_of(states);
    expect_same_edges(device, table, test::free_leaves(table), 0.05, SelfLoops::largest_weight);
}

TEST_F(OpenClDevice, EdgesOfOneLeafAndOfLeavesThatSeeNone) {
    const LeafTable one = test::table_of(test::map_from_text({"."}));
    for (const SelfLoops loops : kLoops) {
        expect_same_edges(device, one, test::free_leaves(one), 0.05, loops);
    }
    const LeafTable table = test::table_of(test::map_from_text({".#.#", "####", ".#.#", "####"}));
    for (const SelfLoops loops : kLoops) {
        expect_same_edges(device, table, test::free_leaves(table), 0.05, loops);
    }
}

TEST_F(OpenClDevice, EdgesOfSimulatedBuildings) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const FreeLeaves leaves = free_leaves(furnished_building(seed, 12));
        expect_same_edges(device, leaves.table, leaves.nodes, 0.05, SelfLoops::own_weight);
    }
}

TEST_F(OpenClDevice, EdgesOfTheDataSlow) {
    const std::vector<DataMap> maps = read_data_maps();
    if (maps.empty()) GTEST_SKIP() << "no ../shared/data";
    for (const DataMap& map : maps) {
        const FreeLeaves leaves = free_leaves(map.map);
        expect_same_edges(device, leaves.table, leaves.nodes, map.map.resolution_m,
                          SelfLoops::own_weight);
        ASSERT_FALSE(HasFatalFailure()) << map.name;
    }
}

TEST_F(OpenClDevice, ProductsHaveTheBitsOfTheCpu) {
    const FreeLeaves leaves = free_leaves(furnished_building(5, 6));
    const Graph graph = graph_of(leaves, 0.05);
    Random random(165);
    for (const LaplacianKind kind :
         {LaplacianKind::degree, LaplacianKind::unweighted, LaplacianKind::area}) {
        const Laplacian laplacian(graph, kind);
        // One vector, a whole part, a part begun, and more parts than are on their way at a time.
        for (const std::size_t num_vectors : {1U, 4U, 6U, 31U}) {
            std::vector<double> block(num_vectors * laplacian.size());
            for (double& value : block) value = random.uniform(-1.0, 1.0);
            std::vector<double> expected(block.size());
            std::vector<double> found(block.size());
            laplacian.apply_block(block, expected);
            laplacian.apply_block(block, found, {1, &device});
            ASSERT_EQ(found, expected);
        }
    }
    EXPECT_EQ(notes, std::vector<std::string>{});
}

TEST_F(OpenClDevice, EigenpairsAreThoseOfTheCpu) {
    const FreeLeaves leaves = free_leaves(furnished_building(6, 6));
    const Graph graph = graph_of(leaves, 0.05);
    const Eigenpairs expected = smallest_eigenpairs(graph, LaplacianKind::degree, 12);
    const Eigenpairs found =
        smallest_eigenpairs(graph, LaplacianKind::degree, 12, {}, {1, &device});
    EXPECT_EQ(found.values, expected.values);
    EXPECT_EQ(found.vectors, expected.vectors);
    EXPECT_EQ(found.residuals, expected.residuals);
    EXPECT_EQ(notes, std::vector<std::string>{});
}

TEST_F(OpenClDevice, RoomsAreThoseOfTheCpu) {
    const GridMap map = furnished_building(7, 6);
    SegmentOptions options;
    options.preset = Preset::paper;
    options.paper.num_submaps = 6;
    const Segmentation expected = segment(map, options);
    const Segmentation found = segment(map, options, RunOptions{2, &device});
    EXPECT_EQ(found.labels.values, expected.labels.values);
    EXPECT_EQ(found.report.eigen.at(0).eigenvalues, expected.report.eigen.at(0).eigenvalues);
    EXPECT_GT(device.traffic().bytes_up, 0U);
    EXPECT_EQ(notes, std::vector<std::string>{});
}

/// Whatever goes wrong: noted once, the CPU's result, and nothing more is asked of the device.
void expect_failure(const AcceleratorOptions& options, const std::string& reason) {
    std::vector<std::string> notes;
    OpenClAccelerator broken(options, [&](const std::string& note) { notes.push_back(note); });
    const LeafTable table = test::table_of(test::map_from_text({"....", ".#..", "....", "...."}));
    const std::vector<LeafId> nodes = test::free_leaves(table);
    const auto expected = sight_edges(table, nodes, 0.05);
    for (int call = 0; call < 2; ++call) {
        EXPECT_FALSE(broken.sight_edges(table, nodes, 0.05, SelfLoops::none).has_value());
        EXPECT_EQ(bits_of(sight_edges(table, nodes, 0.05, SelfLoops::none, {1, &broken})),
                  bits_of(expected));
    }
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find(reason), std::string::npos) << notes[0];
}

TEST(OpenClLibrary, ThatIsNotThere) {
    expect_failure({.library = "libNoSuchOpenCL.so.1", .accept_cpu = true},
                   "no OpenCL library (libNoSuchOpenCL.so.1)");
}

TEST(OpenClLibrary, ThatIsAnother) {
    expect_failure({.library = "libz.so.1", .accept_cpu = true}, "has no clGetPlatformIDs");
}

TEST(OpenClLibrary, IsNotLoadedForWorkThatDoesNotPay) {
    expect_failure({.library = "libNoSuchOpenCL.so.1", .only_if_it_pays = true}, "small");
}

TEST(OpenClLibrary, ThatEndsTheProcess) {
    expect_failure({.library = "libDeadly.so.1", .accept_cpu = true, .fault = Fault::death},
                   "the OpenCL driver failed when it was tried (signal 6");
}

TEST_F(OpenClFailure, KernelsThatDoNotCompile) {
    expect_failure({.accept_cpu = true, .fault = Fault::build}, "compiler refuses");
}

TEST_F(OpenClFailure, NoMemoryLeft) {
    expect_failure({.accept_cpu = true, .fault = Fault::memory}, "out of memory");
}

TEST_F(OpenClFailure, ALaunchThatIsRefused) {
    expect_failure({.accept_cpu = true, .fault = Fault::launch}, "launching a kernel");
}

TEST_F(OpenClFailure, WrongResults) {
    expect_failure({.accept_cpu = true, .fault = Fault::result}, "not those of the CPU");
}

TEST_F(OpenClFailure, InTheMiddleOfWhatItDoes) {
    OpenClAccelerator broken({.accept_cpu = true, .fault = Fault::late}, note());
    Random random(166);
    const LeafTable small = test::table_of(test::random_map(random, 32, 0.05));
    const LeafTable large = test::table_of(test::random_map(random, 256, 0.2));
    const auto edges_of = [&](const LeafTable& table) {
        return broken.sight_edges(table, test::free_leaves(table), 0.05, SelfLoops::none);
    };
    EXPECT_TRUE(edges_of(small).has_value());
    EXPECT_EQ(notes.size(), 0U);
    EXPECT_FALSE(edges_of(large).has_value());
    EXPECT_FALSE(edges_of(small).has_value());
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NE(notes[0].find("out of memory"), std::string::npos) << notes[0];
}

}  // namespace
}  // namespace quadcut::opencl
