// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "quadcut/base/error.hpp"
#include "quadcut/map/integrate.hpp"

// The bytes are a stream of scans: poses and ranges as they come, however wild.

namespace {

class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    [[nodiscard]] bool is_empty() const { return size_ == 0; }
    std::uint8_t byte() {
        if (size_ == 0) return 0;
        --size_;
        return *data_++;
    }
    // A number of any bits, or a small one: most bit patterns are absurd as metres.
    double number() {
        const std::uint8_t kind = byte();
        if (kind < 250) {
            return (static_cast<int>(byte()) - 128) * (kind < 200 ? 0.05 : 3.0) + kind * 1e-3;
        }
        std::uint64_t bits = 0;
        for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
        return std::bit_cast<double>(bits);
    }

private:
    const std::uint8_t* data_;
    std::size_t size_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    quadcut::OccupancyMap map(0.1);
    for (int i = 0; i < 20 && !bytes.is_empty(); ++i) {
        quadcut::Scan scan;
        scan.world_from_sensor = {bytes.number(), bytes.number(), bytes.number()};
        scan.first_angle_rad = bytes.number();
        scan.angle_step_rad = bytes.number();
        scan.max_range_m = bytes.number();
        scan.ranges_m.resize(bytes.byte());
        for (float& range : scan.ranges_m) range = static_cast<float>(bytes.number());
        try {
            const std::size_t before = map.num_leaves();
            const quadcut::MapUpdate update = quadcut::integrate_scan(map, scan);
            if (map.num_leaves() > before + update.nodes_rebuilt) __builtin_trap();
        } catch (const quadcut::InputError&) {
        }
        if (map.leaves().size() != map.num_leaves()) __builtin_trap();
    }
    return 0;
}
