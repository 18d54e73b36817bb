// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include "project/access.hpp"

namespace quadcut::project {

class Database;

/// A prepared statement. What it reads comes from an untrusted file: each value is checked, and
/// InputError names the file, the statement and the column.
class Statement {
public:
    /// @pre the database outlives it.
    Statement(const Database& database, std::string_view sql);
    ~Statement();
    Statement(Statement&&) noexcept;
    Statement& operator=(Statement&&) = delete;
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    /// Values by place, from 1 on. @pre text and bytes live until the statement has run.
    Statement& bind(int place, std::int64_t value);
    Statement& bind(int place, double value);
    Statement& bind(int place, std::string_view text);
    Statement& bind_bytes(int place, std::string_view bytes);
    /// To the next row; false after the last.
    bool step();
    /// Runs a statement without rows, and makes it ready to run again.
    void run();

    /// Columns of the row, from 0 on.
    [[nodiscard]] std::int64_t integer(int column, std::int64_t low, std::int64_t high) const;
    /// A finite number, of at most this magnitude.
    [[nodiscard]] double number(int column,
                                double largest = std::numeric_limits<double>::max()) const;
    [[nodiscard]] std::string text(int column) const;
    [[nodiscard]] std::string bytes(int column) const;

private:
    struct Impl;
    [[noreturn]] void refuse(int column, const std::string& expected) const;
    std::unique_ptr<Impl> impl_;
};

/// An SQLite file that exists. All errors are InputError and name the file: it is no database, is
/// damaged, is in use by another program, or the disk is full.
class Database {
public:
    Database(const std::filesystem::path& path, Access access);
    /// A new, empty one in memory; errors name the file that it is to become.
    [[nodiscard]] static Database in_memory(const std::filesystem::path& path);
    ~Database();
    Database(Database&&) noexcept;
    Database& operator=(Database&&) = delete;
    Database(const Database&) = delete;
    Database& operator=(const Database&) = delete;

    /// Runs statements without rows.
    void run(const std::string& sql);
    [[nodiscard]] std::int64_t pragma(std::string_view name) const;
    /// "ok", or what is wrong with the file.
    [[nodiscard]] std::string integrity() const;
    /// The bytes of a file that holds what this one holds, in WAL mode.
    /// @pre no transaction is open.
    [[nodiscard]] std::string file_bytes() const;
    /// No file of more pages than this; for tests of a full disk.
    void limit_pages(std::int64_t pages);
    [[nodiscard]] const std::filesystem::path& path() const;

private:
    friend class Statement;
    struct Impl;
    explicit Database(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

}  // namespace quadcut::project
