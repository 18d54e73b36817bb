// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "io/inflate.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <utility>

#include <zlib.h>

#include "quadcut/base/error.hpp"

namespace quadcut::io {
namespace {

constexpr std::size_t kPieceBytes = std::size_t{1} << 17U;

}  // namespace

struct Inflater::Stream {
    z_stream state{};
    std::array<Bytef, kPieceBytes> piece{};

    Stream() {
        constexpr int kGzipOnly = 15 + 16;  // Largest window, gzip header and check sum.
        if (inflateInit2(&state, kGzipOnly) != Z_OK) throw std::bad_alloc();
    }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    ~Stream() { inflateEnd(&state); }
};

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

Inflater::Inflater(std::string_view bytes, std::string name, std::uint64_t max_total_bytes,
                   Pieces more)
    : bytes_(bytes),
      more_(std::move(more)),
      name_(std::move(name)),
      max_total_bytes_(max_total_bytes),
      stream_(std::make_unique<Stream>()) {}

Inflater::~Inflater() = default;

std::string_view Inflater::next() {
    while (!finished_) {
        const std::size_t count = unpack();
        total_ += count;
        if (total_ > max_total_bytes_) {
            throw InputError(name_ + ": unpacks to more than the " +
                             std::to_string(max_total_bytes_) + " bytes that are read at most");
        }
        if (count > 0) return {reinterpret_cast<const char*>(stream_->piece.data()), count};
    }
    return {};
}

std::size_t Inflater::unpack() {
    constexpr std::size_t kMaxInput = std::numeric_limits<uInt>::max();
    if (bytes_.empty()) bytes_ = more_();
    z_stream& state = stream_->state;
    const std::size_t available = std::min(bytes_.size(), kMaxInput);
    // zlib's interface is not const, but it only reads.
    state.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes_.data()));
    state.avail_in = static_cast<uInt>(available);
    state.next_out = stream_->piece.data();
    state.avail_out = static_cast<uInt>(kPieceBytes);
    const int status = inflate(&state, Z_NO_FLUSH);
    bytes_.remove_prefix(available - state.avail_in);
    position_ += available - state.avail_in;
    if (status == Z_STREAM_END) {
        finished_ = !goes_on();
        if (!finished_) inflateReset(&state);
    } else if (status == Z_BUF_ERROR) {
        throw InputError(name_ + ": byte " + std::to_string(position_) +
                         ": the compressed data end early");
    } else if (status != Z_OK) {
        throw InputError(name_ + ": byte " + std::to_string(position_) +
                         ": damaged compressed data" +
                         (state.msg == nullptr ? "" : std::string(": ") + state.msg));
    }
    return kPieceBytes - state.avail_out;
}

/// Whether another gzip file is joined to the one that has ended.
bool Inflater::goes_on() {
    constexpr std::size_t kMagicBytes = 2;
    while (bytes_.size() < kMagicBytes) {
        std::string joined(bytes_);
        const std::string_view piece = more_();
        if (piece.empty()) return false;
        carried_ = joined.append(piece);
        bytes_ = carried_;
    }
    return is_gzip(bytes_);
}

std::string unpack_gzip(std::string_view bytes, const std::string& name,
                        std::uint64_t max_total_bytes) {
    Inflater inflater(bytes, name, max_total_bytes);
    std::string unpacked;
    for (std::string_view piece = inflater.next(); !piece.empty(); piece = inflater.next()) {
        unpacked.append(piece);
    }
    return unpacked;
}

std::string unpack_beginning(std::string_view bytes) {
    try {
        Inflater inflater(bytes, "", kPieceBytes);
        return std::string(inflater.next());
    } catch (const InputError&) {
        return {};
    }
}

}  // namespace quadcut::io
