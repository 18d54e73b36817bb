// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "project/database.hpp"

#include <cmath>
#include <new>
#include <utility>

#include <sqlite3.h>

#include "io/file.hpp"
#include "quadcut/base/error.hpp"

namespace quadcut::project {
namespace {

/// No text or blob of ours is larger; a file that says otherwise is not read.
constexpr int kMaxValueBytes = 1 << 26;
constexpr int kPatienceMs = 1000;

struct CloseDatabase {
    void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
};
struct FinalizeStatement {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

std::string meaning(sqlite3* database, int code) {
    switch (code & 0xff) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return "is in use: another program is writing to it; try again when that has ended";
        case SQLITE_FULL:
            return "no space is left; the file holds what was saved before";
        case SQLITE_IOERR:
            return std::string("cannot be read or written (") + sqlite3_errstr(code) +
                   "); the file holds what was saved before";
        case SQLITE_NOTADB:
            return "is no project file: expected an SQLite database that quadcut has written";
        case SQLITE_CORRUPT:
            return std::string("is damaged: ") + sqlite3_errmsg(database);
        case SQLITE_CANTOPEN:
            return "cannot be opened: is it a file, and may it be written?";
        case SQLITE_READONLY:
            return "cannot be written";
        default:
            return sqlite3_errmsg(database);
    }
}

[[noreturn]] void fail(const std::filesystem::path& path, sqlite3* database, int code) {
    throw InputError(io::display_name(path) + ": " + meaning(database, code));
}

}  // namespace

struct Database::Impl {
    std::filesystem::path path;
    std::unique_ptr<sqlite3, CloseDatabase> handle;

    void check(int code) const {
        if (code != SQLITE_OK) fail(path, handle.get(), code);
    }
};

struct Statement::Impl {
    const Database::Impl* database = nullptr;
    std::unique_ptr<sqlite3_stmt, FinalizeStatement> handle;

    void check(int code) const { database->check(code); }
};

Statement::Statement(const Database& database, std::string_view sql)
    : impl_(std::make_unique<Impl>()) {
    impl_->database = database.impl_.get();
    sqlite3_stmt* statement = nullptr;
    const int code = sqlite3_prepare_v2(database.impl_->handle.get(), sql.data(),
                                        static_cast<int>(sql.size()), &statement, nullptr);
    impl_->handle.reset(statement);
    impl_->check(code);
}

Statement::~Statement() = default;
Statement::Statement(Statement&&) noexcept = default;

Statement& Statement::bind(int place, std::int64_t value) {
    impl_->check(sqlite3_bind_int64(impl_->handle.get(), place, value));
    return *this;
}

Statement& Statement::bind(int place, double value) {
    impl_->check(sqlite3_bind_double(impl_->handle.get(), place, value));
    return *this;
}

Statement& Statement::bind(int place, std::string_view text) {
    impl_->check(sqlite3_bind_text64(impl_->handle.get(), place, text.data(), text.size(),
                                     SQLITE_STATIC, SQLITE_UTF8));
    return *this;
}

Statement& Statement::bind_bytes(int place, std::string_view bytes) {
    impl_->check(
        sqlite3_bind_blob64(impl_->handle.get(), place, bytes.data(), bytes.size(), SQLITE_STATIC));
    return *this;
}

bool Statement::step() {
    const int code = sqlite3_step(impl_->handle.get());
    if (code == SQLITE_ROW) return true;
    if (code != SQLITE_DONE) impl_->check(code);
    return false;
}

void Statement::run() {
    const int code = sqlite3_step(impl_->handle.get());
    sqlite3_reset(impl_->handle.get());
    if (code != SQLITE_DONE) impl_->check(code);
}

void Statement::refuse(int column, const std::string& expected) const {
    throw InputError(io::display_name(impl_->database->path) + ": column " +
                     sqlite3_column_name(impl_->handle.get(), column) + " of '" +
                     sqlite3_sql(impl_->handle.get()) + "': expected " + expected);
}

std::int64_t Statement::integer(int column, std::int64_t low, std::int64_t high) const {
    sqlite3_stmt* const statement = impl_->handle.get();
    const std::int64_t value = sqlite3_column_int64(statement, column);
    const bool is_integer = sqlite3_column_type(statement, column) == SQLITE_INTEGER;
    if (!is_integer || value < low || value > high) {
        refuse(column, "an integer from " + std::to_string(low) + " to " + std::to_string(high));
    }
    return value;
}

double Statement::number(int column, double largest) const {
    sqlite3_stmt* const statement = impl_->handle.get();
    const int type = sqlite3_column_type(statement, column);
    const double value = sqlite3_column_double(statement, column);
    const bool is_number = type == SQLITE_FLOAT || type == SQLITE_INTEGER;
    if (!is_number || !std::isfinite(value)) refuse(column, "a finite number");
    if (std::abs(value) > largest) refuse(column, "a smaller number");
    return value;
}

std::string Statement::text(int column) const {
    sqlite3_stmt* const statement = impl_->handle.get();
    if (sqlite3_column_type(statement, column) != SQLITE_TEXT) refuse(column, "a text");
    const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
    return {text, static_cast<std::size_t>(sqlite3_column_bytes(statement, column))};
}

std::string Statement::bytes(int column) const {
    sqlite3_stmt* const statement = impl_->handle.get();
    if (sqlite3_column_type(statement, column) != SQLITE_BLOB) refuse(column, "a blob");
    const auto* bytes = static_cast<const char*>(sqlite3_column_blob(statement, column));
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, column));
    return size == 0 ? std::string() : std::string(bytes, size);
}

Database::Database(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

namespace {

sqlite3* opened(const std::string& file, const std::filesystem::path& path) {
    sqlite3* handle = nullptr;
    const int code = sqlite3_open_v2(file.c_str(), &handle,
                                     SQLITE_OPEN_READWRITE | SQLITE_OPEN_EXRESCODE, nullptr);
    std::unique_ptr<sqlite3, CloseDatabase> owner(handle);
    if (code != SQLITE_OK) fail(path, handle, code);
    // The file may be hostile: it has no say beyond its rows.
    sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, kMaxValueBytes);
    sqlite3_extended_result_codes(handle, 0);
    // A program that was killed may hold its locks for a moment more.
    sqlite3_busy_timeout(handle, kPatienceMs);
    return owner.release();
}

}  // namespace

Database::Database(const std::filesystem::path& path, Access access)
    : impl_(std::make_unique<Impl>()) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (!std::filesystem::is_regular_file(status)) {
        throw InputError(io::display_name(path) + (std::filesystem::is_directory(status)
                                                       ? ": is a folder: expected a project file"
                                                   : std::filesystem::exists(status)
                                                       ? ": is no file: expected a project file"
                                                       : ": there is no such project file"));
    }
    impl_->path = path;
    // A reader, too, may have to bring in what a killed writer left beside the file.
    impl_->handle.reset(opened(path, path));
    if (access == Access::read) run("PRAGMA query_only=1");
    run("PRAGMA cell_size_check=1");
}

Database Database::in_memory(const std::filesystem::path& path) {
    auto impl = std::make_unique<Impl>();
    impl->path = path;
    impl->handle.reset(opened(":memory:", path));
    return Database(std::move(impl));
}

Database::~Database() = default;
Database::Database(Database&&) noexcept = default;

void Database::run(const std::string& sql) {
    impl_->check(sqlite3_exec(impl_->handle.get(), sql.c_str(), nullptr, nullptr, nullptr));
}

std::int64_t Database::pragma(std::string_view name) const {
    Statement statement(*this, "PRAGMA " + std::string(name));
    statement.step();
    return statement.integer(0, std::numeric_limits<std::int32_t>::min(),
                             std::numeric_limits<std::uint32_t>::max());
}

std::string Database::integrity() const {
    Statement statement(*this, "PRAGMA integrity_check");
    statement.step();
    return statement.text(0);
}

std::string Database::file_bytes() const {
    struct Free {
        void operator()(unsigned char* bytes) const { sqlite3_free(bytes); }
    };
    sqlite3_int64 size = 0;
    const std::unique_ptr<unsigned char, Free> bytes(
        sqlite3_serialize(impl_->handle.get(), "main", &size, 0));
    if (!bytes) throw std::bad_alloc();
    std::string file(bytes.get(), bytes.get() + size);
    // Read and write version of the file's header: 2 is WAL.
    constexpr std::size_t kWriteVersion = 18;
    file.at(kWriteVersion) = file.at(kWriteVersion + 1) = 2;
    return file;
}

void Database::limit_pages(std::int64_t pages) {
    run("PRAGMA max_page_count=" + std::to_string(pages));
}

const std::filesystem::path& Database::path() const { return impl_->path; }

}  // namespace quadcut::project
