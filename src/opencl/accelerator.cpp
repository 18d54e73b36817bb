// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "opencl/accelerator.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "opencl/self_check.hpp"
#include "opencl/trial.hpp"

namespace quadcut::opencl {
namespace {

/// Sight edges a free leaf has, about, on maps of buildings, its loop with them.
constexpr std::size_t kEdgesPerNode = 6;

/// Drivers compile their kernels in seconds.
constexpr unsigned kTrialLimitS = 60;

}  // namespace

OpenClAccelerator::Ready::Ready(Device found) : device(std::move(found)), sight(device) {
    check_against_cpu(sight);
    if (!device.has_doubles()) return;
    product.emplace(device);
    check_against_cpu(*product);
}

void OpenClAccelerator::survive_trial(const AcceleratorOptions& options) {
    // Once in a process: when the driver is in use, a copy of the process has not all of it.
    static std::mutex mutex;
    static std::set<std::string> survived;
    const std::lock_guard lock(mutex);
    if (survived.count(options.library) != 0) return;
    const auto begin = [&options] {
        const Ready ready(Device::find(options.library, options.accept_cpu, options.fault));
    };
    try_in_own_process(begin, kTrialLimitS);
    survived.insert(options.library);
}

OpenClAccelerator::OpenClAccelerator(AcceleratorOptions options, DeviceNote note)
    : options_(std::move(options)), note_(std::move(note)) {}

std::optional<std::vector<WeightedEdge>> OpenClAccelerator::sight_edges(
    const LeafTable& table, std::span<const LeafId> nodes, double resolution_m,
    SelfLoops self_loops) {
    const std::size_t num_edges = kEdgesPerNode * nodes.size();
    const StageWork work = edge_stage({nodes.size(), table.leaves().size(), num_edges,
                                       table.directory().values.size(), table.tiles().size()});
    std::vector<WeightedEdge> edges;
    const bool is_done =
        run(work, edge_stage_on_cpu_s(num_edges, options_.num_threads), [&](Ready& ready) {
            edges = ready.sight.find(table, nodes, resolution_m, self_loops);
            return true;
        });
    if (!is_done) return std::nullopt;
    return edges;
}

bool OpenClAccelerator::multiply(const MatrixRows& matrix, std::span<const double> block,
                                 std::span<double> result) {
    const std::size_t num_vectors = block.size() / std::max<std::size_t>(1, matrix.diagonal.size());
    const StageWork work = block_product(matrix.diagonal.size(), matrix.values.size(), num_vectors);
    const double cpu_s =
        block_product_on_cpu_s(matrix.values.size(), num_vectors, options_.num_threads);
    return run(work, cpu_s, [&](Ready& ready) {
        if (!ready.product.has_value()) {
            note_once(ready.device.name() +
                      " has no double precision, which the products of the eigensolver need");
            return false;
        }
        ready.product->multiply(matrix, block, result);
        return true;
    });
}

Traffic OpenClAccelerator::traffic() const {
    const std::lock_guard lock(mutex_);
    return ready_ ? ready_->sight.traffic() : Traffic{};
}

template <typename Body>
bool OpenClAccelerator::run(const StageWork& work, double cpu_s, const Body& body) {
    const std::lock_guard lock(mutex_);
    if (has_failed_) return false;
    if (options_.only_if_it_pays && !pays(work, cpu_s)) return false;
    std::string name;
    try {
        if (!ready_) {
            survive_trial(options_);
            Device device = Device::find(options_.library, options_.accept_cpu, options_.fault);
            name = device.name() + ": ";
            ready_ = std::make_unique<Ready>(std::move(device));
        }
        name = ready_->device.name() + ": ";
        return body(*ready_);
    } catch (const std::exception& error) {
        // Also when this process has no memory left: the CPU needs less.
        has_failed_ = true;
        ready_.reset();
        note_once(name + error.what());
        return false;
    }
}

bool OpenClAccelerator::pays(const StageWork& work, double cpu_s) {
    MachineRates machine;
    if (ready_) {
        machine = ready_->device.shares_memory() ? integrated_gpu() : discrete_gpu();
        machine.start_s = 0.0;
    } else {
        // Before anything is loaded: whether the best that can be expected would pay.
        machine = discrete_gpu();
        machine.link_bytes_per_s = integrated_gpu().link_bytes_per_s;
    }
    if (stage_s(work, machine) < cpu_s) return true;
    note_once("so small a map does not pay for a GPU");
    return false;
}

void OpenClAccelerator::note_once(const std::string& reason) {
    if (noted_.insert(reason).second && note_) note_(reason);
}

}  // namespace quadcut::opencl

namespace quadcut {

std::unique_ptr<Accelerator> make_accelerator(DeviceKind kind, int num_threads,
                                              const DeviceNote& note) {
    if (kind == DeviceKind::cpu) return nullptr;
    opencl::AcceleratorOptions options;
    options.accept_cpu = kind == DeviceKind::gpu;
    options.only_if_it_pays = kind == DeviceKind::automatic;
    options.num_threads = num_threads;
    return std::make_unique<opencl::OpenClAccelerator>(options, note);
}

}  // namespace quadcut
