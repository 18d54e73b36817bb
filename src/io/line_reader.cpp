// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/line_reader.hpp"

#include <algorithm>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#include <zlib.h>

#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 17U;

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

}  // namespace

class LineReader::Inflater {
public:
    Inflater(std::string_view bytes, std::uint64_t max_total_bytes)
        : bytes_(bytes), max_total_bytes_(max_total_bytes), piece_(kPieceBytes) {
        constexpr int kGzipOnly = 15 + 16;  // Largest window, gzip header and check sum.
        if (inflateInit2(&stream_, kGzipOnly) != Z_OK) throw std::bad_alloc();
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    ~Inflater() { inflateEnd(&stream_); }

    /// The next piece; empty at the end.
    std::string_view next(const std::string& name) {
        while (!finished_) {
            const std::size_t count = unpack(name);
            total_ += count;
            if (total_ > max_total_bytes_) {
                throw InputError(name + ": unpacks to more than the " +
                                 std::to_string(max_total_bytes_) + " bytes that are read at most");
            }
            if (count > 0) return {reinterpret_cast<const char*>(piece_.data()), count};
        }
        return {};
    }

private:
    std::size_t unpack(const std::string& name) {
        constexpr std::size_t kMaxInput = std::numeric_limits<uInt>::max();
        const std::size_t available = std::min(bytes_.size() - position_, kMaxInput);
        // zlib's interface is not const, but it only reads.
        stream_.next_in =
            const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes_.data() + position_));
        stream_.avail_in = static_cast<uInt>(available);
        stream_.next_out = piece_.data();
        stream_.avail_out = static_cast<uInt>(piece_.size());
        const int status = inflate(&stream_, Z_NO_FLUSH);
        position_ += available - stream_.avail_in;
        if (status == Z_STREAM_END) {
            // Files may be joined; what follows and is no gzip is padding.
            finished_ = !is_gzip(bytes_.substr(position_));
            if (!finished_) inflateReset(&stream_);
        } else if (status == Z_BUF_ERROR) {
            throw InputError(name + ": byte " + std::to_string(position_) +
                             ": the compressed data end early");
        } else if (status != Z_OK) {
            throw InputError(name + ": byte " + std::to_string(position_) +
                             ": damaged compressed data" +
                             (stream_.msg == nullptr ? "" : std::string(": ") + stream_.msg));
        }
        return piece_.size() - stream_.avail_out;
    }

    std::string_view bytes_;
    std::uint64_t max_total_bytes_;
    std::vector<Bytef> piece_;
    z_stream stream_{};
    std::size_t position_ = 0;
    std::uint64_t total_ = 0;
    bool finished_ = false;
};

LineReader::LineReader(std::string_view bytes, std::string name, LineLimits limits)
    : name_(std::move(name)), limits_(limits) {
    if (is_gzip(bytes)) {
        inflater_ = std::make_unique<Inflater>(bytes, limits.max_total_bytes);
    } else {
        pending_ = bytes;
    }
}

LineReader::LineReader(LineReader&&) noexcept = default;
LineReader& LineReader::operator=(LineReader&&) noexcept = default;
LineReader::~LineReader() = default;

bool LineReader::refill() {
    if (inflater_) pending_ = inflater_->next(name_);
    return !pending_.empty();
}

std::optional<Line> LineReader::next() {
    carried_.clear();
    bool spans_pieces = false;
    Line line;
    while (true) {
        if (pending_.empty() && !refill()) {
            if (!spans_pieces) return std::nullopt;
            line.ended = false;
            break;
        }
        const std::size_t length = pending_.find('\n');
        line.ended = length != std::string_view::npos;
        const std::string_view part = pending_.substr(0, length);
        pending_.remove_prefix(part.size() + (line.ended ? 1 : 0));
        if (line.ended && !spans_pieces) {
            line.text = part;
            break;
        }
        spans_pieces = true;
        // One byte over the limit is enough to know that it was passed.
        carried_.append(part.substr(0, limits_.max_line_bytes + 1 - carried_.size()));
        if (line.ended) break;
    }
    if (spans_pieces) line.text = carried_;
    line.number = ++line_number_;
    line.too_long = line.text.size() > limits_.max_line_bytes;
    line.text = line.text.substr(0, limits_.max_line_bytes);
    if (!line.too_long && line.text.ends_with('\r')) line.text.remove_suffix(1);
    return line;
}

}  // namespace quadcut::io
