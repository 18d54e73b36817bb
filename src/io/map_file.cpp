// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/map_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <utility>

#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr std::array<std::uint8_t, 8> kMagic{'Q', 'U', 'A', 'D', 'M', 'A', 'P', 0x1A};
constexpr std::uint32_t kVersion = 1;
constexpr std::uint8_t kMixedTile = 0xFF;
constexpr std::size_t kChecksumBytes = 8;

// FNV-1a, 64 bits.
std::uint64_t checksum(std::span<const std::byte> bytes) {
    std::uint64_t hash = 0xCBF2'9CE4'8422'2325U;
    for (const std::byte byte : bytes) {
        hash = (hash ^ static_cast<std::uint8_t>(byte)) * 0x0000'0100'0000'01B3U;
    }
    return hash;
}

bool is_unknown(const OccupancyMap& map, Cell tile) {
    return map.is_uniform_tile(tile) && map.tile(tile).values.front() == 0;
}

// The tiles that hold something known.
Box known_tiles(const OccupancyMap& map) {
    const Box written = map.written_tiles();
    Box known;
    for (Cell tile = written.low; tile.y <= written.high.y; ++tile.y) {
        for (tile.x = written.low.x; tile.x <= written.high.x; ++tile.x) {
            if (!is_unknown(map, tile)) known.include({tile, tile});
        }
    }
    return known;
}

class Writer {
public:
    void byte(std::uint8_t value) { bytes_.push_back(static_cast<std::byte>(value)); }
    template <typename Integer>
    void integer(Integer value) {
        for (std::size_t i = 0; i < sizeof(Integer); ++i) {
            byte(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i)));
        }
    }
    void number(double value) { integer(std::bit_cast<std::uint64_t>(value)); }
    [[nodiscard]] std::vector<std::byte> finish() {
        integer(checksum(bytes_));
        return std::move(bytes_);
    }

private:
    std::vector<std::byte> bytes_;
};

class Reader {
public:
    Reader(std::span<const std::byte> bytes, const std::string& name)
        : bytes_(bytes), name_(name) {}

    std::uint8_t byte() {
        require(at_ < bytes_.size(), "the file goes on");
        return static_cast<std::uint8_t>(bytes_[at_++]);
    }
    template <typename Integer>
    Integer integer() {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < sizeof(Integer); ++i) {
            value |= std::uint64_t{byte()} << (8 * i);
        }
        return static_cast<Integer>(value);
    }
    double number() { return std::bit_cast<double>(integer<std::uint64_t>()); }

    [[nodiscard]] std::size_t num_left() const { return bytes_.size() - at_; }
    void require(bool condition, const char* expected) const {
        if (!condition) {
            throw InputError(name_ + ": byte " + std::to_string(at_) + ": expected that " +
                             expected);
        }
    }

private:
    std::span<const std::byte> bytes_;
    const std::string& name_;
    std::size_t at_ = 0;
};

void write_tiles(Writer& writer, const OccupancyMap& map, const Box& tiles) {
    const auto for_each_tile = [&](const auto& visit) {
        for (Cell tile = tiles.low; tile.y <= tiles.high.y; ++tile.y) {
            for (tile.x = tiles.low.x; tile.x <= tiles.high.x; ++tile.x) visit(tile);
        }
    };
    for_each_tile([&](Cell tile) {
        writer.byte(map.is_uniform_tile(tile)
                        ? static_cast<std::uint8_t>(map.tile(tile).values.front() - kMinLogOdds)
                        : kMixedTile);
    });
    for_each_tile([&](Cell tile) {
        if (!map.is_uniform_tile(tile)) {
            for (const std::int8_t value : map.tile(tile).values) {
                writer.byte(static_cast<std::uint8_t>(value - kMinLogOdds));
            }
        }
    });
}

std::int8_t read_log_odds(Reader& reader, std::uint8_t code) {
    reader.require(code <= kMaxLogOdds - kMinLogOdds, "log-odds are within their bounds");
    return static_cast<std::int8_t>(code + kMinLogOdds);
}

// An OccupancyMap constructor and reserve() check what they are given; messages name the file.
OccupancyMap read_header(Reader& reader, const std::string& name) {
    for (const std::uint8_t expected : kMagic) {
        reader.require(reader.byte() == expected, "the file begins with QUADMAP");
    }
    reader.require(reader.integer<std::uint32_t>() == kVersion, "the format version is 1");
    const double resolution_m = reader.number();
    const Pose pose{reader.number(), reader.number(), reader.number()};
    const auto is_placed = reader.integer<std::uint32_t>();
    reader.require(is_placed <= 1, "a root that has its place is told by 1, else 0");
    const Cell lower_left{reader.integer<std::int32_t>(), reader.integer<std::int32_t>()};
    const auto level = reader.integer<std::uint32_t>();
    reader.require(level <= 30, "the root's level is at most 30");
    const Root root{lower_left, static_cast<std::uint8_t>(level)};
    try {
        OccupancyMap unplaced(resolution_m, pose);
        if (is_placed == 1) return OccupancyMap(resolution_m, pose, root);
        if (root == unplaced.root()) return unplaced;
    } catch (const InputError& error) {
        throw InputError(name + ": " + error.what());
    }
    throw InputError(name + ": expected the smallest root where it has no place yet");
}

Box read_range(Reader& reader, const OccupancyMap& map) {
    Box tiles;
    tiles.low = {reader.integer<std::int32_t>(), reader.integer<std::int32_t>()};
    const auto width = reader.integer<std::uint32_t>();
    const auto height = reader.integer<std::uint32_t>();
    reader.require(std::uint64_t{width} * height <= reader.num_left(),
                   "there is a byte for each tile");
    if (width == 0 || height == 0) {
        reader.require(width == height && tiles.low == Cell{}, "no tiles are a rectangle of zeros");
        return {{0, 0}, {-1, -1}};
    }
    const Root& root = map.root();
    const Cell first{root.lower_left.x >> kTileBits, root.lower_left.y >> kTileBits};
    const std::int64_t side = root.side_cells() >> kTileBits;
    const auto inside = [&](std::int64_t low, std::int64_t count, std::int64_t root_low) {
        return low >= root_low && low + count <= root_low + side;
    };
    reader.require(inside(tiles.low.x, width, first.x) && inside(tiles.low.y, height, first.y),
                   "the tiles lie inside the root");
    tiles.high = {tiles.low.x + static_cast<std::int32_t>(width) - 1,
                  tiles.low.y + static_cast<std::int32_t>(height) - 1};
    return tiles;
}

void read_tiles(Reader& reader, OccupancyMap& map, const Box& range) {
    std::vector<Cell> mixed;
    for (Cell tile = range.low; tile.y <= range.high.y; ++tile.y) {
        for (tile.x = range.low.x; tile.x <= range.high.x; ++tile.x) {
            const std::uint8_t code = reader.byte();
            if (code == kMixedTile) {
                mixed.push_back(tile);
                continue;
            }
            Tile uniform;
            uniform.values.fill(read_log_odds(reader, code));
            map.set_tile(tile, uniform);
        }
    }
    reader.require(reader.num_left() == mixed.size() * kTileCells + kChecksumBytes,
                   "64 bytes for each mixed tile and 8 of checksum follow");
    for (const Cell& tile : mixed) {
        Tile values;
        for (std::int8_t& value : values.values) value = read_log_odds(reader, reader.byte());
        map.set_tile(tile, values);
        reader.require(!map.is_uniform_tile(tile), "a mixed tile holds more than one value");
    }
}

}  // namespace

std::vector<std::byte> encode_map(const OccupancyMap& map) {
    // Throws while writes are pending.
    static_cast<void>(map.num_leaves());
    Writer writer;
    for (const std::uint8_t byte : kMagic) writer.byte(byte);
    writer.integer(kVersion);
    writer.number(map.resolution_m());
    writer.number(map.world_from_map().x);
    writer.number(map.world_from_map().y);
    writer.number(map.world_from_map().yaw_rad);
    writer.integer(std::uint32_t{map.is_placed()});
    writer.integer(map.root().lower_left.x);
    writer.integer(map.root().lower_left.y);
    writer.integer(std::uint32_t{map.root().level});
    const Box range = known_tiles(map);
    writer.integer(range.low.x);
    writer.integer(range.low.y);
    writer.integer(static_cast<std::uint32_t>(range.width()));
    writer.integer(static_cast<std::uint32_t>(range.height()));
    write_tiles(writer, map, range);
    return writer.finish();
}

OccupancyMap decode_map(std::span<const std::byte> bytes, const std::string& name) {
    if (bytes.size() >= kChecksumBytes) {
        Reader end(bytes.last(kChecksumBytes), name);
        const bool is_intact =
            end.integer<std::uint64_t>() == checksum(bytes.first(bytes.size() - kChecksumBytes));
        if (!is_intact && bytes.size() > kMagic.size() &&
            std::equal(kMagic.begin(), kMagic.end(), bytes.begin(),
                       [](std::uint8_t a, std::byte b) { return std::byte{a} == b; })) {
            throw InputError(name +
                             ": the checksum does not fit: the file is cut short or damaged");
        }
    }
    Reader reader(bytes, name);
    OccupancyMap map = read_header(reader, name);
    const Box range = read_range(reader, map);
    if (!range.is_empty()) {
        map.reserve(first_cell_of(range.low), first_cell_of(range.high));
    }
    read_tiles(reader, map, range);
    map.commit();
    if (known_tiles(map) != range) {
        throw InputError(name + ": the outer tiles are unknown: expected a rectangle without them");
    }
    return map;
}

}  // namespace quadcut::io
