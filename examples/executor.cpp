// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <iostream>

#include <quadcut/executor.hpp>
#include <quadcut/map.hpp>

int main() {
    // How many cells of each row are free? Each row has a slot of its own, so that the answer is
    // the same on any number of threads.
    const quadcut::Raster<quadcut::CellState> states({0, 0}, 1000, 500, quadcut::CellState::free);
    std::vector<std::size_t> num_free(500);
    quadcut::Executor executor;
    executor.num_threads = 4;
    quadcut::parallel_for(executor, num_free.size(), 16, [&](std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y) {
            for (std::int32_t x = 0; x < states.width; ++x) {
                const quadcut::Cell cell{x, static_cast<std::int32_t>(y)};
                if (states.at(cell) == quadcut::CellState::free) ++num_free[y];
            }
        }
    });
    std::cout << num_free.front() << " free cells in the first row\n";
}
// Prints: 1000 free cells in the first row
