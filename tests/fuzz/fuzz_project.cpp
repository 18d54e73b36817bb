// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

#include "formats/registry.hpp"
#include "io/file.hpp"
#include "project/database.hpp"
#include "project/project.hpp"
#include "project/schema.hpp"
#include "quadcut/base/error.hpp"
#include "quadcut/follow/followed_map.hpp"

// The bytes are a project file; or, when they are no database, changes to the rows of a good one,
// which get further than damaged pages do.

namespace {

using quadcut::Access;
using quadcut::EditKind;
using quadcut::InputError;
using quadcut::Project;
using quadcut::RoomId;

constexpr std::string_view kDatabase = "SQLite format 3";
/// A file may say that its map spans as much as memory holds; that is only slow.
constexpr std::int64_t kMaxTilesAcross = 256;

/// Where the file is, gone at the end of the program.
class Scratch {
public:
    Scratch() : folder_(memory() / ("quadcut_fuzz_project_" + std::to_string(getpid()))) {
        std::filesystem::create_directories(folder_);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() {
        std::error_code error;
        std::filesystem::remove_all(folder_, error);
    }

    std::filesystem::path write(std::string_view bytes) const {
        const std::filesystem::path path = folder_ / "p.quadcut";
        for (const char* end : {"-wal", "-shm"}) std::filesystem::remove(path.string() + end);
        quadcut::io::write_file_atomically(path, bytes);
        return path;
    }

private:
    /// No disk is waited for, where there is such a folder.
    static std::filesystem::path memory() {
        const std::filesystem::path shared = "/dev/shm";
        const bool is_there = access(shared.c_str(), W_OK) == 0;
        return is_there ? shared : std::filesystem::temp_directory_path();
    }

    std::filesystem::path folder_;
};

const Scratch& scratch() {
    static const Scratch own;
    return own;
}

/// A hall with a wall across, which people have changed; of every table a row or more.
std::string good_project() {
    quadcut::FollowOptions options;
    options.resolution_m = 0.1;
    Project project = Project::in_memory(
        options, quadcut::ScanPosition{"robot.log", 7, 3, 1, "why"}, quadcut::RunOptions{1});
    quadcut::Raster<quadcut::CellState> hall({0, 0}, 70, 50, quadcut::CellState::occupied);
    for (std::size_t i = 0; i < hall.values.size(); ++i) {
        const quadcut::Cell cell = hall.cell(i);
        const bool is_wall = cell.x == 30 && (cell.y < 20 || cell.y > 28);
        const bool is_inside = cell.x > 4 && cell.x < 65 && cell.y > 4 && cell.y < 45;
        if (is_inside && !is_wall) hall.values[i] = quadcut::CellState::free;
    }
    project.add(hall);
    project.edit({EditKind::rename, RoomId{1}, {}, "Hall", {}, {}});
    project.edit({EditKind::split, {}, {}, {}, {5.0, 0.6}, {5.0, 4.4}});
    project.edit({EditKind::lock, RoomId{1}, {}, {}, {}, {}});
    project.undo();
    project.add({{66, 20}, 2, 1, quadcut::CellState::free});
    project.finish();
    return project.file_bytes();
}

const std::string& good() {
    static const std::string bytes = good_project();
    return bytes;
}

/// Reads values off the bytes; zeros when there are no more.
class Bytes {
public:
    explicit Bytes(std::string_view bytes) : bytes_(bytes) {}
    [[nodiscard]] bool is_empty() const { return bytes_.empty(); }
    std::string_view take(std::size_t count) {
        const std::string_view taken = bytes_.substr(0, count);
        bytes_.remove_prefix(taken.size());
        return taken;
    }
    std::uint8_t byte() { return is_empty() ? 0 : static_cast<std::uint8_t>(take(1).front()); }
    std::uint64_t number(int num_bytes) {
        std::uint64_t value = 0;
        for (int i = 0; i < num_bytes; ++i) value = value << 8U | byte();
        return value;
    }

private:
    std::string_view bytes_;
};

std::vector<std::string> columns_of(const quadcut::project::Database& database,
                                    std::string_view table) {
    std::vector<std::string> columns;
    quadcut::project::Statement names(database, "SELECT name FROM pragma_table_info(?)");
    names.bind(1, table);
    while (names.step()) columns.push_back(names.text(0));
    return columns;
}

/// One value of one row, of those that share its first column, or of all; or these rows are gone.
void change_row(quadcut::project::Database& database, Bytes& bytes) {
    const auto tables = quadcut::project::tables();
    const std::string table(tables[bytes.byte() % tables.size()].name);
    const std::vector<std::string> columns = columns_of(database, table);
    const std::string& column = columns[bytes.byte() % columns.size()];
    const std::uint8_t row = bytes.byte();
    std::string where;
    if (row != 255) {
        where = " WHERE " + columns[0] + " IN (SELECT " + columns[0] + " FROM " + table +
                " LIMIT 1 OFFSET " + std::to_string(row) + ")";
    }
    const std::uint8_t kind = bytes.byte() % 6;
    const std::string sql = kind == 0 ? "DELETE FROM " + table + where
                            : kind == 1
                                ? "INSERT OR IGNORE INTO " + table + "(" + column + ") VALUES(?)"
                                : "UPDATE OR IGNORE " + table + " SET " + column + " = ?" + where;
    quadcut::project::Statement statement(database, sql);
    std::string_view text;
    if (kind == 1 || kind == 2) {
        statement.bind(1, static_cast<std::int64_t>(static_cast<std::int16_t>(bytes.number(2))));
    } else if (kind == 3) {
        const std::uint64_t value = bytes.number(8);
        if (value % 2 == 0)
            statement.bind(1, static_cast<std::int64_t>(value >> (value / 2 % 64)));
        else
            statement.bind(1, std::bit_cast<double>(value));
    } else if (kind == 4) {
        statement.bind(1, text = bytes.take(bytes.byte()));
    } else if (kind == 5) {
        statement.bind_bytes(1, text = bytes.take(bytes.number(2)));
    }
    statement.run();
}

void change_rows(const std::filesystem::path& path, std::string_view input) {
    quadcut::project::Database database(path, Access::write);
    database.run("BEGIN");
    Bytes bytes(input);
    for (int i = 0; i < 16 && !bytes.is_empty(); ++i) change_row(database, bytes);
    database.run("COMMIT");
}

bool is_small(const std::filesystem::path& path) {
    const quadcut::project::Database database(path, Access::read);
    quadcut::project::Statement spans(
        database,
        "SELECT 1 FROM (SELECT max(x) - min(x) AS width, max(y) - min(y) AS height FROM tiles), "
        "(SELECT max(abs(value)) AS box FROM meta WHERE key IN ('low_x', 'low_y', 'high_x', "
        "'high_y')) WHERE coalesce(width, 0) < ?1 AND coalesce(height, 0) < ?1 AND box < 8 * ?1");
    return spans.bind(1, kMaxTilesAcross).step();
}

void read_all(const Project& project) {
    const std::shared_ptr<const quadcut::Snapshot> building = project.snapshot();
    const quadcut::GridMap& map = building->map();
    const quadcut::Segmentation& rooms = building->rooms();
    if (rooms.rooms.size() != building->num_rooms()) __builtin_trap();
    for (const quadcut::Room& room : rooms.rooms) {
        if (building->followed()->rooms.count(static_cast<std::uint32_t>(room.id)) == 0)
            __builtin_trap();
    }
    (void)building->place_of({2.0, 2.0});
    (void)project.history();
    if (map.states.values.empty()) return;
    const quadcut::io::RunInfo info;
    const std::string updates = building->updates();
    const quadcut::formats::Result result(map, rooms, info, updates);
    for (const auto& format : quadcut::formats::find_formats("geojson,graph,labels,report")) {
        (void)format.write(result);
    }
}

/// What is refused is refused; the rest goes on.
template <typename Change>
void attempt(const Change& change) {
    try {
        change();
    } catch (const InputError&) {
    }
}

void change_all(Project& project) {
    attempt([&] { project.redo(); });
    attempt([&] { project.undo(); });
    attempt([&] { project.undo(); });
    const std::shared_ptr<const quadcut::Snapshot> building = project.snapshot();
    std::vector<RoomId> rooms;
    for (const auto& [id, room] : building->followed()->rooms) rooms.push_back(RoomId{id});
    for (const EditKind kind :
         {EditKind::merge, EditKind::rename, EditKind::unlock, EditKind::lock}) {
        if (rooms.empty()) break;
        attempt([&] { project.edit({kind, rooms.front(), rooms.back(), "Cellar", {}, {}}); });
    }
    attempt([&] { project.edit({EditKind::split, {}, {}, {}, {2.0, 0.6}, {2.0, 4.4}}); });
    attempt([&] { project.add({{10, 10}, 12, 30, quadcut::CellState::free}); });
    attempt([&] { (void)project.refine(); });
    attempt([&] { project.undo(); });
    project.finish();
    project.save();
}

/// As `follow` opens it.
Project open_to_write(const std::filesystem::path& path) {
    std::optional<quadcut::ScanPosition> position;
    quadcut::FollowOptions options;
    {
        const Project project = Project::open(path, Access::read, quadcut::RunOptions{1});
        position = project.position();
        options = project.options();
    }
    if (!position) return Project::open(path, Access::write, quadcut::RunOptions{1});
    return Project::open_or_create(path, options, *position, quadcut::RunOptions{1});
}

void use(const std::filesystem::path& path) {
    if (!is_small(path)) return;
    read_all(Project::open(path, Access::read, quadcut::RunOptions{1}));
    std::size_t num_rooms = 0;
    {
        Project project = open_to_write(path);
        change_all(project);
        num_rooms = project.state().num_rooms;
    }
    // What was saved can be read.
    const Project again = Project::open(path, Access::read, quadcut::RunOptions{1});
    if (again.state().num_rooms != num_rooms) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
    // All of this is possible with a good one: what is refused there ends the program.
    const std::filesystem::path path = scratch().write(good());
    if (!is_small(path)) __builtin_trap();
    use(path);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const bool is_database = bytes.starts_with(kDatabase);
    const std::filesystem::path path =
        scratch().write(is_database ? bytes : std::string_view(good()));
    try {
        if (!is_database) change_rows(path, bytes);
        use(path);
    } catch (const InputError&) {
    }
    return 0;
}
