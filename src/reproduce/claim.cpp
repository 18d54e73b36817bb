// SPDX-License-Identifier: Apache-2.0
// SPDX-FileCopyrightText: The quadcut developers
#include "reproduce/claim.hpp"

#include <algorithm>
#include <cmath>

#include "reproduce/sentence.hpp"

namespace quadcut::reproduce {
namespace {

bool keeps(double value, Bound bound, double limit) {
    switch (bound) {
        case Bound::below:
            return value < limit;
        case Bound::at_most:
            return value <= limit;
        case Bound::equal:
            return value == limit;
        case Bound::at_least:
            return value >= limit;
        case Bound::above:
            return value > limit;
    }
    return false;
}

const char* words_of(Bound bound) {
    switch (bound) {
        case Bound::below:
            return "below ";
        case Bound::at_most:
            return "at most ";
        case Bound::equal:
            return "";
        case Bound::at_least:
            return "at least ";
        case Bound::above:
            return "above ";
    }
    return "";
}

std::string with_unit(double value, const std::string& unit) {
    return in_words(value) + (unit.empty() ? "" : " " + unit);
}

std::string joined(const std::vector<Claim>& claims, bool held) {
    std::string text;
    for (const Claim& claim : claims) {
        if (holds(claim) != held) continue;
        if (!text.empty()) text += "; ";
        text +=
            claim.quantity + ": " + measured_text(claim) + " (limit: " + limit_text(claim) + ")";
    }
    return text;
}

}  // namespace

bool holds(const Claim& claim) {
    return !claim.numbers.empty() &&
           std::all_of(claim.numbers.begin(), claim.numbers.end(), [&claim](const Measured& one) {
               return std::isfinite(one.value) && keeps(one.value, claim.bound, claim.limit);
           });
}

std::string measured_text(const Claim& claim) {
    if (claim.numbers.empty()) return "not measured";
    std::string text;
    for (const Measured& one : claim.numbers) {
        if (!text.empty()) text += ", ";
        text += with_unit(one.value, claim.unit);
        if (!one.where.empty()) text += " on " + one.where;
    }
    return text;
}

std::string limit_text(const Claim& claim) {
    return words_of(claim.bound) + with_unit(claim.limit, claim.unit);
}

std::size_t count_held(const std::vector<Claim>& claims) {
    return static_cast<std::size_t>(std::count_if(claims.begin(), claims.end(), holds));
}

bool agrees(const std::vector<Claim>& claims) { return count_held(claims) == claims.size(); }

std::string verdict(const std::vector<Claim>& claims) {
    const std::size_t num_held = count_held(claims);
    if (num_held == claims.size()) return "Agrees: " + joined(claims, true) + ".";
    if (num_held == 0) return "Differs: " + joined(claims, false) + ".";
    return "Agrees in " + std::to_string(num_held) + " of " + std::to_string(claims.size()) + ": " +
           joined(claims, true) + ". Differs: " + joined(claims, false) + ".";
}

}  // namespace quadcut::reproduce
